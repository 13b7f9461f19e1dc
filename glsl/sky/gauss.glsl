// Gauss-Legendre along the view ray, GAUSS_NODES a segment (a constant that the host provides), with columns toward the sun
// in closed form and columns back to the eye from the same nodes.
//
// The ray is cut at its perigee, at the planet's shadow, and where sunlight has passed half a scale height above the ground: just
// outside of the shadow it collapses within a short stretch (this cut takes the largest errors of 8 nodes from 4.3 to 1.7 %).
// So the integrand is smooth in each segment. In a segment of
// length L that ascends, node u of (0,1) lies at t = L c u / (1 + c - u): nodes crowd where the air is dense. One that
// descends takes the mirror image. The column up to node i is the integral of the polynomial through all nodes' densities:
// a matrix times what is there already, no further exponentials.
#include "sky/column.glsl"
#include "sky/sums.glsl"

float absorber_column_to_top(Atmosphere a, float h, float b);
float absorber_column_between(Atmosphere a, float h, float b, float h_t, float t);

const float GAUSS_CROWDING = 0.5; // c; measured best, or near it, for 4 to 12 nodes

struct GaussTable {
    float node[12];        // in (0,1), ascending
    float weight[12];      // they sum to 1
    float cumulative[144]; // [12 i + j]: integral from 0 to node i of the polynomial that is 1 at node j, 0 at the others
};

const int GAUSS_SEGMENTS = 6; // at most: two shadows' four ends and the perigee make five cuts

float gauss_cut(float from, float cut, float candidate) {
    return candidate > from && candidate < cut ? candidate : cut;
}

SkySums sky_gauss(Atmosphere a, GaussTable table, float h, vec3 view, vec3 sun) {
    float r = a.planet_radius_m + h;
    float b = r * view.y;
    float nu = dot(view, sun);
    Segment air = atmosphere_segment(a, h, b);
    Segment shadow = shadow_segment(a, 0.0, h, b, view, sun);
    Segment dusk = shadow_segment(a, 0.5 * a.rayleigh_scale_height_m, h, b, view, sun);
    SkySums sums = SkySums(vec3(0.0), vec3(0.0));
    vec2 column_before = vec2(0.0);
    float from = air.begin;
    int segment = 0;
    do {
        float to = gauss_cut(from, air.end, -b);
        to = gauss_cut(from, gauss_cut(from, to, shadow.begin), shadow.end);
        to = gauss_cut(from, gauss_cut(from, to, dusk.begin), dusk.end);
        float middle = 0.5 * (from + to);
        bool descends = middle < -b;
        bool dark = in_planet_shadow(a, altitude_along(h, r, b, middle), r * sun.y + middle * nu);
        float t[GAUSS_NODES];
        float h_t[GAUSS_NODES];
        vec2 density[GAUSS_NODES];
        float stretch[GAUSS_NODES]; // dt/du
        vec2 total = vec2(0.0);
        for (int i = 0; i < GAUSS_NODES; i++) {
            float u = table.node[i];
            float s = 1.0 / (1.0 + GAUSS_CROWDING - u);
            float x = (to - from) * GAUSS_CROWDING * u * s;
            t[i] = descends ? to - x : from + x;
            h_t[i] = altitude_along(h, r, b, t[i]);
            density[i] = densities(a, h_t[i]);
            stretch[i] = (to - from) * GAUSS_CROWDING * (1.0 + GAUSS_CROWDING) * s * s;
            total += table.weight[i] * stretch[i] * density[i];
        }
        for (int i = 0; i < GAUSS_NODES; i++) {
            vec2 column = vec2(0.0);
            for (int j = 0; j < GAUSS_NODES; j++) column += table.cumulative[12 * i + j] * stretch[j] * density[j];
            column = max(column_before + (descends ? total - column : column), vec2(0.0));
            float b_sun = r * sun.y + t[i] * nu;
            column += columns_to_top(a, h_t[i], b_sun, density[i]);
            float absorber = absorber_column_between(a, h, b, h_t[i], t[i]) + absorber_column_to_top(a, h_t[i], b_sun);
            vec3 light = transmittance_of(a, column, absorber);
            light *= dark ? 0.0 : table.weight[i] * stretch[i];
            sums.rayleigh += light * density[i].x;
            sums.mie += light * density[i].y;
        }
        column_before += total;
        from = to;
        segment += 1;
    } while (from < air.end && segment < GAUSS_SEGMENTS);
    return sums;
}
