// A texture that is a picture already. Its row 0 is at the bottom.
uniform sampler2D film_a;

vec3 shown_color(vec2 pixel, vec2 window) {
    return clamp(texelFetch(film_a, ivec2(pixel.x, window.y - pixel.y), 0).rgb, 0.0, 1.0);
}
