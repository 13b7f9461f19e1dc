// What the host says of the atmosphere, for the sky methods that ask.
#include "sky/atmosphere.glsl"

uniform Atmosphere atmosphere;
uniform float observer_height_m;
uniform vec3 sun_direction; // toward the sun
