// Lookups of the field of an order of scattering, for the passes that compute the further orders (sky/orders.glsl).
#include "pass/order_nodes.glsl"
#include <spectrum>
#include <absorber>
#include <view-column>
#include "sky/phase.glsl"
#include "sky/sums.glsl"
#include "sky/orders.glsl"

uniform OrderGrid order_grid;
// The weights of aerosols' scattering, by degree.
uniform float order_aerosol_weight[25];

// A texture of moments, the degree up to which it has harmonics, and a place in its tiles: four texels and their weights. The interpolation is written
// out, because the hardware's has too few digits.
struct OrderPlace {
    ivec2 first;
    ivec2 last;
    vec4 weights;
};

OrderPlace order_corners(vec2 place) {
    vec2 first = min(floor(place), vec2(order_grid.columns, order_grid.rows) - 2.0);
    vec2 f = place - first;
    return OrderPlace(ivec2(first), ivec2(first) + 1, vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y));
}

// Returns the moment in the tile that begins at this row of the texture.
vec3 order_moment(sampler2D field, OrderPlace place, int row) {
    return place.weights.x * texelFetch(field, ivec2(place.first.x, row + place.first.y), 0).rgb +
           place.weights.y * texelFetch(field, ivec2(place.last.x, row + place.first.y), 0).rgb +
           place.weights.z * texelFetch(field, ivec2(place.first.x, row + place.last.y), 0).rgb +
           place.weights.w * texelFetch(field, ivec2(place.last.x, row + place.last.y), 0).rgb;
}

// Returns the light that a field scatters in the direction whose cosine to the sun is `nu`, per metre and unit of density: by air in the first
// result, by aerosols in the second. The texture has harmonics up to `degree`, and those up to `most` are used.
void order_scatter(sampler2D field, int degree, int most, int band, vec2 at, float nu, float azimuth, OUT(vec3) by_air, OUT(vec3) by_aerosols) {
    OrderPlace place = order_corners(at);
    int rows = int(order_grid.rows + 0.5);
    int base = band * (order_harmonics(degree) + 1) * rows;
    float s = sqrt(max(1.0 - nu * nu, 0.0));
    float cosine = 1.0;
    float cosine_before = azimuth;
    float start = 0.0;
    by_air = vec3(0.0);
    by_aerosols = vec3(0.0);
    int m = 0;
    do {
        start = order_start(float(m), s, start);
        float y = start;
        float y_before = 0.0;
        int row = base + order_harmonic(degree, m, m) * rows;
        int l = m;
        do {
            if (l > m) {
                vec2 turn = order_step(float(l), float(m));
                float next = turn.x * (nu * y - turn.y * y_before);
                y_before = y;
                y = next;
            }
            vec3 share = l == 0 ? vec3(1.0) : order_moment(field, place, row);
            vec3 part = share * (y * cosine);
            by_air += part * (l == 0 ? 1.0 : l == 2 ? 0.1 : 0.0);
            by_aerosols += part * order_aerosol_weight[l];
            row += rows;
            l += 1;
        } while (l <= most);
        float next = 2.0 * azimuth * cosine - cosine_before;
        cosine_before = cosine;
        cosine = next;
        m += 1;
    } while (m <= most);
    vec3 whole = exp(order_moment(field, place, base));
    by_air = max(by_air * whole, vec3(0.0));
    by_aerosols = max(by_aerosols * whole, vec3(0.0));
}

// Returns the irradiance of the ground by a field where the sun's elevation has this sine.
vec3 order_ground(sampler2D field, int degree, int band, Atmosphere air, float sine) {
    int rows = int(order_grid.rows + 0.5);
    int tiles = order_harmonics(degree) + 1;
    OrderPlace place = order_corners(order_place(order_grid, air.thickness_m, 0.0, sine));
    return exp(order_moment(field, place, (band * tiles + tiles - 1) * rows));
}

// Returns the irradiance of level ground by the sun alone, for a sun of irradiance 1.
vec3 order_sunlight(Atmosphere air, float sine) {
    float b = air.planet_radius_m * max(sine, 0.0);
    vec2 column = columns_to_top(air, 0.0, b, vec2(1.0));
    return max(sine, 0.0) * transmittance_of(air, column, absorber_column_to_top(air, 0.0, b));
}

// What a ray meets at its end.
struct OrderEnd {
    // The share of the ground's light that arrives; 0 if the ray ends at the top.
    vec3 kept;
    // The sine of the sun's elevation there.
    float sine;
};

// Returns the end of a ray from altitude h whose columns to the end are known.
OrderEnd order_end(Atmosphere air, float h, vec3 view, vec3 sun, vec2 column) {
    float r = air.planet_radius_m + h;
    float b = r * view.y;
    Segment segment = atmosphere_segment(air, h, b);
    bool ground = b < 0.0 && b * b >= h * (2.0 * air.planet_radius_m + h);
    float absorber = absorber_column_between(air, h, b, 0.0, segment.end);
    vec3 kept = transmittance_of(air, view_column(column), absorber);
    return OrderEnd(ground ? kept : vec3(0.0), (r * sun.y + segment.end * dot(view, sun)) / air.planet_radius_m);
}

// Returns the columns of air and aerosols along a ray to its end.
vec2 order_columns(Atmosphere air, float h, vec3 view) {
    float r = air.planet_radius_m + h;
    float b = r * view.y;
    Segment path = atmosphere_segment(air, h, b);
    vec2 column = vec2(0.0);
    float from = path.begin;
    int segment = 0;
    do {
        float to = gauss_cut(from, path.end, -b);
        column += gauss_nodes(air, order_gauss, h, r, b, from, to, 0.5 * (from + to) < -b).total;
        from = to;
        segment += 1;
    } while (from < path.end && segment < 2);
    return column;
}

// Returns the light that a field scatters along a ray toward the eye. The columns to the ray's end are set.
vec3 order_gather(sampler2D field, int degree, int most, int band, Atmosphere air, float h, vec3 view, vec3 sun, OUT(vec2) column_before) {
    float r = air.planet_radius_m + h;
    float b = r * view.y;
    float nu = dot(view, sun);
    Segment path = atmosphere_segment(air, h, b);
    vec3 light = vec3(0.0);
    column_before = vec2(0.0);
    float from = path.begin;
    int segment = 0;
    do {
        float to = gauss_cut(from, path.end, -b);
        bool descends = 0.5 * (from + to) < -b;
        GaussNodes nodes = gauss_nodes(air, order_gauss, h, r, b, from, to, descends);
        int i = 0;
        do {
            float t = nodes.t[i];
            float r_t = air.planet_radius_m + nodes.h[i];
            float mu_sun = (r * sun.y + t * nu) / r_t;
            vec3 by_air;
            vec3 by_aerosols;
            order_scatter(field, degree, most, band, order_place(order_grid, air.thickness_m, nodes.h[i], mu_sun), nu,
                          order_azimuth((b + t) / r_t, mu_sun, sqrt(max(1.0 - mu_sun * mu_sun, 0.0)), nu), by_air, by_aerosols);
            vec2 column = view_column(max(column_before + gauss_column(order_gauss, nodes, i, descends), vec2(0.0)));
            vec3 kept = transmittance_of(air, column, absorber_column_between(air, h, b, nodes.h[i], t));
            light += order_gauss.weight[i] * nodes.stretch[i] * kept *
                     (by_air * nodes.density[i].x * air.rayleigh_scatter_per_m + by_aerosols * nodes.density[i].y * air.mie_scatter_per_m);
            i += 1;
        } while (i < gauss_count());
        column_before += nodes.total;
        from = to;
        segment += 1;
    } while (from < path.end && segment < 2);
    return light;
}
