/* Mist between a scene's surfaces, as its annotation says it:
 * `//@ mist extinction 0.05 albedo 0.9 0.9 0.9 g 0.6 sphere 0 0 0 8`. */
#pragma once

#include "base/text.h"

#include <stdbool.h>

/* The annotation's words, each a number or a slider's name. Where MistWord names the first of several, the
 * others follow. */
typedef enum MistWord {
    /* 1/m. Where it has no colour, the second and the third are empty. */
    MIST_EXTINCTION,
    MIST_ALBEDO = MIST_EXTINCTION + 3,
    MIST_FORWARD = MIST_ALBEDO + 3,
    /* m */
    MIST_FALLOFF,
    MIST_BASE,
    /* A sphere's centre and radius, a box's centre and half size, or a height, m. */
    MIST_REGION,
    MIST_WORDS = MIST_REGION + 6
} MistWord;

typedef enum MistShape { MIST_EVERYWHERE, MIST_SPHERE, MIST_BOX, MIST_BELOW } MistShape;

typedef struct Mist {
    /* 0 where the scene has none. */
    int line;
    /* Those that the annotation does not give have their defaults, or are empty. */
    char words[MIST_WORDS][64];
    MistShape shape;
    /* Whether it thins with height. */
    bool falls;
    /* Whether its phase function is that of Cornette and Shanks, in place of Henyey and Greenstein's. */
    bool shanks;
    /* The parameter that switches it on and off. */
    int parameter;
} Mist;

/* Whether its extinction has a colour: three words that are not all the same. */
bool mist_is_coloured(const Mist *mist);

/* Writes the functions of glsl/mist/values.glsl. */
void mist_write(const Mist *mist, Text *text);

/* Appends the annotation, with the defaults of what it does not say. */
void mist_describe(const Mist *mist, Text *text);
