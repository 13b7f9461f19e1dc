// The film's sums so far, and how many samples they hold. See src/gl/film.h for what the textures hold.
uniform sampler2D film_sum;
uniform sampler2D film_rest;

// The number of the film's first sample: a picture's samples may be shared out among films.
uniform uint film_first;

// The number of the pixel's next sample. Those that were rejected count.
uint film_samples() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    return film_first + uint(texelFetch(film_sum, pixel, 0).a + texelFetch(film_rest, pixel, 0).a);
}
