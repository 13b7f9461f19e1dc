/* The one writer of JSON lines: an object a line, its members in the order of the calls.
 *
 *     Json json = json_begin();
 *     json_text(&json, "event", "frame");
 *     json_number(&json, "width", 640);
 *     json_end(&json, stderr);
 */
#pragma once

#include "base/text.h"

#include <stdint.h>
#include <stdio.h>

typedef struct Json {
    Text line;
} Json;

Json json_begin(void);

/* To 9 digits; null where the value is not finite, for which JSON has no word. */
void json_number(Json *json, const char *name, double value);

/* Times, to the microsecond however long the clock has run. */
void json_seconds(Json *json, const char *name, double seconds);

/* An array of numbers, as json_number() writes them. */
void json_numbers(Json *json, const char *name, const double *values, int count);

void json_count(Json *json, const char *name, uint64_t count);
void json_flag(Json *json, const char *name, bool value);

/* Any UTF-8 text; what JSON cannot hold as it stands is escaped. */
void json_text(Json *json, const char *name, const char *value);

/* Writes the line at once, so that the lines of two writers do not mix, and frees it. */
void json_end(Json *json, FILE *file);
