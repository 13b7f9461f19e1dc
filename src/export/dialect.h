/* The library's macros (glsl/math/dialect.glsl) are for compilers of C++, too. In a text for people GLSL's
 * own words stand in their place. */
#pragma once

#include "source/glsl_source.h"

/* Writes `inout T` for INOUT(T) and its like, and takes assert() and the macros themselves away. Where the
 * user's macros use them, they stay. */
void dialect_expand(GlslSource *source);
