// A path on its way through the scene, and the functions that a light method defines about it. light/path.glsl holds the loop that
// calls them.
#include "light/surface.glsl"
#include "sun/ask.glsl"

struct Path {
    // The ray that looks for the next hit.
    Ray ray;
    // What light that comes back along the ray is worth in the pixel.
    vec3 throughput;
    // Radiance that the hits so far brought to the pixel.
    vec3 gathered;
    // Number of hits so far.
    int hits;
    // What the path knows about the sun's disk.
    SunState sun;
    // Share of the light emitted at the next hit that the ray counts. Lamps that are sampled have counted the rest.
    float lamp_share;
    // The light that comes from the ray's end, over the probability that the path goes on there. 1 but for coloured mist.
    vec3 weight;
    // Whether the last ray left the scene.
    bool escaped;
    // What the next ray's searches are told: see scene.glsl.
    float spread;
    int leaves;
};

// The spread of a path's rays after a bounce of this density, 1/sr. A cone of the half angle a covers about pi a^2. A mirror, of density 0, leaves the
// spread as it is.
float path_spread(float spread, float pdf) {
    float wide = min(inversesqrt(PI * max(pdf, 1.0e-20)), 1.0);
    float wider = max(spread, wide);
    return pdf > 0.0 ? wider : spread;
}

// A method defines `struct PathMemory`, which holds what it remembers from hit to hit, and five functions about it:
//
//     PathMemory path_start()
//         The memory of a path that has no hit yet.
//     Bounce path_bounce(INOUT(PathMemory) memory, Path path, Hit hit, Material material, vec2 u, vec2 v)
//         Draws the direction in which the path goes on from `hit`. `path` is as it came: `path.hits` does not count this hit.
//     float path_pdf(PathMemory memory, Path path, Hit hit, Material material, vec3 direction)
//         The density, 1/sr, with which the path_bounce() just called takes a direction.
//     void path_after(INOUT(PathMemory) memory, Path path, bool alive)
//         Called when the bounce is done: `path` is at the start of its next ray, or was ended by Russian roulette.
//     vec3 path_finish(PathMemory memory, Path path, vec3 disk)
//         The radiance of the whole path: what it gathered, and what the sky and the sun's disk, of radiance `disk`, bring. It is called after the loop,
//         where neighbouring pixels look the sky up together.
