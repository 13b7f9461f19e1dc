// For a picture in which no sunlight is left to chance, or all of it.
void film_chance() {
}
