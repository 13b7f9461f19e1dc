// Paths alone: the sky is 1 everywhere.
#include "../inputs.glsl"
#include "sequence/random.glsl"
#include "sun/off.glsl"
#include "emission/none.glsl"
#include "mist/none.glsl"
#include "light/cosine.glsl"
#include "pass/sky_uniform.glsl"
#include "../crater.glsl"

void prepare_sky(vec3 sun) {
    sky_level = 1.0;
}
