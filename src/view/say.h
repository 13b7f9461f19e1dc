/* Reports in the window and on standard error. */
#pragma once

#include "view/state.h"

void say_failure(ViewState *state, const Error *error);

/* Does the same once: the sun of a day that plays may be refused in every turn. */
void say_refusal(ViewState *state, const Error *refusal);
