#include "base/version.h"
#include "cmd/cmd.h"
#include "cmd/help.h"
#include "cmd/options_parse.h"
#include "cmd/terminal.h"

#include <stdio.h>
#include <unistd.h>

/* The program's own words about itself. */
static Status answer(const Options *options) {
    Text text = {0};
    if (options->version)
        text_print(&text, "magichour " MAGICHOUR_VERSION "\n");
    else if (options->manual)
        help_print_manual(&text);
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
    case COMMAND_COMPARE:
        return cmd_compare(options, error);
    case COMMAND_INFO:
        return cmd_info(options, error);
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

int main(int argc, char **argv) {
    Options options;
    Error error = {0};
    Status status;
    if (!options_parse(&options, argc, argv, &error)) {
        status = error.status;
    } else if (options.help || options.version) {
        status = answer(&options);
    } else {
        status = run(&options, argc, argv, &error);
    }
    if (error.text[0] && status != STATUS_DONE) fprintf(stderr, "magichour: %s\n", error.text);
    if ((fflush(stdout) != 0 || ferror(stdout)) && status == STATUS_DONE) {
        fputs("magichour: standard output: cannot be written\n", stderr);
        status = STATUS_OUTPUT;
    }
    return (int)status;
}
