/* Leaves out branches that a text never takes. The library asks for what a scene has, such as mist, by
 * functions that return true or false: a compiler sees through them, and here they are seen through for
 * readers. */
#pragma once

#include "source/glsl_source.h"

/* Puts the values of the library's functions `bool NAME() { return true; }` and constants `const bool NAME =
 * true;` in place of their uses, and simplifies `if`, `?:`, `&&`, `||` and `!` by them, in the library's
 * files alone. The text computes the same. `library` is the folder of the library. */
void fold(GlslSource *source, const char *library);
