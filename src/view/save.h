/* Saves what the window shows as files. */
#pragma once

#include "view/pane.h"

typedef struct SaveParams {
    /* The second is NULL if there is one picture. */
    const Pane *sides[MOST_SIDES];
    double divider;
    /* The radiance at the ends of the false colours. 0 means that the sides are shown. */
    double difference;
    /* The scene of the first side. */
    const Scene *scene;
    const Context *context;
    int max_hits;
    /* NULL where the GLSL library is the one beside the program. */
    const char *glsl_dir;
} SaveParams;

/* Chooses the first name of NAME-001, NAME-002 ... for which the working folder has neither an EXR nor a PNG.
 * NAME is that of the scene's file. */
void save_choose_name(const Scene *scene, char *name, size_t size);

/* Saves a texture that holds a picture as a screen shows it. Its row 0 is at the bottom. The EXR has the
 * same numbers. */
MUST_CHECK bool save_texture(const Target *target, const char *path, const char *name, bool exr,
                             Error *error);

/* Writes NAME.png, and NAME.exr if `exr` is set.
 *
 * If there are two sides, the picture has the shown part of each, and the EXR also has both complete sides as
 * layers `left` and `right`. If the difference is shown, the picture is left minus right, in false colours in
 * the PNG. The metadata have the `render` command that makes the (first) picture again. */
MUST_CHECK bool save_picture(const SaveParams *params, const char *name, bool exr, Error *error);
