/* Stands in for cmd_chart.c in a build without charts (CHART=0). */
#include "cmd/cmd.h"

Status cmd_chart(const Options *options, Error *error) {
    (void)options;
    error_set(error, STATUS_USAGE, "chart: this build draws no charts (CHART=0)");
    return error->status;
}
