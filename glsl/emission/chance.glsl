// A scene that does not say where its emitters are.
#include "emission/met.glsl"
#include "emission/unsought.glsl"
