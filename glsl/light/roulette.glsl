#include "math/dialect.glsl"

// Russian roulette from this hit on; a survival below 1 ends even the paths that lose nothing.
const int ROULETTE_HITS = 4;
const float ROULETTE_SURVIVAL = 0.95;

// The probability of going on after so many hits; 0 for a path that is worth nothing.
float roulette_survival(vec3 throughput, int hits) {
    float brightest = max(throughput.x, max(throughput.y, throughput.z));
    float late = min(brightest, ROULETTE_SURVIVAL);
    float survival = hits < ROULETTE_HITS ? 1.0 : late;
    return brightest <= 0.0 ? 0.0 : survival;
}
