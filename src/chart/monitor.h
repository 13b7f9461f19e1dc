/* Watches a long measurement: it may stop the measurement, and gets reports of its progress. */
#pragma once

#include <stdbool.h>

typedef struct Monitor {
    /* Returns true to stop the measurement. May be NULL. */
    bool (*stop)(void);
    /* `share` is the part of the whole that is done, from 0 to 1. May be NULL. */
    void (*report)(void *state, double share, const char *words);
    void *state;
    /* The current part of the whole reaches from here to there, from 0 to 1. */
    double from, to;
} Monitor;

static inline bool monitor_stopped(const Monitor *monitor) {
    return monitor->stop && monitor->stop();
}

/* Reports progress. `share` counts within the current part. */
static inline void monitor_report(const Monitor *monitor, double share, const char *words) {
    if (monitor->report)
        monitor->report(monitor->state, monitor->from + share * (monitor->to - monitor->from), words);
}

/* Returns a monitor for a part of the current part. */
static inline Monitor monitor_part(const Monitor *monitor, double from, double to) {
    double width = monitor->to - monitor->from;
    Monitor part = *monitor;
    part.from = monitor->from + from * width;
    part.to = monitor->from + to * width;
    return part;
}
