/* The sky's colours in a picture: the GLSL files of atmosphere.spectrum, and their uniforms. */
#pragma once

#include "gl/uniforms.h"
#include "scene/atmosphere.h"
#include "source/glsl_slots.h"

/* Fills <spectrum>, <bands>, <sums-add>, <light-sums>, <shade> and <root>. */
void sky_spectrum_slots(SlotList *slots, const Atmosphere *atmosphere);

/* Adds the uniforms of the file that is in the slot <spectrum>. */
void sky_spectrum_uniforms(const Atmosphere *atmosphere, Uniforms *uniforms);
