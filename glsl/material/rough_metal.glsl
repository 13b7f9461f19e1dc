#include "scene.glsl"
#include "math/frame.glsl"

// Metal with a finish: a surface of mirrors that are tilted as GGX says (Walter et al. 2007), which shade and hide each other as
// Smith says, height-correlated (Heitz 2014), drawn by how much of them is seen (Heitz 2018, in the form of Dupuy and Benyoub
// 2023). Light meets one mirror and no second, so that rough metal loses some: at roughness 1, seen straight, all but 1 - log(2).

// The least alpha: lobes narrower than the sun's disk cost float its digits and change no picture. mirror() is the limit.
const float ROUGH_METAL_LEAST_ALPHA = 1.0e-3;

// Reflects `tint` of the light that comes straight down, more toward grazing (Schlick). Roughness 0 to 1, and alpha its square
// (Burley 2012).
Material rough_metal(vec3 tint, float roughness) {
    Material material = material_new(MATERIAL_ROUGH_METAL, tint);
    material.roughness = roughness;
    return material;
}

// Reflectance of metals at normal incidence, linear RGB with Rec. 709's primaries, from measured indices of refraction: Adobe,
// "Metal material references" of the Adobe Standard Material. Gold's red, and copper's, lie outside and are cut off at 1.
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

// Density of the mirrors' normals by their tilt. From its sine, because near to the normal cosines have lost it.
float rough_metal_tilts(float alpha, vec3 normal, vec3 half_way) {
    vec3 tilt = cross(normal, half_way);
    float z = dot(normal, half_way);
    float stretched = dot(tilt, tilt) / (alpha * alpha) + z * z;
    return z > 0.0 ? 1.0 / (PI * alpha * alpha * stretched * stretched) : 0.0;
}

// Smith's square root, for a cosine: all masking is made of it, and nothing is divided by a cosine that may be 0.
float rough_metal_root(float alpha, float cosine) {
    return sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine);
}

vec3 rough_metal_fresnel(vec3 tint, float cosine) {
    float c = 1.0 - clamp(cosine, 0.0, 1.0);
    float c2 = c * c;
    return tint + c2 * c2 * c * (vec3(1.0) - tint);
}

// What of the visible mirrors' light is not hidden on its way out: the height-correlated masking of both over that of one.
float rough_metal_open(float alpha, float cos_in, float cos_out) {
    float root_in = rough_metal_root(alpha, cos_in);
    float root_out = rough_metal_root(alpha, cos_out);
    return cos_out * (cos_in + root_in) / max(cos_out * root_in + cos_in * root_out, 1.0e-20);
}

// One over all directions: some of the visible mirrors throw the light below the surface, where its weight is 0.
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
    float cos_half = sqrt(max(0.5 - 0.5 * dot(incoming, outgoing), 0.0)); // between the light and the mirrors
    float open = rough_metal_open(rough_metal_alpha(material), cos_in, cos_out);
    float pdf = rough_metal_pdf(material, normal, incoming, outgoing);
    return open * pdf * rough_metal_fresnel(material.color, cos_half);
}

// The mirrors seen from one side are those of a hemisphere, when all is stretched by 1 / alpha; their normals are halfway between
// the view and a uniform point of a cap of the sphere.
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
    vec3 outgoing = reflect(incoming, half_way);
    float cos_out = max(dot(normal, outgoing), 0.0);
    vec3 fresnel = rough_metal_fresnel(material.color, -dot(incoming, half_way));
    float pdf = rough_metal_pdf(material, normal, incoming, outgoing);
    return Bounce(outgoing, rough_metal_open(alpha, cos_in, cos_out) * fresnel, max(pdf, 1.0e-20), false);
}
