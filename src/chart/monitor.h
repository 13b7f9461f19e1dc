/* What long measurements are watched by: somebody who may stop them, and who is told how far they are. */
#pragma once

#include <stdbool.h>

typedef struct Monitor {
    bool (*stop)(void); /* may be NULL */
    void (*report)(void *state, double share,
                   const char *words); /* may be NULL; share of the whole, 0 to 1 */
    void *state;
    double from, to; /* the part of the whole that is at hand */
} Monitor;

static inline bool monitor_stopped(const Monitor *monitor) {
    return monitor->stop && monitor->stop();
}

/* `share` of the part at hand. */
static inline void monitor_report(const Monitor *monitor, double share, const char *words) {
    if (monitor->report)
        monitor->report(monitor->state, monitor->from + share * (monitor->to - monitor->from), words);
}

/* A part of the part at hand. */
static inline Monitor monitor_part(const Monitor *monitor, double from, double to) {
    double width = monitor->to - monitor->from;
    Monitor part = *monitor;
    part.from = monitor->from + from * width;
    part.to = monitor->from + to * width;
    return part;
}
