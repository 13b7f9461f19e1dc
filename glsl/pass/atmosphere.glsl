// What the host says of the atmosphere, for the sky methods that ask.
#include "pass/sun.glsl"
#include "sky/atmosphere.glsl"

uniform Atmosphere atmosphere;
uniform float observer_height_m;
