/* Reads the command line. */
#pragma once

#include "cmd/options.h"

/* Reads the words after the program's name. Fails with STATUS_USAGE. Reading ends at a word for help or the
 * version, and what follows is ignored. */
MUST_CHECK bool options_parse(Options *options, int argc, char **argv, Error *error);
