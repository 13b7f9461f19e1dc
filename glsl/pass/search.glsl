// A film that counts what the scene's searches took. See src/gl/film.h.
#include "shape/search.glsl"

uniform sampler2D film_search_sum;
uniform int search_turns; // 2, which the compiler cannot know

layout(location = 3) out vec4 film_search_next;

void film_search() {
    vec4 group = vec4(search_rays, search_steps, search_broken, search_cut);
    film_search_next = texelFetch(film_search_sum, ivec2(gl_FragCoord.xy), 0) + group;
}

// Whether the driver has put an end to all loops, as llvmpipe does after 65,535 iterations, and without a word: a field may
// have loops of its own, which nobody counted.
bool search_ended() {
    int turns = 0;
    do {
        turns += 1;
    } while (turns < search_turns);
    return turns < search_turns;
}
