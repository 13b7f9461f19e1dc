#include "render/chain_starts.h"

#include <math.h>

static double weight_of(float weight) {
    return isfinite(weight) && weight > 0 ? (double)weight : 0;
}

double chain_starts(const float *weights, int count, double offset, int *sources) {
    double sum = 0, passed = 0;
    int source = -1, last = 0;
    for (int i = 0; i < count; i++) {
        sum += weight_of(weights[i]);
        if (weight_of(weights[i]) > 0) last = i;
    }
    for (int i = 0; i < count; i++) {
        double at = sum * (i + offset) / count;
        /* Roundings may leave the sum short of the last place. */
        while (source < last && (source < 0 || passed <= at)) passed += weight_of(weights[++source]);
        sources[i] = sum > 0 ? source : i;
    }
    return sum / count;
}
