// Bounces in the directions that the material draws.
#include "light/memory_none.glsl"

Bounce path_bounce(INOUT(PathMemory) memory, Path path, Hit hit, Material material, vec2 u, vec2 v) {
    return material_sample(material, hit.normal, path.ray.direction, u, v);
}

float path_pdf(PathMemory memory, Path path, Hit hit, Material material, vec3 direction) {
    return material_pdf(material, hit.normal, path.ray.direction, direction);
}
