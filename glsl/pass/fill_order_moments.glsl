#version 330 core
// The moments of a field (sky/orders.glsl), one in each texel: a sum over all directions of the field. The last tile of a band has the irradiance of
// the ground in place of a moment.
#include "pass/atmosphere.glsl"
#include <spectrum>
#include "sky/orders.glsl"

uniform OrderGrid moments_grid;
uniform int moments_degree;
// The number of directions.
uniform int moments_directions;
// The outputs of pass/fill_order_first.glsl or pass/fill_order_next.glsl.
uniform sampler2D order_light;
uniform sampler2D order_angles;

out vec4 moment;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int rows = int(moments_grid.rows + 0.5);
    int columns = int(moments_grid.columns + 0.5);
    int tiles = order_harmonics(moments_degree) + 1;
    int tile = (texel.y / rows) % tiles;
    int band = texel.y / (rows * tiles);
    int row = texel.y % rows;
    bool ground = tile == tiles - 1;
    // The harmonic's m (`order` here) and its degree.
    int order = 0;
    int first = 0;
    while (!ground && tile - first > moments_degree - order) {
        first += moments_degree + 1 - order;
        order += 1;
    }
    int degree = order + tile - first;
    vec3 sum = vec3(0.0);
    vec3 whole = vec3(0.0);
    int i = 0;
    do {
        ivec2 at = ivec2(i, (band * rows + row) * columns + texel.x);
        vec3 light = texelFetch(order_light, at, 0).rgb;
        vec3 angles = texelFetch(order_angles, at, 0).xyz;
        float nu = angles.x;
        float azimuth = angles.y;
        float s = sqrt(max(1.0 - nu * nu, 0.0));
        float cosine = 1.0;
        float cosine_before = azimuth;
        float y = order_start(0.0, s, 0.0);
        whole += light * y;
        int m = 0;
        while (m < order) {
            m += 1;
            y = order_start(float(m), s, y);
            float next = 2.0 * azimuth * cosine - cosine_before;
            cosine_before = cosine;
            cosine = next;
        }
        float y_before = 0.0;
        int l = order;
        while (l < degree) {
            l += 1;
            vec2 turn = order_step(float(l), float(order));
            float next = turn.x * (nu * y - turn.y * y_before);
            y_before = y;
            y = next;
        }
        sum += light * (ground ? max(angles.z, 0.0) : y * cosine);
        i += 1;
    } while (i < moments_directions);
    vec3 share = vec3(whole.r > ORDER_DARK ? sum.r / whole.r : 0.0, whole.g > ORDER_DARK ? sum.g / whole.g : 0.0,
                      whole.b > ORDER_DARK ? sum.b / whole.b : 0.0);
    moment = vec4(tile == 0 || ground ? log(max(sum, vec3(ORDER_DARK))) : share, 0.0);
}
