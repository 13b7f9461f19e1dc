#version 330 core
// The moments of all fields together. Beyond the fourth order each is taken to be the one before times the same factor, so that the rest is a
// geometric series.
#include "pass/atmosphere.glsl"
#include <spectrum>
#include "sky/orders.glsl"

uniform OrderGrid sum_grid;
// The degree of order 1, and of the others.
uniform int sum_first_degree;
uniform int sum_degree;
// Which orders count, from the second on, and how many orders follow the fourth (-1: all).
uniform vec4 sum_orders;
uniform sampler2D order_1_moments;
uniform sampler2D order_2_moments;
uniform sampler2D order_3_moments;
uniform sampler2D order_4_moments;

out vec4 moment;

// The factor of the fourth order for those that follow it.
vec3 order_tail(vec3 fourth, vec3 third) {
    vec3 ratio = min(exp(fourth - third), vec3(0.9));
    vec3 left = sum_orders.w < 0.0 ? vec3(0.0) : pow(ratio, vec3(sum_orders.w + 1.0));
    return (1.0 - left) / (1.0 - ratio);
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int rows = int(sum_grid.rows + 0.5);
    int tiles = order_harmonics(sum_first_degree) + 1;
    int tile = (texel.y / rows) % tiles;
    int band = texel.y / (rows * tiles);
    int row = texel.y % rows;
    bool ground = tile == tiles - 1;
    int order = 0;
    int first = 0;
    while (!ground && tile - first > sum_first_degree - order) {
        first += sum_first_degree + 1 - order;
        order += 1;
    }
    int degree = order + tile - first;
    // Where the others have this tile, and their moment 0.
    int other_tiles = order_harmonics(sum_degree) + 1;
    int other = ground ? other_tiles - 1 : order_harmonic(sum_degree, degree, order);
    bool shared_tile = ground || degree <= sum_degree;
    ivec2 at = ivec2(texel.x, (band * other_tiles + other) * rows + row);
    ivec2 root = ivec2(texel.x, (band * other_tiles + (ground ? other : 0)) * rows + row);
    ivec2 first_root = ivec2(texel.x, (band * tiles + (ground ? tile : 0)) * rows + row);
    vec3 log_1 = texelFetch(order_1_moments, first_root, 0).rgb;
    vec3 log_2 = texelFetch(order_2_moments, root, 0).rgb;
    vec3 log_3 = texelFetch(order_3_moments, root, 0).rgb;
    vec3 log_4 = texelFetch(order_4_moments, root, 0).rgb;
    vec3 whole_1 = exp(log_1);
    vec3 whole_2 = exp(log_2) * sum_orders.x;
    vec3 whole_3 = exp(log_3) * sum_orders.y;
    vec3 whole_4 = exp(log_4) * sum_orders.z * order_tail(log_4, log_3);
    vec3 whole = whole_1 + whole_2 + whole_3 + whole_4;
    if (tile == 0 || ground) {
        moment = vec4(log(max(whole, vec3(ORDER_DARK))), 0.0);
        return;
    }
    vec3 sum = whole_1 * texelFetch(order_1_moments, texel, 0).rgb;
    if (shared_tile) {
        sum += whole_2 * texelFetch(order_2_moments, at, 0).rgb + whole_3 * texelFetch(order_3_moments, at, 0).rgb +
               whole_4 * texelFetch(order_4_moments, at, 0).rgb;
    }
    moment = vec4(sum / max(whole, vec3(ORDER_DARK)), 0.0);
}
