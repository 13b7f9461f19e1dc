/* The sun's disk in a picture: which GLSL files it needs, what these are told, and where in the picture its
 * own image may be. */
#pragma once

#include "sky/sky.h"

enum { MOST_SUN_RECTANGLES = 1 + MOST_HINTS };

/* The disk's radiance along its height (glsl/pass/sun_disk.glsl). */
extern const ResourceKind sun_table;

/* The mean radiance that the unblocked disk brings to each pixel of a rectangle. */
extern const ResourceKind sun_cover;

/* The pixels that may hold the disk's own image. */
typedef struct SunImage {
    /* They may overlap. */
    Rectangle rectangles[MOST_SUN_RECTANGLES];
    int count;
} SunImage;

/* The method that `text` names, NULL for what the scene says; "off" where the disk has set. */
MUST_CHECK bool sun_choose(MethodChoice *choice, const char *text, const Scene *scene, Error *error);

/* Fills <sun>, <sun-image>, <mirrors>, <mirrors-image> and <planes>. `image`: for the program that draws the
 * disk's image. */
void sun_slots(SlotList *slots, const MethodChoice *choice, const Scene *scene, bool image);

/* Where the picture of this frame may hold the image: nowhere, where the method does not draw it. */
SunImage sun_image(const Frame *frame);
