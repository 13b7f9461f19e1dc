/* The wavelengths of `sky --at --spectrum`. */
#pragma once

#include "scene/atmosphere.h"

enum { MOST_LISTED = 471 };

typedef struct Wavelengths {
    double nm[MOST_LISTED];
    int count;
} Wavelengths;

/* Takes a list "380,400,..." or a range "360:830:10" (from, to, step) of wavelengths from 360 to 830 nm, in
 * their order, or those of atmosphere.spectrum if `text` is "auto". STATUS_USAGE if there are none or too
 * many, or if the air follows no law by wavelength (spectrum_check()). */
MUST_CHECK bool wavelengths_choose(Wavelengths *list, const char *text, const Atmosphere *atmosphere,
                                   Error *error);
