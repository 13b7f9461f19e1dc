// For a film that counts the steps of the scene's searches. See src/gl/film.h.
#include "shape/search.glsl"

uniform sampler2D film_search_sum;

layout(location = 3) out vec4 film_search_next;

void film_search() {
    vec4 group = vec4(search_rays, search_steps, search_broken, search_cut);
    film_search_next = texelFetch(film_search_sum, ivec2(gl_FragCoord.xy), 0) + group;
}

// Whether the driver has ended all loops. llvmpipe does so after 65,535 iterations and reports nothing, and a field may have loops
// of its own that nobody counted. The test is a loop of eight turns, of which llvmpipe then grants only one or two. The compiler
// must not be able to compute the number of turns: neither from a uniform in the loop's condition, which it can see through, nor
// from the condition after the loop.
bool search_ended() {
    int wanted = 8 + min(search_rays, 0);
    int turns = 0;
    float counted = 0.0;
    do {
        turns += 1;
        counted += 1.0;
    } while (turns < wanted);
    return counted < 7.5;
}
