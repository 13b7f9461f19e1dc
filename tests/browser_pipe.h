/* A headless Chromium of the test's own, and the messages of its debugging protocol: JSON, each ended by a
 * zero byte, on the browser's descriptors 3 and 4. */
#pragma once

#include "browser.h"

#include "base/error.h"
#include "base/text.h"

#include <jansson.h>
#include <sys/types.h>

/* Long, for slow machines and sanitizers; nothing waits as long as that unless it fails. */
#define BROWSER_PATIENCE_S 60.0

struct Browser {
    pid_t process;
    int to, from;
    /* What has come and was not read yet begins at `taken`. */
    Text incoming;
    size_t taken;
    int number;
    /* The page that all messages are about; empty until there is one. */
    char session[64];
    char profile[512];

    /* What events have told since the last browser_open(). */
    Text errors, requests;
    int loads;
    bool crashed;
    /* Since browser_downloads(). */
    int downloads;
    char downloaded[512], folder[512];

    /* The answers that were given out, until the next of their kind. */
    Text string;
    void *bytes;
    /* Where the mouse is, and which of its buttons are down. */
    double x, y;
    int buttons, touches;
    char script[64];
};

/* Starts the browser with these flags after its own, which end with NULL, and with a new profile in a folder
 * whose name begins with `name`. */
MUST_CHECK bool browser_pipe_start(Browser *browser, const char *name, const char *const *flags,
                                   Error *error);

/* Ends the browser with all its processes and removes its profile. */
void browser_pipe_stop(Browser *browser);

/* Calls a method and waits for its result, which is the caller's. `params` is taken over, and may be NULL for
 * none. The error says why there is none. */
json_t *browser_pipe_ask(Browser *browser, const char *method, json_t *params, double patience_s,
                         Error *error);

/* The same with the usual patience; fails the test where there is no result. */
json_t *browser_call(Browser *browser, const char *method, json_t *params);

/* The same for methods whose result says nothing. */
void browser_tell(Browser *browser, const char *method, json_t *params);

/* Hears one event, or waits for it until the clock says `end_s`; false if none came. */
bool browser_pipe_hear(Browser *browser, double end_s, Error *error);

/* What is done with each event. */
void browser_event(Browser *browser, const char *method, const json_t *params);
