/* The converged picture that methods are judged by, made once and kept.
 *
 * Its paths take the sky from a table, which is quick; what the table itself errs is taken off again, as the
 * difference of two pictures of the same random numbers, one with the most exact of the sky's methods and one
 * with the table: that needs few samples (multilevel Monte Carlo). Two halves of independent seeds tell the
 * noise that is left. */
#pragma once

#include "chart/monitor.h"
#include "render/renderer.h"

/* The most exact sky of the shader: what all others, and the table, are judged by. */
#define REFERENCE_SKY "gauss:12"

typedef struct Reference {
    Image image;
    double error_percent;   /* relRMSE of the noise that is left, estimated */
    double trimmed_percent; /* the same without the 0.1 % of pixels where it is worst */
    bool kept;              /* it was there already */
} Reference;

/* Reads the picture at `path` if its metadata tell this identity, else makes it in about `seconds` and writes
 * it. `params`: the picture; its methods are chosen here, its seed is not used. Being stopped by the monitor
 * is no failure, but leaves no image (`image.rgba` NULL). */
MUST_CHECK bool reference_get(Reference *reference, const char *path, const char *identity,
                              const Context *context, const RenderParams *params, double seconds,
                              const Monitor *monitor, Error *error);
void reference_free(Reference *reference);

/* relRMSE of a picture in percent, without the part that is the reference's own noise; `trimmed`: without the
 * 0.1 % worst pixels, as pictures are judged that the sun itself is in. STATUS_FAILURE where a pixel is not
 * finite. */
MUST_CHECK bool reference_error(const Reference *reference, const Image *image, bool trimmed, double *percent,
                                Error *error);
