/* What the tests of exported pages share: a page in a browser, its pictures, and those of `render`. */
#pragma once

#include "browser.h"

#include "image/image.h"

/* The group's set-up and its end: the test's folder, and build/web for what is to be looked at. */
int web_setup(void **state);
int web_teardown(void **state);

/* The browser of all tests of the program, which draws by llvmpipe. It is started by the first test that
 * asks, because a fixture cannot be skipped. */
Browser *web_browser(void);

/* Exports a scene and gives the page's path; NULL where `export` refuses the scene, and the reason is in
 * support_err. `options` may be "". */
const char *web_export(const char *scene, const char *options);

/* Opens a page and waits until it has a picture, or says why not. */
void web_open(Browser *browser, const char *path, const char *fragment);

/* The picture of so many samples, as the page draws it at rest. */
Image web_picture(Browser *browser, int samples);

/* The picture of the command that the page shows, to which options may be added. */
Image web_native(Browser *browser, const char *options);

/* How far the pictures of two seeds by this command are from each other, in percent. */
double web_noise(Browser *browser);

/* The relative RMSE in percent, and the error of the mean over all channels, of which either may be NULL.
 * What is beyond the bounds fails the test, and the pictures are kept. */
typedef struct WebBounds {
    double rel_rmse_percent, mean_percent;
} WebBounds;
void web_compare(const char *name, const Image *got, const Image *wanted, WebBounds bounds);

/* The window's size: a desk's or a phone's, 1280 or 390 pixels wide. */
void web_view(Browser *browser, bool phone);

/* Writes a screenshot to build/web, and fails the test if something is wider than the window. */
void web_look(Browser *browser, const char *name);
