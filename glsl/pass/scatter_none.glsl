// For a film that does not estimate its error.
void film_scatter(vec4 group) {
}
