// --light mis
#include "pass/sky_sampler.glsl"
#include "light/mis.glsl"
