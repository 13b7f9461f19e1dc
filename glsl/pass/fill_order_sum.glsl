#version 330 core
// The moments of all fields together. Each field beyond the fifth is taken to be the one before it times the same factor, which is the fifth
// field's moment 0 over the fourth's at each point. So the rest is a geometric series. The factor is 0.9 at most, because the ratio of two fields says
// little in air that is as good as opaque.
#include "pass/atmosphere.glsl"
#include <spectrum>
#include "sky/orders.glsl"

uniform OrderGrid sum_grid;
// The degrees of the five fields.
uniform float sum_degrees[5];
// 1 for each field that counts, and 0 for others.
uniform float sum_counts[5];
// How many fields follow the fifth; -1 for all.
uniform float sum_following;
uniform sampler2D order_1_moments;
uniform sampler2D order_2_moments;
uniform sampler2D order_3_moments;
uniform sampler2D order_4_moments;
uniform sampler2D order_5_moments;

out vec4 moment;

// What a texel stands for: a harmonic at a point, or the irradiance of the ground.
struct SumTexel {
    int band;
    ivec2 point;
    bool ground;
    // The harmonic's degree and its turns about the axis.
    int l;
    int m;
};

// Returns the texel's row in a texture of moments up to this degree. If `whole` is set, it is the row of what the texel is a share of: of moment 0,
// or of the ground's irradiance.
int sum_row(SumTexel texel, float degree, bool whole) {
    int most = int(degree + 0.5);
    int tiles = order_harmonics(most) + 1;
    int tile = texel.ground ? tiles - 1 : whole ? 0 : order_harmonic(most, texel.l, texel.m);
    return (texel.band * tiles + tile) * int(sum_grid.rows + 0.5) + texel.point.y;
}

// Returns the logarithm of a field's moment 0, or of its irradiance of the ground if the texel stands for that.
vec3 sum_whole(sampler2D moments, SumTexel texel, float degree) {
    return texelFetch(moments, ivec2(texel.point.x, sum_row(texel, degree, true)), 0).rgb;
}

// Returns a field's moment as a share of moment 0. It is 0 if the field has no harmonics of that degree.
vec3 sum_share(sampler2D moments, SumTexel texel, float degree) {
    ivec2 at = ivec2(texel.point.x, sum_row(texel, degree, false));
    return float(texel.l) > degree + 0.5 ? vec3(0.0) : texelFetch(moments, at, 0).rgb;
}

// Returns by how much the fourth field is to be multiplied, to stand for those that follow it too. The arguments are logarithms.
vec3 sum_tail(vec3 fifth, vec3 fourth) {
    vec3 ratio = min(exp(fifth - fourth), vec3(0.9));
    vec3 left = sum_following < 0.0 ? vec3(0.0) : pow(ratio, vec3(sum_following + 1.0));
    return (1.0 - left) / (1.0 - ratio);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int most = int(sum_degrees[0] + 0.5);
    int rows = int(sum_grid.rows + 0.5);
    int tiles = order_harmonics(most) + 1;
    int tile = (at.y / rows) % tiles;
    SumTexel texel = SumTexel(at.y / (rows * tiles), ivec2(at.x, at.y % rows), tile == tiles - 1, 0, 0);
    int first = 0;
    while (!texel.ground && tile - first > most - texel.m) {
        first += most + 1 - texel.m;
        texel.m += 1;
    }
    texel.l = texel.ground ? 0 : texel.m + tile - first;
    vec3 fourth = sum_whole(order_4_moments, texel, sum_degrees[3]);
    vec3 fifth = sum_whole(order_5_moments, texel, sum_degrees[4]);
    vec3 whole_1 = sum_counts[0] * exp(sum_whole(order_1_moments, texel, sum_degrees[0]));
    vec3 whole_2 = sum_counts[1] * exp(sum_whole(order_2_moments, texel, sum_degrees[1]));
    vec3 whole_3 = sum_counts[2] * exp(sum_whole(order_3_moments, texel, sum_degrees[2]));
    vec3 whole_4 = sum_counts[3] * exp(fourth);
    vec3 whole_5 = sum_counts[4] * exp(fifth) * sum_tail(fifth, fourth);
    vec3 whole = max(whole_1 + whole_2 + whole_3 + whole_4 + whole_5, vec3(ORDER_DARK));
    vec3 sum = whole_1 * sum_share(order_1_moments, texel, sum_degrees[0]) + whole_2 * sum_share(order_2_moments, texel, sum_degrees[1]) +
               whole_3 * sum_share(order_3_moments, texel, sum_degrees[2]) + whole_4 * sum_share(order_4_moments, texel, sum_degrees[3]) +
               whole_5 * sum_share(order_5_moments, texel, sum_degrees[4]);
    moment = vec4(tile == 0 || texel.ground ? log(whole) : sum / whole, 0.0);
}
