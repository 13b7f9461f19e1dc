/* The converged picture with which pictures are compared. It is made once and kept in a file.
 *
 * Its paths use the sky's table, which is quick. The table's own error is measured and subtracted: it is the
 * difference of two pictures with the same random numbers, one with the most exact method for the sky and one
 * with the table. Such a difference needs few samples (multilevel Monte Carlo).
 *
 * The picture is the mean of two halves with independent seeds. Their difference gives the noise that is
 * left. */
#pragma once

#include "chart/monitor.h"
#include "render/renderer.h"

/* The most exact method for the sky in a shader. All others, and the table, are compared with it. */
#define REFERENCE_SKY "gauss:12"

typedef struct Reference {
    Image image;
    /* The estimated relRMSE of the noise that is left. */
    double error_percent;
    /* The same, without the worst 0.1 % of the pixels. */
    double trimmed_percent;
    /* Whether the file existed already. */
    bool kept;
} Reference;

/* Reads the picture at `path` if its metadata have this identity. Otherwise renders it in about `seconds` and
 * writes it. `params` describes the picture; its methods and its seed are not used. If the monitor stops the
 * rendering, the call succeeds and `image.rgba` is NULL. */
MUST_CHECK bool reference_get(Reference *reference, const char *path, const char *identity,
                              const Context *context, const RenderParams *params, double seconds,
                              const Monitor *monitor, Error *error);
void reference_free(Reference *reference);

/* Measures the relRMSE of a picture in percent, without the part that is the reference's own noise. If
 * `trimmed` is set, the worst 0.1 % of the pixels are left out, as for pictures with the sun's image. Fails
 * with STATUS_FAILURE if a pixel is not finite. */
MUST_CHECK bool reference_error(const Reference *reference, const Image *image, bool trimmed, double *percent,
                                Error *error);
