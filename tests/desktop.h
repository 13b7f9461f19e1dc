/* A display of the test's own (Xvfb), the window on it, hands (xdotool) and eyes: the screen's pixels, and
 * the window's JSON log. */
#pragma once

#include "support.h"

typedef struct Desktop Desktop;

/* Each test's set-up and its end: a display of its own, as `window`. Skips the test where Xvfb or xdotool is
 * missing. */
extern Desktop *window;
int desktop_setup(void **state);
int desktop_teardown(void **state);

/* Starts `magichour view ARGUMENTS --progress json` on it, in the test's folder ($here is the folder of
 * before), and waits for its first pictures; one at a time. */
void desktop_view(Desktop *desktop, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The same without waiting. */
void desktop_start(Desktop *desktop, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Waits until the program has ended and gives its exit status. */
int desktop_end(Desktop *desktop);

/* Prints the end of what the program said, such as what a sanitizer has found. */
void desktop_print_last(Desktop *desktop);

/* Closes the window by a key: it must end well, and without an error of OpenGL's. */
void desktop_quit(Desktop *desktop);

/* Has the picture that is shown saved, and gives the path of one of its files, with that extension. */
const char *desktop_save(Desktop *desktop, const char *extension);

void desktop_signal(Desktop *desktop, int signal);

/* `xdotool ARGUMENTS`; what the log says from here on is news to the functions below. */
void desktop_do(Desktop *desktop, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The same, and the log's news goes on from where it was. */
void desktop_also(Desktop *desktop, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Drops a file on the window with that title. */
void desktop_drop(Desktop *desktop, const char *title, const char *path);

/* Waits for a line of news with these words; both may be empty. Fails the test when none comes. */
const char *desktop_expect(Desktop *desktop, const char *words, const char *more_words);

/* Waits for a frame whose number `name` is in [low, high], and has the words. */
void desktop_expect_number(Desktop *desktop, const char *name, double low, double high);

/* Waits for a frame whose number `name` is at least `low`, returns it, and gives another number of that
 * frame. */
double desktop_expect_pair(Desktop *desktop, const char *name, double low, const char *other, double *value);

/* Waits until all that was done has been heard and its answer is on the screen. Returns the number of the
 * first frame whose line in the log is sure to be later. */
double desktop_settle(Desktop *desktop);

/* Waits for so many samples in a frame that is later than what was done last. The samples of a line of news
 * may be those of the picture before: xdotool takes time to start, and the window goes on drawing. */
void desktop_expect_samples(Desktop *desktop, double samples);

/* Waits for a picture at rest with so many samples that began after what was done last. */
void desktop_expect_rest(Desktop *desktop, double samples);

/* The same in a window of so many samples (--spp), in which nothing is left to draw. A picture that the hand
 * has just left is drawn once more, so that one with all samples may still begin again. */
void desktop_expect_done(Desktop *desktop, double samples);

/* The number of that name in the last frame, and the largest in all frames since the program started. */
double desktop_number(Desktop *desktop, const char *name);
double desktop_largest(Desktop *desktop, const char *name);

/* All that was logged since the program started. */
const char *desktop_log(Desktop *desktop);

/* The screen's pixels, 0 to 255: one, and the mean over a rectangle. */
void desktop_pixel(Desktop *desktop, int x, int y, int rgb[3]);
void desktop_mean(Desktop *desktop, int x, int y, int width, int height, double rgb[3]);

/* The first pixel of a colour from a row on, as one reads; false where there is none. */
bool desktop_find(Desktop *desktop, const int rgb[3], int from, int *x, int *y);
