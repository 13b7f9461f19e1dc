#include "cmd/option_values.h"

#include "base/known.h"
#include "base/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

bool take_output(Options *options, const char *name, const char *value, Error *error) {
    enum { MOST = sizeof options->outputs / sizeof *options->outputs };
    if (!*value) return error_set(error, STATUS_USAGE, "%s: an empty word names no file", name);
    if (options->output_count == MOST)
        return error_set(error, STATUS_USAGE, "%s more than %d times", name, MOST);
    options->outputs[options->output_count++] = value;
    return true;
}

bool take_setting(Options *options, const char *name, const char *value, Error *error) {
    enum { MOST = sizeof options->settings / sizeof *options->settings };
    const char *equals = strchr(value, '=');
    if (!equals || equals == value || !equals[1]) {
        return error_set(error, STATUS_USAGE, "%s: '%s' is not NAME=VALUE", name, value);
    }
    if (options->setting_count == MOST)
        return error_set(error, STATUS_USAGE, "%s more than %d times", name, MOST);
    options->settings[options->setting_count++] = value;
    return true;
}

bool take_allowed(Options *options, const char *name, const char *value, Error *error) {
    enum { MOST = sizeof options->allowed / sizeof *options->allowed };
    if (options->allowed_count == MOST)
        return error_set(error, STATUS_USAGE, "%s more than %d times", name, MOST);
    options->allowed[options->allowed_count++] = value;
    return true;
}

bool take_max_memory(Options *options, const char *name, const char *value, Error *error) {
    static const char suffixes[] = "KMGT";
    static const double least = 1 << 20, most = 0x1p50;
    char digits[64];
    size_t length = strlen(value);
    const char *suffix = length ? strchr(suffixes, value[length - 1]) : NULL;
    snprintf(digits, sizeof digits, "%.*s", (int)(length - (suffix != NULL)), value);
    double number, unit = suffix ? exp2(10 * (double)(suffix - suffixes + 1)) : 1;
    if (length >= sizeof digits || !number_parse(digits, &number) || !(number * unit >= least) ||
        number * unit > most)
        return error_set(
            error, STATUS_USAGE,
            "%s: '%.60s' is no size from 1M to 1024T: it takes bytes, or K, M, G or T behind a number", name,
            value);
    options->max_memory = (size_t)(number * unit);
    return true;
}

bool take_layer(Options *options, const char *name, const char *value, Error *error) {
    enum { MOST = sizeof options->layers / sizeof *options->layers };
    if (options->layer_count == MOST)
        return error_set(error, STATUS_USAGE, "%s more than %d times", name, MOST);
    options->layers[options->layer_count++] = value;
    return true;
}

bool take_size(Options *options, const char *name, const char *value, Error *error) {
    const char *cross = strchr(value, 'x');
    char width[16] = "";
    unsigned long long w, h;
    if (cross && cross - value < (long)sizeof width) memcpy(width, value, (size_t)(cross - value));
    if (!cross || !count_parse(width, &w) || !count_parse(cross + 1, &h) || w > 1000000000 ||
        h > 1000000000) {
        return error_set(error, STATUS_USAGE, "%s: '%s' is not WIDTHxHEIGHT", name, value);
    }
    /* 0 stands for an option that was not given. So 0 becomes another size that the check of limits refuses
     * too. */
    options->width = w ? (int)w : -1;
    options->height = h ? (int)h : -1;
    if (!w || !h)
        return error_set(error, STATUS_USAGE, "%s: '%s': a picture has at least 1x1 pixels", name, value);
    return true;
}

bool take_sun(Options *options, const char *name, const char *value, Error *error) {
    char elevation[64];
    const char *comma = strchr(value, ',');
    size_t length = comma ? (size_t)(comma - value) : strlen(value);
    if (length >= sizeof elevation || (comma && strchr(comma + 1, ',')))
        return error_set(error, STATUS_USAGE, "%s: '%s' is not EL or EL,AZ, in degrees", name, value);
    snprintf(elevation, sizeof elevation, "%.*s", (int)length, value);
    if (!number_parse_range(name, elevation, -90, 90, &options->sun_elevation_deg, error)) return false;
    options->has_sun = true;
    options->has_azimuth = comma != NULL;
    return !comma || number_parse_range(name, comma + 1, -360, 360, &options->sun_azimuth_deg, error);
}

static bool outside_count(const char *name, const char *value, unsigned long long min, unsigned long long max,
                          Error *error) {
    return error_set(error, STATUS_USAGE, "%s: %s is outside the range from %llu to %llu", name, value, min,
                     max);
}

static bool take_count(const char *name, const char *value, unsigned long long min, unsigned long long max,
                       unsigned long long *count, Error *error) {
    unsigned long long parsed;
    double number;
    if (!count_parse(value, &parsed)) {
        /* Digits alone are more than any count, and a minus in front of them less. */
        bool whole = number_parse(value, &number) && !value[strspn(value, "-+0123456789")];
        return whole ? outside_count(name, value, min, max, error)
                     : error_set(error, STATUS_USAGE,
                                 "%s: '%s' is not a whole number, and one from %llu to %llu is needed", name,
                                 value, min, max);
    }
    if (parsed < min || parsed > max) return outside_count(name, value, min, max, error);
    *count = parsed;
    return true;
}

bool take_samples(Options *options, const char *name, const char *value, Error *error) {
    /* A film counts up to 2^24. */
    return take_count(name, value, 1, 1ULL << 24, &options->samples, error);
}

bool take_first_sample(Options *options, const char *name, const char *value, Error *error) {
    options->has_first_sample = true;
    return take_count(name, value, 0, 1ULL << 40, &options->first_sample, error);
}

bool take_of(Options *options, const char *name, const char *value, Error *error) {
    return take_count(name, value, 1, 1ULL << 40, &options->of, error);
}

bool take_crop(Options *options, const char *name, const char *value, Error *error) {
    unsigned long long numbers[4];
    const char *at = value;
    for (int i = 0; i < 4; i++) {
        char number[16];
        size_t length = strcspn(at, ",");
        bool last = i == 3, fits = length < sizeof number;
        snprintf(number, sizeof number, "%.*s", fits ? (int)length : 0, at);
        if (!fits || !count_parse(number, &numbers[i]) || numbers[i] > 65536 || (at[length] == ',') == last)
            return error_set(error, STATUS_USAGE, "%s: '%s' is not X,Y,WIDTH,HEIGHT in pixels", name, value);
        at += length + !last;
    }
    if (!numbers[2] || !numbers[3])
        return error_set(error, STATUS_USAGE, "%s: '%s': a picture has at least 1x1 pixels", name, value);
    options->crop = (Rectangle){(int)numbers[0], (int)numbers[1], (int)numbers[2], (int)numbers[3]};
    return true;
}

bool take_seed(Options *options, const char *name, const char *value, Error *error) {
    unsigned long long seed = 0;
    if (!take_count(name, value, 0, 4294967295ULL, &seed, error)) return false;
    options->seed = (unsigned)seed;
    return true;
}

bool take_depth(Options *options, const char *name, const char *value, Error *error) {
    unsigned long long depth = 0;
    if (!take_count(name, value, 0, 1000000000, &depth, error)) return false;
    options->depth = (int)depth;
    return true;
}

bool take_seconds(Options *options, const char *name, const char *value, Error *error) {
    return number_parse_range(name, value, 1e-3, 1e9, &options->seconds, error);
}

bool take_compile_seconds(Options *options, const char *name, const char *value, Error *error) {
    return number_parse_range(name, value, 0.1, 1e6, &options->compile_seconds, error);
}

bool take_checkpoint_seconds(Options *options, const char *name, const char *value, Error *error) {
    return number_parse_range(name, value, 1e-2, 1e9, &options->checkpoint_seconds, error);
}

bool take_percent(Options *options, const char *name, const char *value, Error *error) {
    return number_parse_range(name, value, 1e-3, 1e3, &options->error.amount, error);
}

bool take_error(Options *options, const char *name, const char *value, Error *error) {
    char amount[32];
    size_t length = strcspn(value, "l");
    bool levels = strcmp(value + length, "levels") == 0;
    options->error.measure = levels ? NOISE_LEVELS : NOISE_RADIANCE;
    if (!levels && value[strspn(value, "+-.0123456789eE")])
        return error_set(error, STATUS_USAGE,
                         "%s: '%s' is neither percent, such as 1, nor levels, such as 2levels", name, value);
    if (!levels) return number_parse_range(name, value, 1e-3, 1e3, &options->error.amount, error);
    if (length >= sizeof amount)
        return error_set(error, STATUS_USAGE, "%s: '%s' has too many digits", name, value);
    snprintf(amount, sizeof amount, "%.*s", (int)length, value);
    return number_parse_range(name, amount, 1e-2, 100, &options->error.amount, error);
}

bool take_exposure(Options *options, const char *name, const char *value, Error *error) {
    options->has_exposure = true;
    return number_parse_range(name, value, -64, 64, &options->exposure_ev, error);
}

bool take_max_relrmse(Options *options, const char *name, const char *value, Error *error) {
    return number_parse_range(name, value, 0, 1e9, &options->max_relrmse_percent, error);
}

bool take_max_bias(Options *options, const char *name, const char *value, Error *error) {
    return number_parse_range(name, value, 0, 1e9, &options->max_bias_percent, error);
}

bool take_max_levels(Options *options, const char *name, const char *value, Error *error) {
    return number_parse_range(name, value, 0, 255, &options->max_levels, error);
}

const char *word_next(const char **list, size_t *length) {
    const char *word = *list;
    if (!word) return NULL;
    *length = strcspn(word, ",");
    *list = word[*length] ? word + *length + 1 : NULL;
    return word;
}

bool take_word(const char *words, const char *name, const char *value, const char **target, Error *error) {
    char copy[128];
    snprintf(copy, sizeof copy, "%s", words);
    Known known = known_to(value, strlen(value));
    for (char *word = strtok(copy, ","); word; word = strtok(NULL, ",")) {
        if (strcmp(word, value) == 0) {
            known_free(&known);
            *target = value;
            return true;
        }
        known_add(&known, word);
    }
    return known_fail(&known, STATUS_USAGE, error, "%s: unknown '%s'", name, value);
}

bool take_frames(Options *options, const char *name, const char *value, Error *error) {
    unsigned long long frames = 0;
    if (!take_count(name, value, 1, 99999, &frames, error)) return false;
    options->frames = (int)frames;
    return true;
}

bool take_frame_rate(Options *options, const char *name, const char *value, Error *error) {
    return number_parse_range(name, value, 1e-3, 1e4, &options->frame_rate, error);
}
