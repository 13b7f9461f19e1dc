/* Command lines: a word a line. */
#include "fuzz/input.h"

#include "cmd/options_parse.h"

#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    enum { MOST = 64 };
    Text text = input_text(data, size);
    char *words[MOST + 2] = {(char[]){"magichour"}}, *at = text.data;
    int count = 1;
    Options options;
    Error error;
    for (char *word; count <= MOST && (word = strsep(&at, "\n"));) words[count++] = word;
    (void)!options_parse(&options, count, words, &error);
    text_free(&text);
    return 0;
}
