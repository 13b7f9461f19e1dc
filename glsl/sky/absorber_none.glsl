// There is no absorbing layer. The compiler removes these functions, so the layer costs nothing.
#include "sky/atmosphere.glsl"

float absorber_density(Atmosphere a, float h) {
    return 0.0;
}

float absorber_column_to_top(Atmosphere a, float h, float b) {
    return 0.0;
}

float absorber_column_between(Atmosphere a, float h, float b, float h_t, float t) {
    return 0.0;
}
