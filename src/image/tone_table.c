#include "image/tone_table.h"

#include <math.h>

ToneTable tone_table(Tone tone, double gain) {
    const int segments = 1 << TONE_TABLE_BITS;
    ToneTable table = {.gain = (float)gain};
    for (int i = 0; i <= TONE_TABLE_OCTAVES * segments; i++) {
        /* The float whose bits begin with the segment's number. */
        double shown = ldexp(1 + (double)(i % segments) / segments, TONE_TABLE_FIRST + i / segments);
        table.levels[i] = (float)tone_level(tone, 1, shown);
    }
    return table;
}
