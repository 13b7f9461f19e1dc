/* The sky of a pass: which GLSL files it needs, what they are told, and the table, filled when something that
 * it depends on has changed, and only then. */
#pragma once

#include "choice/method.h"
#include "gl/program.h"
#include "scene/atmosphere.h"
#include "scene/sun.h"

/* Where the sun is and the air that it shines through. */
typedef struct SkyState {
    Atmosphere atmosphere;
    Sun sun;
} SkyState;

/* Whether a table made for one state serves the other: tables are turned with the sun's azimuth when they are
 * read. */
bool sky_state_serves(const SkyState *made_for, const SkyState *state);

/* Sine of the elevation of the observer's visible horizon, at most 0. */
double sky_horizon_sine(const Atmosphere *atmosphere);

enum { SKY_SLOTS = 4 };

typedef struct Sky {
    const GlApi *gl;
    MethodChoice choice;
    Program fill; /* of the table; empty without one */
    GLuint texture[2], framebuffer;
    int columns, rows; /* the table's size, a half */
    SkyState filled_for;
    int fills; /* how often the table was filled */
} Sky;

/* Fills slots[0 .. SKY_SLOTS) for glsl_source_create: <sky>, <sums>, <absorber>, <gauss-nodes>. `text` holds
 * what they refer to. What the atmosphere lacks (ozone 0) is not in the files. */
typedef struct SkySlotText {
    char nodes[48];
} SkySlotText;
void sky_slots(const MethodChoice *choice, const Atmosphere *atmosphere, GlslSlot *slots, SkySlotText *text);

MUST_CHECK bool sky_create(Sky *sky, const Context *context, const char *library, const MethodChoice *choice,
                           const Atmosphere *atmosphere, Error *error);
void sky_destroy(Sky *sky);

/* Makes the sky ready for this state and tells `program` (which becomes the program in use). The framebuffer
 * that is bound changes when a table is filled. Whether there is ozone must be as at sky_create. */
MUST_CHECK bool sky_use(Sky *sky, const Program *program, const SkyState *state, Error *error);

/* Puts the table on its texture units, where something else may have been bound since. */
void sky_bind(const Sky *sky);
