/* Stands in for cmd_view.c in a build without the window (WINDOW=0). */
#include "cmd/cmd.h"

Status cmd_view(const Options *options, Error *error) {
    (void)options;
    error_set(error, STATUS_USAGE, "view: this build has no window (WINDOW=0)");
    return error->status;
}
