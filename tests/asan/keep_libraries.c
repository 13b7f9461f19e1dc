/* Linked into the sanitizers' builds only: drivers stay loaded, so that the leak report can name the library
 * that a frame belongs to, and tests/lsan.supp can tell a driver's leaks from ours. */
int dlclose(void *library);

int dlclose(void *library) {
    (void)library;
    return 0;
}
