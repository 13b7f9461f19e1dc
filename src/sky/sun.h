/* The sun's disk in a picture: the GLSL files that it needs, their uniforms, and the pixels that may hold its
 * image. */
#pragma once

#include "sky/sky.h"

enum { MOST_SUN_RECTANGLES = 1 + MOST_HINTS };

/* The disk's radiance by height (glsl/pass/sun_disk.glsl). */
extern const ResourceKind sun_table;

/* The mean radiance that the unblocked disk gives each pixel of a rectangle. */
extern const ResourceKind sun_cover;

/* The pixels that may hold the disk's own image. */
typedef struct SunImage {
    /* The rectangles may overlap. */
    Rectangle rectangles[MOST_SUN_RECTANGLES];
    int count;
} SunImage;

/* Chooses the method that `text` names, or the scene's where `text` is NULL. "auto" is "traced" where the
 * scene may throw sunlight that rays to the sun do not find, and "sampled" elsewhere. It is "off" where the
 * disk has set. */
MUST_CHECK bool sun_choose(MethodChoice *choice, const char *text, const Scene *scene, Error *error);

/* Fills <sun>, <sun-image>, <mirrors>, <mirrors-image> and <planes>. */
void sun_slots(SlotList *slots, const MethodChoice *choice, const Scene *scene);

/* The pixels of this frame that may hold the disk's image; none if the method has no disk. */
SunImage sun_image(const Frame *frame);

/* Sets `mask`, one byte for each pixel of a picture of this width, to 1 in these pixels. */
void sun_image_pixels(const SunImage *image, int width, unsigned char *mask);
