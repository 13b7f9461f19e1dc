// How two films differ, by the mean over the channels: Moreland's diverging colours, red where a is brighter, blue where b is.
#include "pass/shown_film.glsl"

uniform sampler2D film_a;
uniform sampler2D film_b;
uniform float difference; // radiance at the ends of the colours

vec3 shown_color(vec2 pixel, vec2 window) {
    vec3 apart = film_radiance(film_a, pixel, window) - film_radiance(film_b, pixel, window);
    float t = dot(apart, vec3(1.0 / 3.0)) / difference;
    vec3 end = t < 0.0 ? vec3(0.230, 0.299, 0.754) : vec3(0.706, 0.016, 0.150);
    return mix(vec3(0.865), end, min(abs(t), 1.0));
}
