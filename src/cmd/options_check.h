/* What options say together: two that contradict each other are an error, and one that has no effect beside
 * the others is a warning. */
#pragma once

#include "cmd/options.h"

/* STATUS_USAGE names the two that contradict each other. */
MUST_CHECK bool options_check(const Options *options, Error *error);

/* Warns on standard error of each option that changes nothing here, and says why. */
void options_warn(const Options *options);
