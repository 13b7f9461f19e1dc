/* The pixels of a picture that hold the sun's own image. Their radiance is so large that they would decide
 * every figure alone, so that comparisons leave them out.
 *
 * A mask has one byte for each pixel, width * height in rows, row 0 at the top; other than 0 where the sun
 * is. As text, the pixels are rectangles "X,Y,WIDTH,HEIGHT" with one blank between each two. X and Y count
 * from the left and from the top. The text is empty if no pixel holds the sun. */
#pragma once

#include "base/text.h"
#include "image/attribute.h"

/* The name of the metadata that hold the text. */
#define SUN_PIXELS_ATTRIBUTE "magichour.sun_pixels"

/* Appends the pixels of the mask as text. Each run of pixels in a row is one rectangle, together with the
 * equal runs in the rows below it. */
void sun_pixels_print(const unsigned char *mask, int width, int height, Text *text);

/* Sets the mask to 1 in the pixels of the text, and leaves the others as they are. Fails with STATUS_FAILURE
 * if the text is malformed or a rectangle is empty or not inside of the picture. Some pixels may be set then.
 */
MUST_CHECK bool sun_pixels_parse(const char *text, unsigned char *mask, int width, int height, Error *error);

/* Adds the pixels of the mask to a picture's metadata, if there are any. */
void sun_pixels_describe(const unsigned char *mask, int width, int height, AttributeList *list);
