/* Draws the window's picture. Films are drawn from their textures, tone-mapped as in a PNG. */
#pragma once

#include "gl/film.h"

/* Each way of showing has a program of its own, because drivers without a GPU execute every branch of a
 * program. */
typedef enum DisplayWay {
    DISPLAY_PICTURE,
    DISPLAY_ENLARGED,
    DISPLAY_DIFFERENCE,
    DISPLAY_RAW,
    DISPLAY_CELLS,
    DISPLAY_WAYS
} DisplayWay;

typedef struct Display {
    Program programs[DISPLAY_WAYS];
    /* For film_join(). */
    Program join;
} Display;

/* A film. While the next picture's first group of samples is drawn, its rows so far are shown over the film.
 */
typedef struct DisplaySide {
    /* `next` may be NULL. */
    const Film *film, *next;
    /* The rows of `next`, from the top, that are drawn already. They are in the back of its target. */
    int rows;
} DisplaySide;

typedef struct DisplayParams {
    /* The second side may be empty. */
    DisplaySide sides[2];
    /* The size of the window's framebuffer. A film of another size is enlarged to it. */
    int width, height;
    /* The place of the divider, from 0 to 1. The second side is right of it. */
    double divider;
    double exposure_ev;
    /* If this is not 0, the sides' difference is shown in false colours. Their ends are at this radiance. */
    double difference;
    /* If this is not 0, it is a texture that is shown in place of the sides. Its row 0 is at the bottom. */
    GLuint raw;
} DisplayParams;

MUST_CHECK bool display_create(Display *display, const Context *context, const char *library, Error *error);
void display_destroy(Display *display);

/* Draws on framebuffer 0. */
MUST_CHECK bool display_draw(const Display *display, const DisplayParams *params, Error *error);

/* Draws the film's mean radiance in each cell of a grid on the back of `cells`. Its size is that of the grid.
 */
void display_cells(const Display *display, const Film *film, const Target *cells);
