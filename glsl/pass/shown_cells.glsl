// Means of the cells of a film, for the light meter. The window is the grid of cells, and each of its pixels is a cell.
uniform sampler2D film_a;

// At most eight by eight pixels of a cell are looked at.
const int most_looks = 8;

vec3 shown_color(vec2 pixel, vec2 window) {
    vec2 cell = vec2(textureSize(film_a, 0)) / window;
    ivec2 looks = clamp(ivec2(ceil(cell)), ivec2(1), ivec2(most_looks));
    vec4 sum = vec4(0.0);
    for (int i = 0; i < looks.x * looks.y; i++) {
        vec2 place = (vec2(i % looks.x, i / looks.x) + 0.5) / vec2(looks);
        sum += texelFetch(film_a, ivec2((floor(pixel) + place) * cell), 0);
    }
    return sum.rgb / max(sum.a, 1.0);
}
