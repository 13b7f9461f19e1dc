// The film's part of a pass: it adds one group of samples to each pixel. See src/gl/film.h for what the textures hold.
#include "math/finite.glsl"
#include "pass/film_samples.glsl"

// It is 0, but the compiler cannot see that.
uniform uint film_zero;

layout(location = 0) out vec4 film_sum_next;
layout(location = 1) out vec4 film_rest_next;

// Returns the same number in a way that a compiler cannot see through. Otherwise it might simplify (a + b) - a to b, and the amount
// that an addition rounds away would be lost.
vec3 film_opaque(vec3 v) {
    return uintBitsToFloat(floatBitsToUint(v) ^ uvec3(film_zero));
}

// `group` is the sum of the radiances of the accepted samples, and in alpha their number. A group that would make the pixel's sum too
// large for a float is left out, and counts as rejected. Returns whether it was added.
bool film_add(vec4 group, float rejected) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 sum = texelFetch(film_sum, pixel, 0);
    vec4 rest = texelFetch(film_rest, pixel, 0);
    // Knuth's exact sum: next + lost equals sum + group to the last bit. What was lost is added to the rest, and the rest goes back
    // into the sum as far as the sum has digits for it (Dekker). Otherwise the rest would grow and lose digits itself.
    vec3 next = film_opaque(sum.rgb + group.rgb);
    vec3 added = film_opaque(next - sum.rgb);
    vec3 lost = (sum.rgb - film_opaque(next - added)) + (group.rgb - added);
    vec3 small = rest.rgb + lost;
    vec3 total = film_opaque(next + small);
    bool fits = is_finite(total);
    film_sum_next = fits ? vec4(total, sum.a + group.a) : sum;
    film_rest_next =
        fits ? vec4(small - film_opaque(total - next), rest.a + rejected) : vec4(rest.rgb, rest.a + rejected + group.a);
    return fits;
}
