// --sun-disk traced
#include "pass/sun_disk.glsl"
#include "pass/aim.glsl"
#include "sun/share_traced.glsl"
#include "sun/sampled.glsl"
