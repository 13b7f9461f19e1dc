#version 330 core
// The moments of all fields together. Each field beyond the fourth is taken to be the one before it times the same factor, which is the fourth
// field's moment 0 over the third's at each point. So the rest is a geometric series. The factor is 0.9 at most, because the ratio of two fields says
// little in air that is as good as opaque.
#include "pass/atmosphere.glsl"
#include <spectrum>
#include "sky/orders.glsl"

uniform OrderGrid sum_grid;
// The degrees of the four orders.
uniform vec4 sum_degrees;
// 1 for each of the fields 2 to 4 that counts and 0 for others, and how many fields follow the fourth (-1 for all).
uniform vec4 sum_orders;
uniform sampler2D order_1_moments;
uniform sampler2D order_2_moments;
uniform sampler2D order_3_moments;
uniform sampler2D order_4_moments;

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
vec3 sum_tail(vec3 fourth, vec3 third) {
    vec3 ratio = min(exp(fourth - third), vec3(0.9));
    vec3 left = sum_orders.w < 0.0 ? vec3(0.0) : pow(ratio, vec3(sum_orders.w + 1.0));
    return (1.0 - left) / (1.0 - ratio);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int most = int(sum_degrees.x + 0.5);
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
    vec3 third = sum_whole(order_3_moments, texel, sum_degrees.z);
    vec3 fourth = sum_whole(order_4_moments, texel, sum_degrees.w);
    vec3 whole_1 = exp(sum_whole(order_1_moments, texel, sum_degrees.x));
    vec3 whole_2 = exp(sum_whole(order_2_moments, texel, sum_degrees.y)) * sum_orders.x;
    vec3 whole_3 = exp(third) * sum_orders.y;
    vec3 whole_4 = exp(fourth) * sum_orders.z * sum_tail(fourth, third);
    vec3 whole = max(whole_1 + whole_2 + whole_3 + whole_4, vec3(ORDER_DARK));
    vec3 sum = whole_1 * sum_share(order_1_moments, texel, sum_degrees.x) + whole_2 * sum_share(order_2_moments, texel, sum_degrees.y) +
               whole_3 * sum_share(order_3_moments, texel, sum_degrees.z) + whole_4 * sum_share(order_4_moments, texel, sum_degrees.w);
    moment = vec4(tile == 0 || texel.ground ? log(whole) : sum / whole, 0.0);
}
