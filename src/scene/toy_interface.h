/* What a Shadertoy program or another fragment shader has in common with the outside: the uniforms that it
 * declares, the variables that it writes, and its entry function. */
#pragma once

#include "scene/scene_file.h"
#include "source/glsl_tokens.h"
#include "source/text_edits.h"

typedef struct ToyInterface {
    const SceneFile *file;
    /* The text that has the file in it, and its tokens. */
    const GlslSource *source;
    const GlslTokens *tokens;
    /* Gets the changes. */
    TextEdits *edits;
    /* The statements that run the file, and what it will not get, a line each. */
    Text call, notes;
    /* The names of Shadertoy's inputs that the file has for something else. */
    Names taken;
    /* How many notes there are; no more than a few are kept. */
    int note_count;
    bool has_main, renames_time;
    /* The variable that main() writes, and what makes a colour of it. */
    char output[80], output_type[16];
} ToyInterface;

/* Sets `call` and `notes`, and adds to `edits`. STATUS_SCENE with the place for what this program has not. */
MUST_CHECK bool toy_interface_read(ToyInterface *interface, Error *error);
void toy_interface_free(ToyInterface *interface);
