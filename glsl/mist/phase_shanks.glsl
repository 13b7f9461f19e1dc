// Mist that turns light as the function of Cornette and Shanks 1992 says, which is nearer to that of droplets. Its directions are drawn by Henyey and
// Greenstein's, and weighed.
#include "mist/phase.glsl"

// The phase function over the density of henyey_sample(); at most 3 / (2 + g^2).
float mist_phase_weight(float g, float cosine) {
    return 1.5 * (1.0 + cosine * cosine) / (2.0 + g * g);
}
