#include "color/noise.glsl"
#include "distance/deform.glsl"

// Surfaces and spaces made uneven by the noises of color/noise.glsl. `spacing` is the distance in metres between the random values of a noise, about
// the size of its bumps.
//
// The slope of noise() is at most NOISE_SLOPE, which is the slope of the quintic in its middle, as in one dimension. To see this, draw a corner of the
// cell: on each axis i the upper one with the probability s_i of the quintic. The noise is the mean of the corner's value. By Bessel's inequality its
// derivatives D_i by s_i obey sum(D_i^2 s_i (1 - s_i)) <= 1/4, the largest variance of values in [0,1]. The quintic's slope is at most
// 2 NOISE_SLOPE sqrt(s_i (1 - s_i)), so the squares of the noise's slopes along the axes sum to NOISE_SLOPE^2 at most.
const float NOISE_SLOPE = 1.875;

// The slope of noise_octaves() is at most this. No place is the steepest of two octaves in the same direction. A search over all places, directions and
// corner values finds that the octaves' slopes sum to 3.318 for two octaves and 4.981 for three, and that each further octave adds 1.655 on average.
float noise_octaves_slope(int octaves) {
    return max(NOISE_SLOPE, 1.67 * float(octaves)) / (2.0 - exp2(1.0 - float(octaves)));
}

// Raises a surface at the point p by noise(), 0 to `height` metres high. The result changes by at most one metre a metre, but is less than the distance.
float op_noise(float d, vec3 p, float height, float spacing) {
    return op_displace_within(d, height * noise(p / spacing), height * NOISE_SLOPE / spacing, height);
}

// The same by noise_octaves(), whose first octave has that spacing.
float op_noise_octaves(float d, vec3 p, float height, float spacing, int octaves) {
    float slope = height * noise_octaves_slope(octaves) / spacing;
    return op_displace_within(d, height * noise_octaves(p / spacing, octaves), slope, height);
}

// Moves the point p by up to `amplitude` metres along each axis, as distance_box(op_warp(p, ...), ...): what was straight becomes crooked. Divide the
// distance by the steepness.
vec3 op_warp(vec3 p, float amplitude, float spacing) {
    return p + amplitude * (2.0 * noise_vector(p / spacing) - 1.0);
}

float op_warp_steepness(float amplitude, float spacing) {
    return 1.0 + sqrt(3.0) * 2.0 * abs(amplitude) * NOISE_SLOPE / spacing;
}
