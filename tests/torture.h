/* Random scenes with random settings, the same for the same number: surfaces of all shapes and materials,
 * with hints and without, mist, lamps, suns from -10 to 90 degrees, methods, sequences and sizes. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

typedef struct Torture {
    /* The scene's text. */
    char scene[8192];
    /* The options of `render` without the number of samples, and that number. */
    char options[512];
    int samples;
    /* Whether a control variate may bring negative values: the light method is `control`, or may be because
     * `auto` chooses, or there is mist. */
    bool may_control;
    /* Whether the picture is made of points of light alone. */
    bool chains;
} Torture;

/* Makes the case of that number. */
void torture_make(Torture *torture, uint32_t number);
