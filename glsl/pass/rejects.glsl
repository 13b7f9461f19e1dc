// Counts the samples that are left out of a pixel, by their causes, and those that are negative. See src/gl/film.h for what the texture holds.
uniform sampler2D film_rejects_sum;

layout(location = 6) out vec4 film_rejects_next;

vec4 film_rejects_group = vec4(0.0);

// Call it for each sample: whether its radiance is finite, and whether it is added to the group.
void film_reject(vec3 radiance, bool finite, bool counts) {
    bool negative = counts && min(radiance.x, min(radiance.y, radiance.z)) < 0.0;
    film_rejects_group += vec4(finite ? 0.0 : 1.0, 0.0, finite && !counts ? 1.0 : 0.0, negative ? 1.0 : 0.0);
}

// Call it at the end: whether the group of so many samples was added to the film.
void film_rejects(bool fits, float samples) {
    vec4 sum = texelFetch(film_rejects_sum, ivec2(gl_FragCoord.xy), 0);
    film_rejects_next = sum + film_rejects_group + vec4(0.0, fits ? 0.0 : samples, 0.0, 0.0);
}
