// A film that counts what the scene's searches took. See src/gl/film.h.
#include "shape/search.glsl"

uniform sampler2D film_search_sum;

layout(location = 3) out vec4 film_search_next;

void film_search() {
    vec4 group = vec4(search_rays, search_steps, search_broken, search_cut);
    film_search_next = texelFetch(film_search_sum, ivec2(gl_FragCoord.xy), 0) + group;
}

// Whether the driver has put an end to all loops, as llvmpipe does after 65,535 iterations, and without a word: a field may
// have loops of its own, which nobody counted. A loop of eight turns tells: llvmpipe grants it one or two. The compiler must
// not know that they are eight, and it knows uniforms in a loop's condition; nor that a loop ends as its condition says.
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
