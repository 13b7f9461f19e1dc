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
#include "error/noise.h"
#include "render/renderer.h"

/* The most exact method for the sky in a shader. All others, and the table, are compared with it. */
#define REFERENCE_SKY "gauss:12"

typedef struct Reference {
    Image image;
    /* 1 for each pixel that holds the sun's own image; no error counts these. */
    unsigned char *sun;
    /* The estimated noise that is left: the relRMSE in percent, and the RMS in levels. */
    double noise[NOISE_MEASURES];
    double exposure_ev;
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

/* Measures the error of a picture, relRMSE in percent or RMS in levels, without the part that is the
 * reference's own noise. Fails with STATUS_FAILURE if a pixel is not finite. */
MUST_CHECK bool reference_error(const Reference *reference, const Image *image, NoiseMeasure measure,
                                double *value, Error *error);
