// --sun-disk sampled
#include "pass/sun_disk.glsl"
#include "sun/sampled.glsl"
