// A film of any size, interpolated to the window's size.
#include "pass/shown_film.glsl"
#include "pass/shown_tone.glsl"

uniform sampler2D film_a;

vec3 shown_color(vec2 pixel, vec2 window) {
    return developed(film_radiance(film_a, pixel, window), uvec2(pixel));
}
