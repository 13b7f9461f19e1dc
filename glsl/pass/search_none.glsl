// For a scene that has no loops that search.
#include "pass/loops_none.glsl"

void film_search() {
}
