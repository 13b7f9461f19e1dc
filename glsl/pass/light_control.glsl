// --light control
#include "pass/irradiance.glsl"
#include "light/control.glsl"
