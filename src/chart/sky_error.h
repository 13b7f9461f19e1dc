/* The error of a sky's radiances against the truth, for charts. */
#pragma once

/* In percent, over all directions and channels. */
typedef struct SkyError {
    double rms, p99, largest;
} SkyError;

/* `radiances` are 4 floats for each of `count` directions, as from sky_probe_ask(), and `truth` is 3 doubles
 * for each. The errors of darkness are taken relative to a millionth of the zenith's radiance with the sun at
 * the zenith. */
SkyError sky_error(const float *radiances, const double *truth, int count);
