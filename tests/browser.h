/* A headless Chromium that a test drives: it opens pages, evaluates expressions, has a mouse, keys, fingers
 * and eyes. Whatever does not come in time fails the test with words. */
#pragma once

#include "support.h"

typedef struct Browser Browser;

/* What draws: Mesa's llvmpipe, the compiler of the other tests, or SwiftShader, another one, or nothing, so
 * that pages have no WebGL. */
typedef enum BrowserDrawing { BROWSER_LLVMPIPE, BROWSER_SWIFTSHADER, BROWSER_NO_WEBGL } BrowserDrawing;

/* Starts a browser with a new profile in the test's folder. Skips the test with the reason where it is not
 * there or does not start, or fails it if the environment says REQUIRE_WEB=1. */
Browser *browser_start(BrowserDrawing drawing);

/* Ends a test that needs a browser as browser_start() does where there is none. */
void browser_missing(const char *reason);

/* Ends it with all its processes. NULL is none. */
void browser_stop(Browser *browser);

/* Whether it has not been ended, by whomever. */
bool browser_runs(const Browser *browser);

/* Opens a file, or what begins like a URL, and waits until it is loaded. What errors and requests are told
 * begins anew. `fragment` may be "", or "#sun=5". */
void browser_open(Browser *browser, const char *path, const char *fragment);

/* A script that runs in each page before its own; NULL for none. */
void browser_before(Browser *browser, const char *script);

/* Without scripts pages are what HTML and CSS alone are. */
void browser_scripts(Browser *browser, bool allowed);

/* ---- Expressions of JavaScript. A promise is awaited. What they throw fails the test. */

double browser_number(Browser *browser, const char *format, ...) __attribute__((format(printf, 2, 3)));
bool browser_true(Browser *browser, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Any value as String() shows it, and the bytes of a buffer or a typed array. They are good until the next
 * call. */
const char *browser_string(Browser *browser, const char *format, ...) __attribute__((format(printf, 2, 3)));
const void *browser_bytes(Browser *browser, size_t *size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Does it, whatever its value. */
void browser_do(Browser *browser, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Sets window.NAME to a text of any length. */
void browser_give(Browser *browser, const char *name, const char *text);

/* Waits until it is true. */
void browser_await(Browser *browser, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* ---- What the page has said: errors and uncaught exceptions, a line each, and "" for none; and each address
 * that it asked for, a line each, but those of files, data and blobs. */

const char *browser_errors(Browser *browser);
const char *browser_requests(Browser *browser);

/* ---- Eyes */

/* The window's size in CSS pixels; a phone's has touch, and its pages' viewport is their own. */
void browser_view(Browser *browser, int width, int height, bool phone);

/* "dark" or "light", which pages see in prefers-color-scheme. */
void browser_scheme(Browser *browser, const char *scheme);
void browser_screenshot(Browser *browser, const char *path);

/* ---- Hands. Places are in CSS pixels of the window; a CSS selector stands for its first element, which is
 * scrolled into view. */

void browser_move(Browser *browser, double x, double y);
void browser_press(Browser *browser, const char *button);
void browser_release(Browser *browser, const char *button);
void browser_wheel(Browser *browser, double dx, double dy);
void browser_click(Browser *browser, const char *selector);
void browser_center(Browser *browser, const char *selector, double *x, double *y);

/* One finger, or two: down or moved there, and up. */
void browser_touch(Browser *browser, int count, const double xy[]);
void browser_untouch(Browser *browser);

/* A key by its name in JavaScript, such as "ArrowLeft", "Tab" or "a". */
void browser_key(Browser *browser, const char *key);

/* Lets pages save files into this folder. */
void browser_downloads(Browser *browser, const char *folder);

/* Waits for the next file that is saved whole, and gives its path. */
const char *browser_downloaded(Browser *browser);
