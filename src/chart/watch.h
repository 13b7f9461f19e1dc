/* What long measurements are watched by: somebody who may stop them, and who is told how far they are. */
#pragma once

#include <stdbool.h>

typedef struct Watch {
    bool (*stop)(void); /* may be NULL */
    void (*report)(void *state, double share,
                   const char *words); /* may be NULL; share of the whole, 0 to 1 */
    void *state;
    double from, to; /* the part of the whole that is at hand */
} Watch;

static inline bool watch_stopped(const Watch *watch) {
    return watch->stop && watch->stop();
}

/* `share` of the part at hand. */
static inline void watch_report(const Watch *watch, double share, const char *words) {
    if (watch->report) watch->report(watch->state, watch->from + share * (watch->to - watch->from), words);
}

/* A part of the part at hand. */
static inline Watch watch_part(const Watch *watch, double from, double to) {
    double width = watch->to - watch->from;
    Watch part = *watch;
    part.from = watch->from + from * width;
    part.to = watch->from + to * width;
    return part;
}
