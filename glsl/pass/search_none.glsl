// A scene that searches for nothing by loops of its own.
void film_search() {
}

bool search_ended() {
    return false;
}
