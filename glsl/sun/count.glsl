// What the paths of a pixel leave to chance. A pass adds it to the film after its rays.
#include "math/dialect.glsl"

// The number of materials that are counted separately. Materials with higher numbers count as the last of them.
const int CHANCE_MATERIALS = 20;

// The number of paths that left the scene on a ray whose sunlight is left to chance.
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
