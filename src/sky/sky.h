/* The sky of a picture: which GLSL files it needs, what these are told, and the table that holds it. */
#pragma once

#include "gl/resource.h"
#include "scene/glsl_slots.h"
#include "sky/frame.h"

/* Sine of the elevation of the observer's visible horizon, at most 0. */
double sky_horizon_sine(const Atmosphere *atmosphere);

/* Fills <sky>, <sums>, <absorber> and <gauss-nodes>. What the atmosphere lacks (ozone 0) is not in the files.
 */
void sky_slots(SlotList *slots, const MethodChoice *choice, const Atmosphere *atmosphere);

/* What programs are told of the sun, the air and the method. */
void sky_uniforms(const Frame *frame, Uniforms *uniforms);

/* Appends what the sky depends on, but for the sun's azimuth: tables of it are turned with the azimuth when
 * they are read. */
void sky_key(const void *frame, Text *key);

/* The sky's sums over direction, above the horizon in the first half of the rows and below it in the second
 * (glsl/sky/table.glsl). `frame` is a Frame. */
extern const ResourceKind sky_table;
