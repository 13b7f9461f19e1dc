/* The tone curve as a table, for programs that show the same picture many times. */
#pragma once

#include "image/tone.h"

#include <stdint.h>
#include <string.h>

/* Each octave of radiance, from 2^TONE_TABLE_FIRST on, has 64 segments on which the level is linear. */
enum { TONE_TABLE_BITS = 6, TONE_TABLE_FIRST = -24, TONE_TABLE_OCTAVES = 32 };

typedef struct ToneTable {
    float gain;
    float levels[(TONE_TABLE_OCTAVES << TONE_TABLE_BITS) + 1];
} ToneTable;

ToneTable tone_table(Tone tone, double gain);

/* The level of a radiance. It differs from tone_level() by less than 0.004. */
static inline float tone_table_level(const ToneTable *table, float radiance) {
    const uint32_t first = (uint32_t)(127 + TONE_TABLE_FIRST) << TONE_TABLE_BITS;
    const int shift = 23 - TONE_TABLE_BITS;
    float shown = radiance * table->gain;
    uint32_t bits;
    if (!(shown >= 0x1p-24F)) return 0;
    if (shown >= 0x1p8F) return table->levels[TONE_TABLE_OCTAVES << TONE_TABLE_BITS];
    memcpy(&bits, &shown, sizeof bits);
    const float *from = table->levels + ((bits >> shift) - first);
    float part = (float)(bits & ((1U << shift) - 1)) * (1.0F / (float)(1U << shift));
    return from[0] + part * (from[1] - from[0]);
}
