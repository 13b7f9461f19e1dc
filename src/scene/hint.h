/* Hints: what a scene says about itself so that light is found sooner. They change no picture's mean. */
#pragma once

/* The bounds of what may block the sky, the mirrors, and what emits light. */
typedef enum HintKind {
    HINT_BOUND,
    HINT_MIRROR_SPHERE,
    HINT_MIRROR_PLANE,
    HINT_EMITTER_SPHERE,
    HINT_KINDS
} HintKind;

typedef struct HintInfo {
    /* The annotation's key. */
    const char *key;
    /* What the annotation needs, for errors. */
    const char *needs;
    /* How many numbers make one hint: 4 are a sphere's x, y, z and radius in metres, 2 are the azimuth and
     * the elevation in degrees that a flat mirror faces. */
    int components;
    /* The GLSL constant that holds their number, and the function of an int that returns one of them. */
    const char *constant, *function;
} HintInfo;

const HintInfo *hint_info(HintKind kind);

enum { MOST_HINTS = 16 };

/* One annotation: each word is a number or a slider's name, which may have a minus before it. */
typedef struct Hint {
    char words[4][64];
    int line;
} Hint;

typedef struct HintList {
    Hint list[MOST_HINTS];
    int count;
} HintList;
