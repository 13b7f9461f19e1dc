/* Where Markov chains start (render/chain_pass.h). */
#pragma once

#include <stdbool.h>

/* Each chain has found a start among candidates of its own, whose brightness sums to weights[i]. Shares the
 * starts out among all chains, in proportion to these weights, so that all chains weigh the same afterwards:
 * sources[i] is the chain whose start chain i takes. `offset` is a random number in [0,1); over it each start
 * is taken as often as its weight says, to less than one chain (systematic resampling, Carpenter et al.
 * 1999). Weights that are not finite count as 0. Returns the mean of the weights; if it is 0, each chain has
 * its own start. */
double chain_starts(const float *weights, int count, double offset, int *sources);
