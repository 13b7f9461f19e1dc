// --sun-disk chance
#include "pass/sun_disk.glsl"
#include "sun/chance.glsl"
