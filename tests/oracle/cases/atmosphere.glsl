// a: altitude, cosine of the zenith angle, distance. c: altitude there, distance to the top, the segment's begin and
// end; d: the planet's shadow, and the condition of the altitude and of the rest.
#include "../air.glsl"
#include "../item.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    Atmosphere planet = air();
    float h = a.x;
    float r = planet.planet_radius_m + h;
    float along = r * a.y;
    float t = a.z;
    float altitude = altitude_along(h, r, along, t);
    Segment segment = atmosphere_segment(planet, h, along);
    c = vec4(altitude, distance_to_top(planet, min(h, planet.thickness_m), along), segment.begin, segment.end);

    // A difference is as uncertain as its terms.
    float terms = h + t * (2.0 * abs(along) + t) / (2.0 * r);
    d = vec4(in_planet_shadow(planet, h, along) ? 1.0 : 0.0, 1.0 + terms / max(altitude, 1200.0),
             grazing_condition(planet, h, along), 0.0);
}
