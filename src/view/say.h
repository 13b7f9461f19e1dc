/* Reports in the window and on standard error. */
#pragma once

#include "render/check.h"
#include "view/state.h"

void say_failure(ViewState *state, const Error *error);

/* Does the same once: the sun of a day that plays may be refused in every turn. */
void say_refusal(ViewState *state, const Error *refusal);

/* Says on standard error what is wrong with the values of the scene at this path. The panel says it too. */
void say_check(const Check *check, const char *path);
