// For a scene that has no loops that search.
bool loops_ended() {
    return false;
}
