/* Reading of the command line. */
#pragma once

#include "cmd/options.h"

/* Reads the words after the program's name. Fails with STATUS_USAGE. Parsing ends at a word that asks for
 * help or the version: what follows is not looked at. */
MUST_CHECK bool options_parse(Options *options, int argc, char **argv, Error *error);
