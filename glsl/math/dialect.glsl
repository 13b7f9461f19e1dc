// These macros let a GLSL driver and a C++ compiler (with GLM, in float and in double) compile the same file.
// Library files keep to what all of them accept: `2.0`, never `2` or `2.0f`; vec2(v.x, v.z), never a swizzle such as v.xz; no array
// constructors; and these macros for parameter qualifiers.
// assert() says what a function relies on. It does nothing on the GPU. In C++ it is checked, and tests/oracle/glsl.hpp defines the macros.
#ifndef INOUT
#define IN(T) in T
#define OUT(T) out T
#define INOUT(T) inout T
#define assert(condition)
#endif

const float PI = 3.14159265358979;
// This is farther than any hit. It is finite, because 0 * infinity is not a number.
const float INFINITY = 1.0e30;
