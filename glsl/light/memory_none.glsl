// A light method that remembers nothing from hit to hit. What the sky and the sun's disk bring is what the last ray meets.
#include "light/walk.glsl"
#include "math/finite.glsl"

// GLSL has no empty structs.
struct PathMemory {
    bool unused;
};

PathMemory path_start() {
    return PathMemory(false);
}

void path_after(INOUT(PathMemory) memory, Path path, bool alive) {
}

// A path that ended in the scene brings no sky, unless the sky's value is not finite: such a sample must be seen and counted.
vec3 path_finish(PathMemory memory, Path path, vec3 disk) {
    vec3 brought = path.throughput * (sky_radiance(path.ray.direction) + disk);
    vec3 radiance = path.gathered;
    if (path.escaped || !is_finite(brought)) radiance += brought;
    return radiance;
}
