// What the paths of a pixel leave to chance. A pass adds it to the film after its rays.
#include "math/dialect.glsl"

// The number of materials that are counted separately. Materials with higher numbers count as the last of them.
const int CHANCE_MATERIALS = 20;

// The number of paths that left the scene on a ray whose sunlight is left to chance.
float chance_paths = 0.0;
// What those of them that met the cone about the sun bring of its radiance.
vec3 chance_near = vec3(0.0);
// The radiance of the sun that these paths brought.
vec3 chance_found = vec3(0.0);
// A bit for each material that threw some of that light, and the bit CHANCE_IMAGE if the sun itself was seen in mirrors or glass.
int chance_materials = 0;
const int CHANCE_IMAGE = CHANCE_MATERIALS;
// The expected square of the radiance that chance brings, summed over the paths and averaged over the channels. A material's number
// modulo 3 says in which component its light is.
vec3 chance_squares = vec3(0.0);
// A bit for each material whose light some path has found.
int chance_met = 0;

int chance_bit(int material) {
    return 1 << min(material, CHANCE_MATERIALS - 1);
}
