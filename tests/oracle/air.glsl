// The preset simmons2017, with the preset earth's ozone for those who include its layer.
#include "sky/atmosphere.glsl"

Atmosphere air() {
    return Atmosphere(6360.0e3, 60.0e3, 7994.0, 1200.0, vec3(5.8e-6, 13.5e-6, 33.1e-6), vec3(21.0e-6),
                      vec3(23.1e-6), 0.76, vec3(0.650e-6, 1.881e-6, 0.085e-6), 25.0e3, 15.0e3, vec3(20.0));
}

// How many times a rounding grows in a segment's ends: both are roots of differences, of which little is left in rays
// that graze the ground, or the top from above.
float grazing_condition(Atmosphere a, float h, float b) {
    float squared = b * b;
    float ground = abs(squared - h * (2.0 * a.planet_radius_m + h));
    float above = h - a.thickness_m;
    float top = abs(squared - above * (2.0 * a.planet_radius_m + h + a.thickness_m));
    float least = h > a.thickness_m ? min(ground, top) : ground;
    return sqrt(1.0 + squared / max(least, 1.0e-6));
}
