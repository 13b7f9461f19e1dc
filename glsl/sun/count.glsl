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
// A bit for each material that threw some of that light.
int chance_materials = 0;
