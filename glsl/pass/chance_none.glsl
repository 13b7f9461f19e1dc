// A picture in which nothing is left to chance, or all of it.
void film_chance() {
}
