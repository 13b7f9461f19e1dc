/* Hints: what a scene says about itself so that light is found sooner. They change no picture's mean.
 *
 * A scene says them by annotations, `//@ mirror-sphere 0 1 0 0.5`, or defines the constant and the function
 * that such annotations stand for: `const int MIRROR_SPHERES = 1; vec4 mirror_sphere(int i) { ... }`. */
#pragma once

#include "base/text.h"

#include <stdbool.h>

/* The bounds of what may block the sky, the mirrors, what emits light, and the openings to the sky. */
typedef enum HintKind {
    HINT_BOUND,
    HINT_MIRROR_SPHERE,
    HINT_MIRROR_PLANE,
    HINT_EMITTER_SPHERE,
    HINT_PORTAL,
    HINT_KINDS
} HintKind;

typedef struct HintInfo {
    /* The annotation's key. */
    const char *key;
    /* What the annotation needs, for errors. */
    const char *needs;
    /* How many numbers make one hint: 4 are a sphere's x, y, z and radius in metres, 2 are the azimuth and
     * the elevation in degrees that a flat mirror faces, 7 are a portal's x, y, z in metres, the two angles
     * that it faces, and its width and height in metres. */
    int components;
    /* The first of them that must be above 0, a length; those behind it must be too. */
    int lengths_from;
    /* The GLSL constant that holds their number, and the function of an int that returns one of them. */
    const char *constant, *function;
    /* What the function returns, and the GLSL function that makes it from the numbers. */
    const char *type, *maker;
    /* What hints of the kind cost at a hit that looks for them: rays, and iterations of loops beside those of
     * the rays, for all of them and for each. */
    int rays, loops, loops_each;
} HintInfo;

const HintInfo *hint_info(HintKind kind);

enum { MOST_HINTS = 16, MOST_HINT_NUMBERS = 7 };

/* One annotation: each word is a number or a slider's name, which may have a minus before it. */
typedef struct Hint {
    char words[MOST_HINT_NUMBERS][64];
    int line;
} Hint;

typedef struct HintList {
    int count;
    /* Whether the scene defines the function itself; then the list is empty. */
    bool in_glsl;
    Hint list[MOST_HINTS];
} HintList;

/* Whether two hints of a kind are the same for all values of the sliders: their words are the same numbers or
 * the same sliders. */
bool hint_same(HintKind kind, const Hint *a, const Hint *b);

/* Writes the kind's constant and function for the annotations of a list. */
void hint_write(HintKind kind, const HintList *hints, Text *text);
