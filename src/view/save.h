/* What the window shows, as files. */
#pragma once

#include "view/pane.h"

typedef struct SaveParams {
    const Pane *sides[MOST_SIDES]; /* the second NULL where there is one picture */
    double divider;
    double difference;  /* radiance at the ends of the false colours; 0 shows the sides */
    const Scene *scene; /* of the first side */
    const Context *context;
    int max_hits;
    /* NULL where the GLSL library is the one beside the program. */
    const char *glsl_dir;
} SaveParams;

/* The first of NAME-001, NAME-002 ... in the working folder of which there is neither EXR nor PNG, NAME after
 * the scene's file. */
void save_choose_name(const Scene *scene, char *name, size_t size);

/* A texture that holds a picture as a screen shows it, row 0 at its bottom: the EXR gets it in linear light.
 */
MUST_CHECK bool save_texture(const Target *target, const char *path, const char *name, bool exr,
                             Error *error);

/* Writes NAME.exr and NAME.png, or only the latter. Of two sides the picture holds what is shown of each, or
 * left less right where the difference is shown, in false colours in the PNG; the EXR has both sides whole as
 * layers `left` and `right`. The metadata has the `render` command that makes the (first) picture again. */
MUST_CHECK bool save_picture(const SaveParams *params, const char *name, bool exr, Error *error);
