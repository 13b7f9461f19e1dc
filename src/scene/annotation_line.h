/* One annotation's line, cut into words. */
#pragma once

#include "scene/scene_file.h"

enum { MOST_WORDS = 40 };

/* The keys that were read already, with their lines. */
typedef struct LineOnce {
    char key[64];
    int number;
} LineOnce;

typedef struct LineSeen {
    LineOnce *items;
    int count;
} LineSeen;

typedef struct Line {
    /* What is being read. */
    SceneFile *file;
    LineSeen *seen;
    /* The annotation's; words[0] is its key. */
    char *words[MOST_WORDS];
    int count;
    /* The GLSL before the annotation on the same line. */
    char *declaration;
    int number;
} Line;

/* Cuts `text`, which the words point into: blanks part them, and what is in quotation marks is one word. */
MUST_CHECK bool line_cut(Line *line, char *text, Error *error);

/* Notes a key that can stand once in a file, such as "title" or "camera eye". The error names the line of the
 * first one. */
MUST_CHECK bool line_once(Line *line, const char *key, Error *error);
void line_seen_free(LineSeen *seen);

/* Whether such a key was noted. */
bool line_has(const Line *line, const char *key);

/* Fails if there are words from `at` on. */
MUST_CHECK bool line_end(const Line *line, int at, Error *error);

/* The words from `first` on with one blank between them, to be freed. */
char *line_join(const Line *line, int first);

/* Copies a word that must fit: cutting it short would make it another. */
MUST_CHECK bool line_copy_word(char *target, size_t size, const char *word, Error *error);

/* words[at .. at+count) as numbers in a range. */
MUST_CHECK bool line_numbers(const Line *line, int at, int count, double min, double max, double *values,
                             Error *error);

/* words[at .. at+count) as the value of a setting that every scene has. */
MUST_CHECK bool line_setting(const Line *line, int at, int count, const char *setting, Error *error);
