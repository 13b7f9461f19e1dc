// For a film that counts the steps of the scene's searches. See src/gl/film.h.
#include "pass/loops.glsl"
#include "shape/search.glsl"

uniform sampler2D film_search_sum;

layout(location = 3) out vec4 film_search_next;

void film_search() {
    vec4 group = vec4(search_rays, search_steps, search_broken, search_cut);
    film_search_next = texelFetch(film_search_sum, ivec2(gl_FragCoord.xy), 0) + group;
}
