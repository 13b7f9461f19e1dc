// The film's side of a pass: takes in one group of samples per pixel. See src/gl/film.h for what the textures hold.
uniform sampler2D film_sum;
uniform sampler2D film_rest;
uniform uint film_zero; // 0, which the compiler cannot know

layout(location = 0) out vec4 film_sum_next;
layout(location = 1) out vec4 film_rest_next;

// The same number, in a way that no compiler sees through: without it (a + b) - a may be simplified to b, and what an
// addition rounded away would be lost.
vec3 film_opaque(vec3 v) {
    return uintBitsToFloat(floatBitsToUint(v) ^ uvec3(film_zero));
}

// How many samples the pixel has, with those that were rejected.
uint film_samples() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    return uint(texelFetch(film_sum, pixel, 0).a + texelFetch(film_rest, pixel, 0).a);
}

// `group`: the radiance of the accepted samples summed, and in alpha their number.
void film_add(vec4 group, float rejected) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 sum = texelFetch(film_sum, pixel, 0);
    vec4 rest = texelFetch(film_rest, pixel, 0);
    // Knuth's exact sum: next + lost is sum + group to the last bit. What was lost joins the rest, and the rest goes back
    // into the sum as far as the sum has digits for it (Dekker's), or it would grow and lose digits itself.
    vec3 next = film_opaque(sum.rgb + group.rgb);
    vec3 added = film_opaque(next - sum.rgb);
    vec3 lost = (sum.rgb - film_opaque(next - added)) + (group.rgb - added);
    vec3 small = rest.rgb + lost;
    vec3 total = film_opaque(next + small);
    film_sum_next = vec4(total, sum.a + group.a);
    film_rest_next = vec4(small - film_opaque(total - next), rest.a + rejected);
}
