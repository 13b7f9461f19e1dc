// Mist that turns light as Henyey and Greenstein's function says.
#include "mist/phase.glsl"

// The phase function over the density of henyey_sample().
float mist_phase_weight(float g, float cosine) {
    return 1.0;
}
