#include "scene.glsl"
#include "math/sphere_sample.glsl"

// The author's material (2017): light goes toward a uniform point of a ball. Matte, the ball of radius 1 that rests on the surface;
// of `reflectance` of the light, a ball of radius `roughness` that is moved toward the mirror's direction, and still rests on
// the surface. Nothing is lost but by colour and absorbance. Not a physical material: light that goes the other way is
// scattered otherwise.

// His roughness 0 is a mirror. Here it is this much, so that each direction has a density; with reflectance 1 use mirror().
const float AUTHOR_LEAST_ROUGHNESS = 1.0e-3;

// His defaults are white, reflectance 0, roughness 1 and absorbance 0.1. What is reflected as by a mirror takes no colour.
Material author(vec3 color, float reflectance, float roughness, float absorbance) {
    Material material = material_new(MATERIAL_AUTHOR, (1.0 - absorbance) * mix(color, vec3(1.0), reflectance));
    material.reflectance = reflectance;
    material.roughness = max(roughness, AUTHOR_LEAST_ROUGHNESS);
    return material;
}

// Density of the directions, from the origin, to uniform points of a ball that does not reach behind it: the far end of the
// ray's chord cubed, less the near end cubed, by three.
float author_density(vec3 centre, float radius, vec3 direction) {
    float middle = dot(centre, direction);
    vec3 miss = centre - middle * direction;
    float half_chord = sqrt(max(radius * radius - dot(miss, miss), 0.0));
    float far = middle + half_chord;
    float outside = 2.0 * half_chord * (3.0 * middle * middle + half_chord * half_chord);
    float cubes = middle > half_chord ? outside : max(far * far * far, 0.0);
    return half_chord > 0.0 ? cubes / (4.0 * PI * radius * radius * radius) : 0.0;
}

// The ball's centre for light that is reflected.
vec3 author_centre(Material material, vec3 normal, vec3 incoming) {
    return mix(reflect(incoming, normal), normal, material.roughness);
}

float author_pdf(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    float matte = author_density(normal, 1.0, outgoing);
    float reflected = author_density(author_centre(material, normal, incoming), material.roughness, outgoing);
    return mix(matte, reflected, material.reflectance);
}

vec3 author_value(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return author_pdf(material, normal, incoming, outgoing) * material.color;
}

// v.x chooses, and stretched serves again.
Bounce author_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    bool reflected = v.x < material.reflectance;
    float rest = reflected ? v.x / material.reflectance : (v.x - material.reflectance) / (1.0 - material.reflectance);
    float radius = reflected ? material.roughness : 1.0;
    vec3 centre = reflected ? author_centre(material, normal, incoming) : normal;
    vec3 direction = normalize(centre + 0.999999 * radius * pow(rest, 1.0 / 3.0) * sphere_sample(u));
    float pdf = author_pdf(material, normal, incoming, direction);
    return Bounce(direction, material.color, max(pdf, 1.0e-20), false);
}
