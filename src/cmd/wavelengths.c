#include "cmd/wavelengths.h"

#include "base/number.h"
#include "scene/spectrum.h"
#include "scene/spectrum_data.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char option[] = "--spectrum";

static bool add(Wavelengths *list, double nm, Error *error) {
    if (list->count == MOST_LISTED)
        return error_set(error, STATUS_USAGE, "%s: more than %d wavelengths", option, MOST_LISTED);
    list->nm[list->count++] = nm;
    return true;
}

/* Reads the number before the next `end`, or the text's last one, and moves on past it. */
static bool take(const char **text, char end, double least, double *value, Error *error) {
    char word[40];
    size_t length = strcspn(*text, (char[]){end, 0});
    snprintf(word, sizeof word, "%.*s", (int)length, *text);
    *text += length + ((*text)[length] != 0);
    return number_parse_range(option, word, least, SPECTRUM_LONGEST_NM, value, error);
}

static bool take_range(Wavelengths *list, const char *text, Error *error) {
    double from, to, step;
    if (!take(&text, ':', SPECTRUM_SHORTEST_NM, &from, error) ||
        !take(&text, ':', SPECTRUM_SHORTEST_NM, &to, error) || !take(&text, ':', 1, &step, error))
        return false;
    if (*text || to < from)
        return error_set(error, STATUS_USAGE, "%s: a range is FROM:TO:STEP, such as 360:830:10", option);
    /* The last one counts although the sum of many steps is rounded. */
    int steps = (int)floor((to - from) / step + 1e-9);
    for (int i = 0; i <= steps; i++) {
        if (!add(list, from + i * step, error)) return false;
    }
    return true;
}

static bool take_list(Wavelengths *list, const char *text, Error *error) {
    do {
        double nm;
        if (!take(&text, ',', SPECTRUM_SHORTEST_NM, &nm, error) || !add(list, nm, error)) return false;
    } while (*text);
    return true;
}

bool wavelengths_choose(Wavelengths *list, const char *text, const Atmosphere *atmosphere, Error *error) {
    Atmosphere air = *atmosphere;
    *list = (Wavelengths){0};
    if (strcmp(text, "auto") == 0) {
        list->count = spectrum_wavelengths(atmosphere, list->nm);
        if (list->count) return true;
        return error_set(error, STATUS_USAGE,
                         "%s: atmosphere.spectrum is rgb: list the wavelengths, such as %s=360:830:10, or "
                         "set it to 3 or 6",
                         option, option);
    }
    /* The laws are checked as if colours were computed from them. */
    if (air.spectrum == SPECTRUM_RGB) air.spectrum = MOST_WAVELENGTHS;
    if (!spectrum_check(&air, error)) return error_prefix(error, "%s: ", option);
    return strchr(text, ':') ? take_range(list, text, error) : take_list(list, text, error);
}
