// The words that let one file be compiled by a GLSL driver and, through GLM, as C++ in float and in double.
// Library files keep to what all of them accept: `2.0` and never `2` or `2.0f`, no swizzles (vec2(v.x, v.z), not v.xz),
// no array constructors, and these macros for parameter qualifiers. assert() says what a function relies on: nothing on
// the GPU, checked in C++, which brings its own words (tests/oracle/glsl.hpp).
#ifndef INOUT
#define IN(T) in T
#define OUT(T) out T
#define INOUT(T) inout T
#define assert(condition)
#endif

const float PI = 3.14159265358979;
const float INFINITY = 1.0e30; // farther than any hit; finite, because 0 * inf is not a number
