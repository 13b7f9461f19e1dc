/* Short labels drawn into a picture, in capitals of 3x5 points. */
#pragma once

#include "image/image.h"

/* A letter's width with the gap behind it, and its height, in points. */
enum { LABEL_ADVANCE = 4, LABEL_HEIGHT = 5 };

/* Draws the digits, + - . and the letters A B E L S V of the text in that grey, from the label's top left on.
 * A point is a square of `scale` pixels. Other characters are blanks, and what lies outside of the picture is
 * left out. */
void label_draw(Image *image, const char *text, int left, int top, int scale, float grey);
