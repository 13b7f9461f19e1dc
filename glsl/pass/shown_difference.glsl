// The difference of two films, as the mean over the channels, in Moreland's diverging colours: red where film a is brighter, blue
// where film b is.
#include "pass/shown_film.glsl"

uniform sampler2D film_a;
uniform sampler2D film_b;
// The radiance at the ends of the colours.
uniform float difference;

vec3 shown_color(vec2 pixel, vec2 window) {
    vec3 apart = film_radiance(film_a, pixel, window) - film_radiance(film_b, pixel, window);
    float t = dot(apart, vec3(1.0 / 3.0)) / difference;
    vec3 end = t < 0.0 ? vec3(0.230, 0.299, 0.754) : vec3(0.706, 0.016, 0.150);
    return mix(vec3(0.865), end, min(abs(t), 1.0));
}
