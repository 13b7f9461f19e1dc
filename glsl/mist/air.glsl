// The atmosphere's own air between the scene's surfaces. Its densities fall with height as those of the sky's air do, over ground that is flat.
//
// It acts on ways that end on a surface. A ray to the sky or to the sun has it in the sky's radiance and in the sun's light already.
#include "math/frame.glsl"
#include "mist/channels.glsl"
#include "mist/ask.glsl"
#include "mist/material/place_air.glsl"
#include "sky/atmosphere.glsl"

// The air in the picture's channels, and the altitude of the scene's height 0.
Atmosphere air_here();
float air_base_m();
// Whether the air scatters light again that came from the sky or from a surface.
bool air_scatters_again();
float absorber_density(Atmosphere a, float h);

// A power of e that no air needs, and whose product with the farthest distance is a float.
const float AIR_MOST_POWER = 40.0;
// The light of a surface over that of the sky, as mist_event() takes it to be.
const float AIR_SURFACE = 0.3;
// No ray is followed farther through the air, m.
const float AIR_FARTHEST = 1.0e9;

float air_altitude(vec3 position) {
    return air_base_m() + position.y;
}

// The densities of air and aerosols, as shares of those at altitude 0.
vec2 air_densities(Atmosphere a, float h) {
    return exp(min(-h / vec2(a.rayleigh_scale_height_m, a.mie_scale_height_m), AIR_MOST_POWER));
}

// The mean density of the absorber between two altitudes. It is linear on either side of the layer's middle.
float air_absorber_mean(Atmosphere a, float h, float end) {
    float low = min(h, end);
    float high = max(h, end);
    float from = clamp(a.ozone_height_m - a.ozone_half_width_m, low, high);
    float middle = clamp(a.ozone_height_m, low, high);
    float to = clamp(a.ozone_height_m + a.ozone_half_width_m, low, high);
    float sum = (middle - from) * absorber_density(a, 0.5 * (from + middle)) + (to - middle) * absorber_density(a, 0.5 * (middle + to));
    return high - low > 1.0 ? sum / (high - low) : absorber_density(a, 0.5 * (low + high));
}

// The depths of a ray's first metres, by channel: each density is an exponential of the distance too.
vec3 air_depths(Ray ray, float metres) {
    Atmosphere a = air_here();
    float h = air_altitude(ray.origin);
    vec2 fall = metres * ray.direction.y / vec2(a.rayleigh_scale_height_m, a.mie_scale_height_m);
    vec2 column = metres * air_densities(a, h) * vec2(exp_quotient(fall.x), exp_quotient(fall.y));
    float absorber = metres * air_absorber_mean(a, h, h + metres * ray.direction.y);
    return a.rayleigh_scatter_per_m * column.x + a.mie_extinction_per_m * column.y + a.ozone_absorb_per_m * absorber;
}

bool mist_here() {
    return true;
}

bool mist_is_air() {
    return true;
}

void mist_begin(vec2 numbers) {
}

MistWay mist_way(Ray ray, float distance) {
    float metres = distance < INFINITY ? min(distance, AIR_FARTHEST) : 0.0;
    return MistWay(ray, 0.0, metres, 0.0, 0.0, 0.0);
}

float mist_reached(MistWay way, float depth) {
    return way.metres;
}

vec3 mist_kept(MistWay way) {
    return exp(-air_depths(way.ray, way.metres));
}

// A place in the air has coefficients of scattering, 1/m, where mist has an albedo. So its weight is what comes from there over the density of the place.
//
// Paths are scattered in the air more often than its light is: thin air before a dark surface brings much of what is seen there. Noise is least where both
// ways are taken in proportion to what they bring. AIR_SURFACE stands for how bright surfaces are beside the sky.
MistEvent mist_event(MistWay way, vec3 throughput, float u) {
    vec3 odds = channels_odds(throughput);
    vec3 depths = air_depths(way.ray, way.metres);
    float lost = 1.0 - channels_none(depths, odds);
    float chance = air_scatters_again() ? lost / (lost + AIR_SURFACE * (1.0 - lost)) : 0.0;
    bool scattered = u < chance;
    float share = channels_point(depths, odds, min(u / max(chance, 1.0e-30), 0.99999994));
    float t = way.metres * share;
    vec3 there = exp(-air_depths(way.ray, t)) * (way.metres / max(chance * channels_point_pdf(depths, odds, share), 1.0e-30));
    return MistEvent(scattered ? t : INFINITY, scattered ? there : exp(-depths) / max(1.0 - chance, 1.0e-30));
}

MistPoint mist_point(MistWay way, vec3 throughput, float u) {
    vec3 odds = channels_odds(throughput);
    vec3 depths = air_depths(way.ray, way.metres);
    float share = channels_point(depths, odds, u);
    float t = way.metres * share;
    return MistPoint(t, exp(-air_depths(way.ray, t)) * (way.metres / channels_point_pdf(depths, odds, share)));
}

float mist_excess(Ray ray, float distance, float u) {
    return 0.0;
}

float mist_overrun(Ray ray, float distance) {
    return 0.0;
}

Material mist_material(vec3 position) {
    return air_material(air_here(), air_densities(air_here(), air_altitude(position)));
}
