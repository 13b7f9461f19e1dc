// For a film that counts the sunlight that is left to chance, which a path finds only by luck. See src/gl/film.h.
#include "pass/film.glsl"
#include "sun/count.glsl"

uniform sampler2D film_chance_sum;

layout(location = 4) out vec4 film_chance_next;

// The materials are a set of bits and not a sum. A float holds all bits exactly.
void film_chance() {
    vec4 sum = texelFetch(film_chance_sum, ivec2(gl_FragCoord.xy), 0);
    int materials = int(sum.a) | chance_materials;
    film_chance_next = vec4(sum.rgb + vec3(chance_paths, chance_light, chance_found), float(materials));
}
