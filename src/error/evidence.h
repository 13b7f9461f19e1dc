/* What is known of the light that samples have not found yet.
 *
 * The noise of a picture is estimated from samples, and light that no sample has found is in none of them.
 * Sunlight that is left to chance (gl/film.h) is such light. Its paths are counted by the material that
 * throws the light last, which is called the class of the path here. A class is met once the sun was found in
 * 50 pixels, or in half of the pixels where the class has paths if that is fewer. From then on, the changes
 * of the picture tell how noisy its light is. Before that, the error that the light is expected to make is
 * added to that of the tiles. */
#pragma once

#include "error/noise.h"
#include "render/chance.h"
#include "render/renderer.h"

/* Begins the noise of a picture: that of its film, with the sun's own image left out where it is known from
 * the start. `tone` is as for noise_create(). */
Noise evidence_begin(const Renderer *renderer, const ToneTable *tone);

/* Measures the noise of the film, whose picture is `mean`. */
void evidence_measure(Noise *noise, const Film *film, const Image *mean);

typedef struct Evidence {
    /* A bit for each material whose class is not met. */
    unsigned unmet;
    /* The share of the pixels in which there are paths of these classes. */
    double pixels;
    /* A bit for each material that throws at least a hundredth of the light that is left to chance, if that
     * light matters, and the share of the pixels that have any of it. */
    unsigned thrown;
    double thrown_pixels;
} Evidence;

/* Tells `noise` the error of the classes that are not met, and leaves out the pixels in which the sun itself
 * was seen in mirrors or glass. `mean` is the film's picture. Call it before noise_measure(). For an empty
 * map nothing happens. */
Evidence evidence_gather(Noise *noise, const ChanceMap *map, const Image *mean);

/* Whether the plan's samples tell their error at all: the paths of a Markov chain depend on each other. */
bool evidence_is_there(const Plan *plan);

/* Whether so many samples are evidence enough for a figure of the error: 16 of some pixel, and 2^20 in all if
 * the plan has light that is found only by luck. Lamps count as such, because a scene need not name them by
 * hints. */
bool evidence_suffices(const Plan *plan, uint64_t samples, uint64_t paths);

/* The parts of that rule: whether the plan has such light, and how many samples and paths are enough. */
bool evidence_needs_luck(const Plan *plan);
bool evidence_is_enough(bool luck, uint64_t samples, uint64_t paths);
