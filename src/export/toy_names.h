/* The names of a scene that something else has on Shadertoy. */
#pragma once

#include "scene/scene_file.h"
#include "source/glsl_tokens.h"
#include "source/text_edits.h"

/* What stands around the scene. */
typedef struct ToyNames {
    const SceneFile *file;
    const GlslSource *source;
    const GlslTokens *tokens;
    /* GLSL whose names outside of functions the scene must not have. */
    const char *others;
} ToyNames;

/* Adds the edits by which a scene's name gets "own_" in front of it that is one of Shadertoy's, a word of
 * GLSL ES, or one of the other texts'. Shadertoy's inputs become the variables scene_NAME, because the tab
 * Common has no inputs. STATUS_SCENE with the place names a function of the scene that GLSL ES has, which
 * cannot have a second one. */
MUST_CHECK bool toy_names_put(const ToyNames *names, TextEdits *edits, Error *error);

/* Whether the text has the input as a uniform. */
bool toy_names_has_input(const GlslTokens *tokens, const char *input);

/* Shadertoy's inputs that a scene may have; ends with NULL. */
extern const char *const toy_inputs[];
