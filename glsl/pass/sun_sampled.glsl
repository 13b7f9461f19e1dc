// --sun-disk sampled
#include "pass/sun_disk.glsl"
#include "sun/share_whole.glsl"
#include "sun/sampled.glsl"
