// For a film that counts the sunlight that is left to chance, which a path finds only by luck. See src/gl/film.h.
#include "math/finite.glsl"
#include "pass/film.glsl"
#include "pass/sun_disk.glsl"
#include "sun/count.glsl"

uniform sampler2D film_chance_sum;
uniform sampler2D film_squares_sum;

layout(location = 4) out vec4 film_chance_next;
layout(location = 5) out vec4 film_squares_next;

float chance_luminance(vec3 radiance) {
    return dot(radiance, vec3(0.2126, 0.7152, 0.0722));
}

// The materials are a set of bits and not a sum. A float holds all bits exactly. A group with a sample that is not finite is left out.
void film_chance() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 sum = texelFetch(film_chance_sum, pixel, 0);
    vec4 squares = texelFetch(film_squares_sum, pixel, 0);
    float light = chance_luminance(chance_near * sun_spread());
    vec3 group = vec3(chance_paths, light, chance_luminance(chance_found));
    bool finite = is_finite(group) && is_finite(chance_squares);
    vec4 next = vec4(sum.rgb + group, float(int(sum.a) | chance_materials));
    film_chance_next = finite ? next : sum;
    film_squares_next = finite ? vec4(squares.rgb + chance_squares, float(int(squares.a) | chance_met)) : squares;
}
