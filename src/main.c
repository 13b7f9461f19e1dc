#include "base/budget.h"
#include "base/descriptor.h"
#include "base/version.h"
#include "cmd/cmd.h"
#include "cmd/complete.h"
#include "cmd/completion_scripts.h"
#include "cmd/help.h"
#include "cmd/manual.h"
#include "cmd/options_check.h"
#include "cmd/options_parse.h"
#include "cmd/terminal.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The program's own words about itself. */
static Status answer(const Options *options) {
    Text text = {0};
    if (options->version)
        text_print(&text, "magichour " MAGICHOUR_VERSION "\n");
    else if (options->completion)
        text_print(&text, "%s", completion_script(options->completion));
    else if (options->manual)
        manual_print(&text);
    else
        help_print(options->command, terminal_columns(STDOUT_FILENO), &text);
    fputs(text_string(&text), stdout);
    text_free(&text);
    return STATUS_DONE;
}

static Status run(const Options *options, int argc, char **argv, Error *error) {
    switch (options->command) {
    case COMMAND_RENDER:
        return cmd_render(options, argc, argv, error);
    case COMMAND_VIEW:
        return cmd_view(options, error);
    case COMMAND_SWEEP:
        return cmd_sweep(options, argv, error);
    case COMMAND_MERGE:
        return cmd_merge(options, argc, argv, error);
    case COMMAND_COMPARE:
        return cmd_compare(options, error);
    case COMMAND_INFO:
        return cmd_info(options, error);
    case COMMAND_EXPORT:
        return cmd_export(options, argc, argv, error);
    case COMMAND_NEW:
        return cmd_new(options, error);
    case COMMAND_FLATTEN:
        return cmd_flatten(options, error);
    case COMMAND_SKY:
        return cmd_sky(options, argc, argv, error);
    case COMMAND_CHART:
        return cmd_chart(options, error);
    case COMMAND_EXPLAIN:
        return cmd_explain(options, error);
    case COMMAND_HELP:
    case COMMAND_VERSION:
    case COMMAND_NONE:
        break;
    }
    return STATUS_USAGE;
}

/* What the shells' completion scripts ask for. */
static int complete(int count, char **words) {
    Text text = {0};
    complete_print(count, words, &text);
    fputs(text_string(&text), stdout);
    text_free(&text);
    return STATUS_DONE;
}

/* Whether what was printed is lost. Then errno is the reason, or 0. */
static bool output_failed(void) {
    errno = 0;
    if (fflush(stdout) != 0) return true;
    if (!ferror(stdout)) return false;
    /* A write before this one failed, and its reason is gone. Another one fails for the same reason. */
    clearerr(stdout);
    fputc('\n', stdout);
    fflush(stdout);
    return true;
}

int main(int argc, char **argv) {
    Options options;
    Error error = {0};
    Status status;
    descriptor_fill_standard();
    /* A file that may grow no more is an error of writing. */
    signal(SIGXFSZ, SIG_IGN);
    if (argc > 2 && strcmp(argv[1], COMPLETE_WORD) == 0) return complete(argc - 2, argv + 2);
    if (!options_parse(&options, argc, argv, &error)) {
        status = error.status;
    } else if (options.help || options.version) {
        status = answer(&options);
    } else {
        options_warn(&options);
        budget_set(options.max_memory);
        status = run(&options, argc, argv, &error);
    }
    if (error.text[0] && status != STATUS_DONE) fprintf(stderr, "magichour: %s\n", error.text);
    if (output_failed() && status == STATUS_DONE) {
        fprintf(stderr, "magichour: standard output: cannot be written%s%s\n", errno ? ": " : "",
                errno ? strerror(errno) : "");
        status = STATUS_OUTPUT;
    }
    return (int)status;
}
