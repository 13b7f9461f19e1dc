/* The commands. Each puts the other parts of the program together for one word of the command line. */
#pragma once

#include "cmd/options.h"

/* Each returns the exit status for success (0, 6, 130), or sets the error and returns its status. */
Status cmd_render(const Options *options, int argc, char **argv, Error *error);
Status cmd_view(const Options *options, Error *error);
Status cmd_merge(const Options *options, int argc, char **argv, Error *error);
Status cmd_sweep(const Options *options, char **argv, Error *error);
Status cmd_compare(const Options *options, Error *error);
Status cmd_info(const Options *options, Error *error);
Status cmd_export(const Options *options, int argc, char **argv, Error *error);
Status cmd_new(const Options *options, Error *error);
Status cmd_flatten(const Options *options, Error *error);
Status cmd_sky(const Options *options, int argc, char **argv, Error *error);
Status cmd_chart(const Options *options, Error *error);
Status cmd_explain(const Options *options, Error *error);
