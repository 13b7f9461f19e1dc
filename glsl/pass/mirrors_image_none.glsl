// For a scene that names no mirror spheres.
vec3 mirrors_image(vec2 pixel, uint index, uint seed) {
    return vec3(0.0);
}
