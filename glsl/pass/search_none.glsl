// For a scene that has no loops that search.
void film_search() {
}

bool search_ended() {
    return false;
}
