// --light mis: bounces by the material and toward the bright sky together.
#include "light/bounce_sky.glsl"
#include "light/lambert.glsl"
#include "light/path.glsl"
