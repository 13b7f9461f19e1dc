#include "scene/annotation_mist.h"

#include "base/known.h"
#include "base/number.h"
#include "scene/annotation_parameters.h"

#include <stdio.h>
#include <string.h>

/* A key and the words behind it. */
typedef struct Key {
    const char *name;
    MistWord first;
    int count;
    /* What region the key says. */
    MistShape shape;
    const char *needs;
} Key;

static const Key keys[] = {
    {"extinction", MIST_EXTINCTION, 1, 0,
     "the share of the light that a metre takes away, 1/m, or three for red, green and blue"},
    {"albedo", MIST_ALBEDO, 3, 0, "red, green and blue from 0 to 1"},
    {"g", MIST_FORWARD, 1, 0, "the mean cosine of scattering"},
    {"falloff", MIST_FALLOFF, 1, 0, "the height in which it thins to 1/e, m"},
    {"base", MIST_BASE, 1, 0, "the height at which it has its extinction, m"},
    {"sphere", MIST_REGION, 4, MIST_SPHERE, "x y z radius"},
    {"box", MIST_REGION, 6, MIST_BOX, "x y z and the half size along x, y and z"},
    {"below", MIST_REGION, 1, MIST_BELOW, "a height, m"},
};
enum { KEYS = sizeof keys / sizeof *keys };

/* The least and the most that a word may be: nearly all light goes on straight where g is nearly 1. */
static const double most_forward = 0.99, farthest_m = 1e6, shortest_m = 1e-3;

static void range_of(const Mist *mist, int word, double *least, double *most) {
    bool length = word == MIST_FALLOFF || (word >= MIST_REGION + 3 && mist->shape != MIST_BELOW);
    *most = word < MIST_ALBEDO     ? 1e6
            : word < MIST_FORWARD  ? 1
            : word == MIST_FORWARD ? most_forward
                                   : farthest_m;
    *least = word < MIST_FORWARD ? 0 : length ? shortest_m : -*most;
}

static const Key *find_key(const char *word) {
    for (int i = 0; i < KEYS; i++) {
        if (strcmp(keys[i].name, word) == 0) return &keys[i];
    }
    return NULL;
}

static bool read_phase(Mist *mist, const Line *line, int at, Error *error) {
    const char *word = at + 1 < line->count ? line->words[at + 1] : "";
    mist->shanks = strcmp(word, "shanks") == 0;
    return mist->shanks || strcmp(word, "henyey") == 0 ||
           error_set(error, STATUS_SCENE, "mist: phase needs henyey or shanks");
}

static bool is_key(const char *word) {
    return find_key(word) || strcmp(word, "phase") == 0;
}

/* The known key that is most like a word that is none. */
static Known keys_near(const char *word) {
    Known known = known_to(word, strlen(word));
    for (int i = 0; i < KEYS; i++) known_add(&known, keys[i].name);
    known_add(&known, "phase");
    return known;
}

static bool unknown_key(const char *word, Error *error) {
    Known known = keys_near(word);
    return known_fail(&known, STATUS_SCENE, error, "mist: unknown key '%s'", word);
}

/* Extinction may have a colour. A word behind its first number is a second one, unless it looks like a key.
 */
static bool is_second(const Line *line, int at) {
    double number;
    if (at >= line->count || is_key(line->words[at])) return false;
    if (number_parse(line->words[at], &number)) return true;
    Known known = keys_near(line->words[at]);
    bool near_key = known.near.name != NULL;
    known_free(&known);
    return !near_key && at + 1 < line->count && !is_key(line->words[at + 1]);
}

static int count_words(const Line *line, int at, const Key *key) {
    return key->first == MIST_EXTINCTION && is_second(line, at + 2) ? 3 : key->count;
}

static bool read_key(Mist *mist, const Line *line, int *at, const Key *key, Error *error) {
    int count = count_words(line, *at, key);
    if (key->shape && mist->shape)
        return error_set(error, STATUS_SCENE, "mist: '%s' is a second region, and mist has one", key->name);
    if (mist->words[key->first][0])
        return error_set(error, STATUS_SCENE, "mist: %s is there twice", key->name);
    if (*at + count >= line->count)
        return error_set(error, STATUS_SCENE, "mist: %s needs %s", key->name, key->needs);
    if (key->shape) mist->shape = key->shape;
    for (int i = 0; i < count; i++) {
        char *word = mist->words[(int)key->first + i];
        if (is_key(line->words[*at + 1 + i]))
            return error_set(error, STATUS_SCENE,
                             "mist: %s needs %s; '%s' is a key of mist, so that a slider needs another name",
                             key->name, key->needs, line->words[*at + 1 + i]);
        if (!line_copy_word(word, sizeof mist->words[0], line->words[*at + 1 + i], error)) return false;
    }
    *at += 1 + count;
    return true;
}

/* `mist off ...` is there to be switched on. */
static int read_switch(const Line *line) {
    bool off = line->count > 1 && strcmp(line->words[1], "off") == 0;
    if (off) line->file->values.parameters[line->file->mist.parameter][0] = 0;
    return off ? 2 : 1;
}

static bool read_keys(Mist *mist, const Line *line, Error *error) {
    bool phase = false;
    for (int at = read_switch(line); at < line->count;) {
        const Key *key = find_key(line->words[at]);
        if (strcmp(line->words[at], "phase") == 0) {
            if (phase) return error_set(error, STATUS_SCENE, "mist: phase is there twice");
            phase = true;
            if (!read_phase(mist, line, at, error)) return false;
            at += 2;
        } else {
            if (!key) return unknown_key(line->words[at], error);
            if (!read_key(mist, line, &at, key, error)) return false;
        }
    }
    return true;
}

/* What must be there, and what goes together. */
static bool check_keys(Mist *mist, Error *error) {
    mist->falls = mist->words[MIST_FALLOFF][0];
    if (!mist->words[MIST_EXTINCTION][0])
        return error_set(error, STATUS_SCENE, "mist needs extinction and %s", keys[0].needs);
    if (mist->words[MIST_BASE][0] && !mist->falls)
        return error_set(error, STATUS_SCENE,
                         "mist: base is for mist that thins with height, which has a falloff");
    if (mist->shape == MIST_EVERYWHERE && !mist->falls)
        return error_set(error, STATUS_SCENE,
                         "mist of one density that has no end would hide the sky: it needs a region, "
                         "`sphere X Y Z R`, `box X Y Z HX HY HZ` or `below Y`, or `falloff H`");
    for (int i = 0; i < 3; i++) {
        if (!mist->words[MIST_ALBEDO + i][0]) strcpy(mist->words[MIST_ALBEDO + i], "1");
    }
    return true;
}

bool mist_read(Line *line, Error *error) {
    Mist *mist = &line->file->mist;
    if (mist->line)
        return error_set(
            error, STATUS_SCENE,
            "there is mist in line %d already: a scene has one, because mists that overlap would "
            "need a choice of which one scatters",
            mist->line);
    mist->line = line->number;
    mist->parameter = parameters_add_switch(line->file, "mist", "mist", error);
    if (mist->parameter < 0) return error_prefix(error, "mist is switched by a parameter of its name: ");
    return read_keys(mist, line, error) && check_keys(mist, error);
}

static bool check_slider(const SceneFile *file, const Parameter *slider, bool minus, double least,
                         double most, Error *error) {
    double low = minus ? -slider->max : slider->min, high = minus ? -slider->min : slider->max;
    if (low >= least && high <= most) return true;
    return error_set(error, STATUS_SCENE, "%s:%d: mist: the slider '%s' goes from %g to %g, past %g to %g",
                     file->path, file->mist.line, slider->name, slider->min, slider->max,
                     minus ? -most : least, minus ? -least : most);
}

bool mist_check(const SceneFile *file, Error *error) {
    const Mist *mist = &file->mist;
    for (int i = 0; i < MIST_WORDS; i++) {
        const char *word = mist->words[i];
        double least, most, number;
        if (!*word) continue;
        range_of(mist, i, &least, &most);
        const Parameter *slider = parameters_find_slider(file, word + (*word == '-'));
        if (slider) {
            if (!check_slider(file, slider, *word == '-', least, most, error)) return false;
        } else if (!number_parse(word, &number) || number < least || number > most) {
            return error_set(error, STATUS_SCENE,
                             "%s:%d: mist: '%s' is neither a number from %g to %g nor a slider's name",
                             file->path, mist->line, word, least, most);
        }
    }
    return true;
}
