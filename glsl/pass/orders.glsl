// What a field of light scatters at a point, on the ground and along a ray, for the passes that compute the further orders (sky/orders.glsl). The
// includer defines the constant ORDER_BANDS, the number of bands that are computed together: harmonics and places are the same for all bands.
#include <spectrum>
#include <absorber>
#include "sky/column.glsl"
#include "sky/orders.glsl"
#include "sky/sums.glsl"

uniform OrderGrid order_grid;
// The weights of scattering by aerosols, by the harmonics' degree.
uniform float order_aerosol_weight[25];

// A place in the tiles of a texture of moments: the first and the last of four texels, and the weights of the four. The interpolation is written out,
// because samplers may compute weights to eight bits only.
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

// Returns what the tile that begins at this row of the texture holds at a place.
vec3 order_moment(sampler2D field, OrderPlace place, int row) {
    return place.weights.x * texelFetch(field, ivec2(place.first.x, row + place.first.y), 0).rgb +
           place.weights.y * texelFetch(field, ivec2(place.last.x, row + place.first.y), 0).rgb +
           place.weights.z * texelFetch(field, ivec2(place.first.x, row + place.last.y), 0).rgb +
           place.weights.w * texelFetch(field, ivec2(place.last.x, row + place.last.y), 0).rgb;
}

// What a field scatters, for ORDER_BANDS bands.
struct OrderLight {
    vec3 by_air[ORDER_BANDS];
    vec3 by_aerosols[ORDER_BANDS];
};

// Returns the radiance that a field scatters into a direction, divided by the coefficient of scattering and the length, for ORDER_BANDS bands from
// `band` on. `nu` is the direction's cosine to the sun, and `azimuth` is the cosine of its azimuth about the sun. The texture has harmonics up to
// `degree`, of which those up to `most` are used. Where the sum of harmonics is below 0, which the true radiance never is, 0 is returned.
OrderLight order_scatter(sampler2D field, int degree, int most, int band, vec2 at, float nu, float azimuth) {
    OrderPlace place = order_corners(at);
    int rows = int(order_grid.rows + 0.5);
    int band_rows = (order_harmonics(degree) + 1) * rows;
    int base = band * band_rows;
    OrderLight light;
    for (int k = 0; k < ORDER_BANDS; k++) {
        light.by_air[k] = vec3(0.0);
        light.by_aerosols[k] = vec3(0.0);
    }
    float s = sqrt(max(1.0 - nu * nu, 0.0));
    float cosine = 1.0;
    float cosine_before = azimuth;
    float start = 0.0;
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
            float harmonic = y * cosine;
            float air_weight = l == 0 ? 1.0 : l == 2 ? 0.1 : 0.0;
            float aerosol_weight = order_aerosol_weight[l];
            for (int k = 0; k < ORDER_BANDS; k++) {
                vec3 share = l == 0 ? vec3(1.0) : order_moment(field, place, row + k * band_rows);
                light.by_air[k] += share * (harmonic * air_weight);
                light.by_aerosols[k] += share * (harmonic * aerosol_weight);
            }
            row += rows;
            l += 1;
        } while (l <= most);
        float next = 2.0 * azimuth * cosine - cosine_before;
        cosine_before = cosine;
        cosine = next;
        m += 1;
    } while (m <= most);
    for (int k = 0; k < ORDER_BANDS; k++) {
        vec3 whole = exp(order_moment(field, place, base + k * band_rows));
        light.by_air[k] = max(light.by_air[k] * whole, vec3(0.0));
        light.by_aerosols[k] = max(light.by_aerosols[k] * whole, vec3(0.0));
    }
    return light;
}

// Returns the irradiance of level ground by a field, where the sun's elevation has this sine.
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

// Where aerosols scatter less than this share of what the air scatters, their harmonics beyond degree 2 are left out.
const float ORDER_CLEAR = 1.0e-4;

// The nodes of the rays along which light is gathered (pass/rays.glsl).
uniform sampler2D rays_air;
uniform sampler2D rays_aerosols;
// The number of nodes of a ray that does not pass its perigee.
uniform int rays_nodes;

struct OrderRay {
    // The texel of its first node.
    ivec2 texel;
    // The distance of the ray's origin from the planet's centre, times the sine of the ray's elevation there, and times that of the sun's.
    float b;
    float b_sun;
    // The cosine between the ray and the sun.
    float nu;
};

OrderRay order_ray(Atmosphere air, float h, vec3 view, vec3 sun, ivec2 texel) {
    float r = air.planet_radius_m + h;
    return OrderRay(texel, r * view.y, r * sun.y, dot(view, sun));
}

// Returns the share of the ground's light that arrives at the ray's origin, for the band whose ray lies `rows` rows behind `ray`. It is 0 for a ray
// that ends at the top of the air.
vec3 order_end_kept(OrderRay ray, int rows) {
    return texelFetch(rays_air, ray.texel + ivec2(2 * rays_nodes, rows), 0).rgb;
}

// Returns the sine of the sun's elevation at the end of a ray that ends at the ground.
float order_end_sine(Atmosphere air, OrderRay ray) {
    float length = texelFetch(rays_air, ray.texel + ivec2(2 * rays_nodes, 0), 0).a;
    return (ray.b_sun + length * ray.nu) / air.planet_radius_m;
}

// Computes the radiance that a field scatters along a ray toward its origin, as far as it arrives there, for ORDER_BANDS bands from `band` on. A
// band's ray lies `ray_rows` rows behind that of the band before.
void order_gather(sampler2D field, int degree, int most, int band, Atmosphere air, OrderRay ray, int ray_rows, OUT(vec3) light[ORDER_BANDS]) {
    int nodes = int(texelFetch(rays_aerosols, ray.texel + ivec2(2 * rays_nodes, 0), 0).a + 0.5);
    for (int k = 0; k < ORDER_BANDS; k++) light[k] = vec3(0.0);
    int i = 0;
    do {
        vec4 air_node = texelFetch(rays_air, ray.texel + ivec2(i, 0), 0);
        vec4 aerosols_node = texelFetch(rays_aerosols, ray.texel + ivec2(i, 0), 0);
        float t = air_node.a;
        float h = aerosols_node.a;
        float r = air.planet_radius_m + h;
        float mu_sun = (ray.b_sun + t * ray.nu) / r;
        float azimuth = order_azimuth((ray.b + t) / r, mu_sun, sqrt(max(1.0 - mu_sun * mu_sun, 0.0)), ray.nu);
        // Air scatters harmonics up to degree 2 only, and high up there are next to no aerosols.
        bool clear = all(lessThan(aerosols_node.rgb, ORDER_CLEAR * air_node.rgb));
        OrderLight scattered = order_scatter(field, degree, clear ? min(2, most) : most, band,
                                             order_place(order_grid, air.thickness_m, h, mu_sun), ray.nu, azimuth);
        for (int k = 0; k < ORDER_BANDS; k++) {
            ivec2 node = ray.texel + ivec2(i, k * ray_rows);
            light[k] += scattered.by_air[k] * texelFetch(rays_air, node, 0).rgb +
                        scattered.by_aerosols[k] * texelFetch(rays_aerosols, node, 0).rgb;
        }
        i += 1;
    } while (i < nodes);
}
