// For a film that counts the sunlight that is left to chance, which a path finds only by luck. See src/gl/film.h.
#include "math/finite.glsl"
#include "pass/film.glsl"
#include "pass/sun_disk.glsl"
#include "sun/count.glsl"

uniform sampler2D film_chance_sum;

layout(location = 4) out vec4 film_chance_next;

float chance_luminance(vec3 radiance) {
    return dot(radiance, vec3(0.2126, 0.7152, 0.0722));
}

// The materials are a set of bits and not a sum. A float holds all bits exactly. A group with a sample that is not finite is left out.
void film_chance() {
    vec4 sum = texelFetch(film_chance_sum, ivec2(gl_FragCoord.xy), 0);
    int materials = int(sum.a) | chance_materials;
    float light = chance_luminance(chance_near * sun_spread());
    vec3 group = vec3(chance_paths, light, chance_luminance(chance_found));
    film_chance_next = is_finite(group) ? vec4(sum.rgb + group, float(materials)) : sum;
}
