// What the paths of a pixel leave to chance, for a pass to read after its rays, and to tell the user.
#include "math/dialect.glsl"

// Materials that are told apart; what has a higher number counts as the last of them.
const int CHANCE_MATERIALS = 20;

// Paths that left the scene on a ray whose sunlight is found by chance alone.
float chance_paths = 0.0;
// The luminance that these paths are expected to bring from the sun.
float chance_light = 0.0;
// The luminance that they did bring.
float chance_found = 0.0;
// A bit for each material that threw some of that light.
int chance_materials = 0;

float chance_luminance(vec3 radiance) {
    return dot(radiance, vec3(0.2126, 0.7152, 0.0722));
}
