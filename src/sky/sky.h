/* The sky of a picture: the GLSL files that it needs, their uniforms, and the table that holds it. */
#pragma once

#include "gl/resource.h"
#include "scene/glsl_slots.h"
#include "sky/frame.h"

/* The sine of the elevation of the observer's visible horizon, at most 0. */
double sky_horizon_sine(const Atmosphere *atmosphere);

/* The sine of the elevation at which the air ends, seen from above it; 1 from within. */
double sky_limb_sine(const Atmosphere *atmosphere);

/* Fills <sky>, <sums>, <absorber>, <gauss-nodes> and the slots of sky/sky_spectrum.h. Without ozone the files
 * leave it out. */
void sky_slots(SlotList *slots, const MethodChoice *choice, const Atmosphere *atmosphere);

/* Adds the uniforms of the sun, the air and the method. */
void sky_uniforms(const Frame *frame, Uniforms *uniforms);

/* Appends all that the sky depends on except the sun's azimuth: tables of the sky are turned to the azimuth
 * when they are read. */
void sky_key(const void *frame, Text *key);

/* The sums of the sky's radiance by direction: above the horizon in the first half of the rows and below it
 * in the second (glsl/sky/table.glsl). `frame` is a Frame. */
extern const ResourceKind sky_table;
