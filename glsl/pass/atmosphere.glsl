// The atmosphere's values from the host, for the sky methods that need them.
#include "pass/sun.glsl"
#include "sky/atmosphere.glsl"

uniform Atmosphere atmosphere;
uniform float observer_height_m;
