// The scatter of the groups' means, for a film that estimates its error. See src/gl/film.h for its definition.
#include "pass/film.glsl"

uniform sampler2D film_scatter_sum;

layout(location = 2) out vec4 film_scatter_next;

// `group` is the one that film_add() adds next. This is Chan's update: what a group adds to the sum of n_g (m_g - m)^2 follows from
// its mean and the mean before it, without the cancellation of sums of squares. A group without samples does not count, nor
// does one that film_add() leaves out because it is too large for a float.
void film_scatter(vec4 group) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 sum = texelFetch(film_sum, pixel, 0);
    vec4 scatter = texelFetch(film_scatter_sum, pixel, 0);
    vec3 difference = group.rgb / max(group.a, 1.0) - (sum.rgb + vec3(texelFetch(film_rest, pixel, 0))) / max(sum.a, 1.0);
    float weight = group.a * sum.a / max(group.a + sum.a, 1.0);
    bool counts = group.a > 0.0 && is_finite(group.rgb);
    film_scatter_next = scatter + (counts ? vec4(weight * difference * difference, 1.0) : vec4(0.0));
}
