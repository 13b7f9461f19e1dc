// The nodes of the quadrature along a ray, for the passes that compute the further orders. Where the nodes lie and how much light arrives from them
// depends on the altitude of the ray's origin and on the ray's elevation, and neither on the sun nor on the azimuth. So it is computed once, and rays
// that differ in these alone share it. A texel stands for a node of a ray.
//
// Texture 0 holds a factor for the light that the air scatters and, in its fourth channel, the node's distance from the origin. The factor is the
// coefficient of scattering, times the length for which the node stands, times the transmittance to the origin. Texture 1 holds the same for
// aerosols, and the node's altitude. Behind the nodes is one more texel. Texture 0 then holds the share of the ground's light that arrives, which is
// 0 if the ray ends at the top of the air, and the ray's length. The fourth channel of texture 1 is then the number of nodes. A ray that passes its
// perigee is cut there, and has twice as many as others.
#include <spectrum>
#include <absorber>
#include <view-column>
#include "sky/column.glsl"
#include "sky/sums.glsl"

// The nodes of a segment (GaussTable in sky/gauss.glsl).
uniform int ray_nodes;
uniform float ray_node[12];
uniform float ray_weight[12];
uniform float ray_cumulative[144];

// How far nodes crowd where the air is dense, as in sky/gauss.glsl.
const float RAY_CROWDING = 0.5;

// A part of a ray, as distances from its origin, and whether it descends all along.
struct RaySegment {
    float from;
    float to;
    bool descends;
};

// Returns the distance of node i, and in y the derivative of the distance by the node's coordinate.
vec2 ray_at(RaySegment segment, int i) {
    float u = ray_node[i];
    float s = 1.0 / (1.0 + RAY_CROWDING - u);
    float length = segment.to - segment.from;
    float x = length * RAY_CROWDING * u * s;
    return vec2(segment.descends ? segment.to - x : segment.from + x, length * RAY_CROWDING * (1.0 + RAY_CROWDING) * s * s);
}

// Returns the columns from the segment's begin to node i, or those of the whole segment if i is -1.
vec2 ray_columns(Atmosphere air, float h, float r, float b, RaySegment segment, int i) {
    vec2 column = vec2(0.0);
    vec2 total = vec2(0.0);
    int j = 0;
    do {
        vec2 at = ray_at(segment, j);
        vec2 density = densities(air, altitude_along(h, r, b, at.x)) * at.y;
        total += ray_weight[j] * density;
        column += i < 0 ? vec2(0.0) : ray_cumulative[ray_nodes * max(i, 0) + j] * density;
        j += 1;
    } while (j < ray_nodes);
    return i < 0 ? total : segment.descends ? total - column : column;
}

// Computes texel number i, in both textures, of a ray that starts at altitude h and whose elevation there has the sine `mu`.
void ray_texel(Atmosphere air, float h, float mu, int i, OUT(vec4) by_air, OUT(vec4) by_aerosols) {
    float r = air.planet_radius_m + h;
    float b = r * mu;
    Segment path = atmosphere_segment(air, h, b);
    bool passes = -b > path.begin && -b < path.end;
    RaySegment first = RaySegment(path.begin, passes ? -b : path.end, passes || 0.5 * (path.begin + path.end) < -b);
    RaySegment second = RaySegment(first.to, path.end, false);
    bool last = i == 2 * ray_nodes;
    bool in_second = i >= ray_nodes && !last;
    int node = last ? -1 : in_second ? i - ray_nodes : i;
    vec2 column = vec2(0.0);
    if (in_second || last) column = ray_columns(air, h, r, b, first, -1);
    if (!in_second && !last) column = ray_columns(air, h, r, b, first, node);
    if (in_second || (last && passes)) column += ray_columns(air, h, r, b, second, node);
    vec2 at = last ? vec2(path.end, 0.0) : in_second ? ray_at(second, node) : ray_at(first, node);
    float h_t = last ? 0.0 : altitude_along(h, r, b, at.x);
    vec3 kept = transmittance_of(air, view_column(max(column, vec2(0.0))), absorber_column_between(air, h, b, h_t, at.x));
    if (last) {
        bool ground = b < 0.0 && b * b >= h * (2.0 * air.planet_radius_m + h);
        by_air = vec4(ground ? kept : vec3(0.0), at.x);
        by_aerosols = vec4(0.0, 0.0, 0.0, float(passes ? 2 * ray_nodes : ray_nodes));
        return;
    }
    vec2 scattered = densities(air, h_t) * (ray_weight[node] * at.y);
    by_air = vec4(kept * air.rayleigh_scatter_per_m * scattered.x, at.x);
    by_aerosols = vec4(kept * air.mie_scatter_per_m * scattered.y, h_t);
}
