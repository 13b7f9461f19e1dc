#include "view/log.h"

#include "base/clock.h"

#include <math.h>
#include <stdio.h>

static bool enabled;

void log_enable(bool on) {
    enabled = on;
}

void log_begin(const char *event) {
    if (enabled) fprintf(stderr, "{\"event\": \"%s\", \"clock\": %.6f", event, clock_seconds());
}

void log_number(const char *name, double value) {
    if (!enabled) return;
    if (isfinite(value))
        fprintf(stderr, ", \"%s\": %.9g", name, value);
    else
        fprintf(stderr, ", \"%s\": null", name);
}

void log_text(const char *name, const char *value) {
    if (!enabled) return;
    fprintf(stderr, ", \"%s\": \"", name);
    for (const char *c = value; *c; c++) {
        if (*c == '"' || *c == '\\')
            fprintf(stderr, "\\%c", *c);
        else if ((unsigned char)*c < 0x20)
            fprintf(stderr, "\\u%04x", (unsigned)*c);
        else
            fputc(*c, stderr);
    }
    fputc('"', stderr);
}

void log_end(void) {
    if (!enabled) return;
    fputs("}\n", stderr);
    fflush(stderr);
}
