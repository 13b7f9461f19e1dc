#include "view/log.h"

#include "base/clock.h"
#include "base/json.h"

static bool enabled;
static Json line;

void log_enable(bool on) {
    enabled = on;
}

void log_begin(const char *event) {
    if (!enabled) return;
    line = json_begin();
    json_text(&line, "event", event);
    json_seconds(&line, "clock", clock_seconds());
}

void log_number(const char *name, double value) {
    if (enabled) json_number(&line, name, value);
}

void log_text(const char *name, const char *value) {
    if (enabled) json_text(&line, name, value);
}

void log_end(void) {
    if (enabled) json_end(&line, stderr);
}
