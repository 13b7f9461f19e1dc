/* The window's picture: films drawn straight from their textures, tone-mapped as in a PNG. */
#pragma once

#include "gl/film.h"

/* A program for each way of showing, as drivers without a GPU take every branch of a program. */
typedef enum DisplayWay {
    DISPLAY_PICTURE,
    DISPLAY_ENLARGED,
    DISPLAY_DIFFERENCE,
    DISPLAY_RAW,
    DISPLAY_WAYS
} DisplayWay;

typedef struct Display {
    Program programs[DISPLAY_WAYS];
} Display;

/* A film; over it, the rows from the top that its successor has of a first group, which stand in its back. */
typedef struct DisplaySide {
    const Film *film, *next; /* `next` may be NULL */
    int rows;
} DisplaySide;

typedef struct DisplayParams {
    DisplaySide sides[2]; /* the second may be empty */
    int width, height;    /* of the window's framebuffer; a film of another size is enlarged to it */
    double divider;       /* 0 to 1: right of it is the second side */
    double exposure_ev;
    double difference; /* radiance at the ends of the false colours that show the sides' difference; 0 shows
                          the sides */
    GLuint raw;        /* in place of the sides: a texture that is a picture already, row 0 at its bottom */
} DisplayParams;

MUST_CHECK bool display_create(Display *display, const Context *context, const char *library, Error *error);
void display_destroy(Display *display);

/* Draws on framebuffer 0. */
MUST_CHECK bool display_draw(const Display *display, const DisplayParams *params, Error *error);
