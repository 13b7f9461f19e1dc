// A film that is not asked for its error.
void film_scatter(vec4 group) {
}
