#include "view/say.h"

#include <stdio.h>
#include <string.h>

void say_failure(ViewState *state, const Error *error) {
    view_failure(state, error->text);
    fprintf(stderr, "magichour: %s\n", error->text);
}

void say_refusal(ViewState *state, const Error *refusal) {
    const Notice *notice = &state->notice;
    bool said = notice->failed && strncmp(notice->text, refusal->text, sizeof notice->text - 1) == 0;
    if (!said) say_failure(state, refusal);
}

void say_check(const Check *check, const char *path) {
    Text lines = {0};
    check_print(check, path, &lines);
    fputs(text_string(&lines), stderr);
    text_free(&lines);
}
