// Gauss-Legendre quadrature along the view ray, with gauss_count() nodes a segment, GAUSS_NODES at most. The includer defines both. Columns toward
// the sun are in closed form, and columns back to the eye come from the densities at the nodes.
//
// The ray is cut where the integrand is not smooth: at its perigee, at the planet's shadow, and where sunlight has passed half a scale height above
// the ground. Just outside of the shadow, sunlight falls to nothing within a short distance. The last cut reduces the largest error of 8 nodes from
// 4.3 to 1.7 %.
//
// In a segment of length L that ascends, the node u of (0,1) lies at t = L c u / (1 + c - u), so that nodes crowd where the air is dense. A segment
// that descends uses the mirror image. The column up to node i is the integral of the polynomial through the densities at all nodes. This is a matrix
// times these densities, and needs no further exponentials.
#include "sky/column.glsl"
#include "sky/sums.glsl"

float absorber_column_to_top(Atmosphere a, float h, float b);
float absorber_column_between(Atmosphere a, float h, float b, float h_t, float t);
// What the columns of air and aerosols between the eye and a point count.
vec2 view_column(vec2 column);

// The c of the formula above. This value is the best or near to it for 4 to 12 nodes, by measurement.
const float GAUSS_CROWDING = 0.5;

struct GaussTable {
    // In (0,1) and ascending.
    float node[GAUSS_NODES];
    // The sum of the weights is 1.
    float weight[GAUSS_NODES];
    // The number at GAUSS_NODES i + j is the integral, from 0 to node i, of the polynomial that is 1 at node j and 0 at the other nodes.
    float cumulative[GAUSS_NODES * GAUSS_NODES];
};

// The largest number of segments. The perigee and the four ends of two shadows make five cuts.
const int GAUSS_SEGMENTS = 6;

// The nodes of a segment.
struct GaussNodes {
    float t[GAUSS_NODES];
    float h[GAUSS_NODES];
    vec2 density[GAUSS_NODES];
    // dt/du at the nodes.
    float stretch[GAUSS_NODES];
    // The columns of the whole segment.
    vec2 total;
};

float gauss_cut(float from, float cut, float candidate) {
    return candidate > from && candidate < cut ? candidate : cut;
}

GaussNodes gauss_nodes(Atmosphere a, GaussTable table, float h, float r, float b, float from, float to, bool descends) {
    GaussNodes nodes;
    nodes.total = vec2(0.0);
    for (int i = 0; i < gauss_count(); i++) {
        float u = table.node[i];
        float s = 1.0 / (1.0 + GAUSS_CROWDING - u);
        float x = (to - from) * GAUSS_CROWDING * u * s;
        float before = to - x;
        float after = from + x;
        nodes.t[i] = descends ? before : after;
        nodes.h[i] = altitude_along(h, r, b, nodes.t[i]);
        nodes.density[i] = densities(a, nodes.h[i]);
        nodes.stretch[i] = (to - from) * GAUSS_CROWDING * (1.0 + GAUSS_CROWDING) * s * s;
        nodes.total += table.weight[i] * nodes.stretch[i] * nodes.density[i];
    }
    return nodes;
}

// Returns the columns from the segment's begin to node i.
vec2 gauss_column(GaussTable table, GaussNodes nodes, int i, bool descends) {
    vec2 column = vec2(0.0);
    for (int j = 0; j < gauss_count(); j++) column += table.cumulative[GAUSS_NODES * i + j] * nodes.stretch[j] * nodes.density[j];
    vec2 rest = nodes.total - column;
    return descends ? rest : column;
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
        GaussNodes nodes = gauss_nodes(a, table, h, r, b, from, to, descends);
        for (int i = 0; i < gauss_count(); i++) {
            vec2 column = view_column(max(column_before + gauss_column(table, nodes, i, descends), vec2(0.0)));
            float b_sun = r * sun.y + nodes.t[i] * nu;
            column += columns_to_top(a, nodes.h[i], b_sun, nodes.density[i]);
            float absorber = absorber_column_between(a, h, b, nodes.h[i], nodes.t[i]) + absorber_column_to_top(a, nodes.h[i], b_sun);
            float lit = table.weight[i] * nodes.stretch[i];
            sky_sums_add(sums, a, dark ? 0.0 : lit, nodes.density[i], column, absorber);
        }
        column_before += nodes.total;
        from = to;
        segment += 1;
    } while (from < air.end && segment < GAUSS_SEGMENTS);
    return sums;
}
