#include "math/reflect.glsl"
#include "scene.glsl"
#include "math/frame.glsl"

// Metal with a finish. Its surface consists of small mirrors (facets).
//   * Their normals are distributed by GGX (Walter et al. 2007).
//   * They shade and hide each other by Smith's function, height-correlated (Heitz 2014).
//   * They are drawn in proportion to how much of them is visible (Heitz 2018, in the form of Dupuy and Benyoub 2023).
//   * Light that meets several of them leaves in the directions of the light that meets one, and is added to it (Turquin 2019).
//
// How much light leaves in the end was compared with random walks over the facets (Heitz et al. 2016), at roughnesses from 0.2 to 1,
// tints from 0.02 to 1 and cosines from 0.03 to 1. The share of the light that is reflected differs from the walk's by at most 0.012. It
// differs by up to 0.060 if the further facets reflect the tint as Turquin has it, by up to 0.050 in the model of Kulla and Conty (2017), and by
// up to 0.69 if light leaves after one facet only. A tint of 1 reflects all light but for the error of rough_metal_again().
//
// What is added depends on the cosine of the incoming ray. Value divided by cosine is therefore not the same with the directions exchanged, and
// the incoming ray has to be the one that comes from the camera.

// The least alpha. A narrower lobe would be narrower than the sun's disk: float would lose its digits, and no picture would change.
// mirror() is the limit.
const float ROUGH_METAL_LEAST_ALPHA = 1.0e-3;

// Reflects the share `tint` of light that comes along the normal, and more of light that grazes the surface (Schlick).
// Roughness is from 0 to 1; the model's alpha is its square (Burley 2012).
Material rough_metal(vec3 tint, float roughness) {
    Material material = material_new(MATERIAL_ROUGH_METAL, tint);
    material.roughness = roughness;
    return material;
}

// Reflectance of metals along the normal, as linear RGB with the primaries of Rec. 709. The values come from measured indices of
// refraction: Adobe, "Metal material references" of the Adobe Standard Material. The red of gold and of copper would be above 1, and is
// set to 1.
vec3 gold() {
    return vec3(1.0, 0.7099, 0.3148);
}

vec3 copper() {
    return vec3(1.0, 0.6504, 0.5274);
}

vec3 aluminium() {
    return vec3(0.9157, 0.9226, 0.9236);
}

float rough_metal_alpha(Material material) {
    return max(material.roughness * material.roughness, ROUGH_METAL_LEAST_ALPHA);
}

// Returns the density of the facets' normals. It uses the sine of the tilt, because near the normal the cosine has no digits left for it.
float rough_metal_tilts(float alpha, vec3 normal, vec3 half_way) {
    vec3 tilt = cross(normal, half_way);
    float z = dot(normal, half_way);
    float stretched = dot(tilt, tilt) / (alpha * alpha) + z * z;
    float density = 1.0 / (PI * alpha * alpha * stretched * stretched);
    return z > 0.0 ? density : 0.0;
}

// Returns the square root of Smith's function for a cosine. All masking is written with it, so that no cosine that may be 0 is divided by.
float rough_metal_root(float alpha, float cosine) {
    return sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine);
}

vec3 rough_metal_fresnel(vec3 tint, float cosine) {
    float c = 1.0 - clamp(cosine, 0.0, 1.0);
    float c2 = c * c;
    return tint + c2 * c2 * c * (vec3(1.0) - tint);
}

// Returns the share of the visible facets' light that is not hidden on its way out. This is the height-correlated masking of both
// directions, divided by the masking of the incoming direction alone.
float rough_metal_open(float alpha, float cos_in, float cos_out) {
    float root_in = rough_metal_root(alpha, cos_in);
    float root_out = rough_metal_root(alpha, cos_out);
    return cos_out * (cos_in + root_in) / max(cos_out * root_in + cos_in * root_out, 1.0e-20);
}

// Returns the share of the light that meets a second facet, where none absorbs any. At alpha 1 this is exact, and toward the mirror it goes
// to 0. Elsewhere it is a fit to integrals over the facets: the share of the light that leaves after one facet, which is the rest, is
// wrong by at most 0.22 % of itself.
float rough_metal_again(float alpha, float cos_in) {
    float x = cos_in / rough_metal_root(alpha, cos_in);
    float y = 1.0 - x;
    float above = alpha * alpha * (0.44 + 1.544 * alpha) + y * (1.507 + 0.828 * alpha - 0.646 * y);
    float below = 1.0 - alpha * (0.909 - 2.154 * alpha) + y * (6.021 - 3.602 * alpha - 2.52 * y);
    return x * (alpha * alpha * log(1.0 + 1.0 / max(x, 1.0e-6)) + (1.0 - alpha) * above / below);
}

// Returns what light that leaves after one facet is worth, with the light that leaves after more of them. The further facets reflect about as
// much as the first one does. The more of the light is caught again and again, the more of it they absorb.
vec3 rough_metal_reflectance(Material material, float cos_in, float cos_half) {
    vec3 once = rough_metal_fresnel(material.color, cos_half);
    float again = rough_metal_again(rough_metal_alpha(material), cos_in);
    vec3 further = once * (vec3(1.0) - again * again * (vec3(1.0) - once));
    return once * (vec3(1.0) + again / (1.0 - again) * further);
}

// The density integrates to 1 over all directions, also those below the surface: some facets throw light there, and its weight is 0.
float rough_metal_pdf(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    float alpha = rough_metal_alpha(material);
    float cos_in = max(-dot(normal, incoming), 0.0);
    vec3 sum = outgoing - incoming;
    vec3 half_way = sum / max(length(sum), 1.0e-10);
    return 0.5 * rough_metal_tilts(alpha, normal, half_way) / (cos_in + rough_metal_root(alpha, cos_in));
}

vec3 rough_metal_value(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    float cos_in = max(-dot(normal, incoming), 0.0);
    float cos_out = max(dot(normal, outgoing), 0.0);
    // The cosine between the light and the facet's normal.
    float cos_half = sqrt(max(0.5 - 0.5 * dot(incoming, outgoing), 0.0));
    float open = rough_metal_open(rough_metal_alpha(material), cos_in, cos_out);
    float pdf = rough_metal_pdf(material, normal, incoming, outgoing);
    return open * pdf * rough_metal_reflectance(material, cos_in, cos_half);
}

// If everything is stretched by 1 / alpha, the visible facets are those of a hemisphere. Their normals are then halfway between the view
// and a uniform random point on a cap of the sphere.
Bounce rough_metal_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    float alpha = rough_metal_alpha(material);
    float cos_in = max(-dot(normal, incoming), 0.0);
    vec3 across = -incoming - cos_in * normal;
    vec3 view = normalize(alpha * across + cos_in * normal);
    float z = 1.0 - u.x * (1.0 + dot(view, normal));
    float level = sqrt(max(1.0 - z * z, 0.0));
    float phi = 2.0 * PI * u.y;
    vec3 stretched = view + in_frame(normal, level * cos(phi), level * sin(phi), z);
    float up = dot(stretched, normal);
    vec3 half_way = normalize(alpha * (stretched - up * normal) + max(up, 1.0e-7) * normal);
    vec3 outgoing = mirror_direction(incoming, half_way);
    float cos_out = max(dot(normal, outgoing), 0.0);
    vec3 reflectance = rough_metal_reflectance(material, cos_in, -dot(incoming, half_way));
    float pdf = rough_metal_pdf(material, normal, incoming, outgoing);
    return Bounce(outgoing, rough_metal_open(alpha, cos_in, cos_out) * reflectance, max(pdf, 1.0e-20), false);
}

// A lobe of alpha 0.25, that is of roughness 0.5, reflects half of the light within some 30 degrees. Wider lobes find the sun often.
const float ROUGH_METAL_NARROW_ALPHA = 0.25;

// Whether the light that comes from it is bright in few directions: all of it, or none.
float rough_metal_throws(Material material) {
    return rough_metal_alpha(material) < ROUGH_METAL_NARROW_ALPHA ? 1.0 : 0.0;
}
