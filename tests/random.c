#include "random.h"

unsigned random_state;

double random_unit(void) {
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) / 16777216.0;
}
