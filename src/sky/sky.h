/* The sky of a picture: the GLSL files that it needs, their uniforms, and the table that holds it. */
#pragma once

#include "gl/resource.h"
#include "sky/frame.h"
#include "sky/observer.h"
#include "source/glsl_slots.h"

/* Fills <sky>, <sums>, <absorber>, <gauss-nodes> and the slots of sky/sky_spectrum.h. Without ozone the files
 * leave it out. */
void sky_slots(SlotList *slots, const MethodChoice *choice, const Atmosphere *atmosphere);

/* Adds the uniforms of the sun, the air and the method. */
void sky_uniforms(const Frame *frame, Uniforms *uniforms);

/* The sums of the sky's radiance by direction: above the horizon in the first half of the rows and below it
 * in the second (glsl/sky/table.glsl). `frame` is a Frame. */
extern const ResourceKind sky_table;
