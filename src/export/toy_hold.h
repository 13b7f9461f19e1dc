/* What Shadertoy's texts cannot hold. */
#pragma once

#include "render/plan.h"
#include "source/glsl_tokens.h"

/* Refuses what would be drawn differently, with the reason, the place, and what to leave out. What an option
 * asked for is STATUS_USAGE, what the scene asks for is STATUS_SCENE. */
MUST_CHECK bool toy_hold_plan(const Plan *plan, const RenderParams *params, Error *error);

/* Refuses a text that still looks a table up. */
MUST_CHECK bool toy_hold_text(const GlslTokens *tokens, const RenderParams *params, Error *error);
