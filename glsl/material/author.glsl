#include "scene.glsl"
#include "math/sphere_sample.glsl"

// The material of the paper's author (2017). Light scatters toward a uniform random point of a ball.
// Matte light uses a ball of radius 1 that rests on the surface. The share `reflectance` of the light uses a ball of radius
// `roughness`, which is moved toward the mirror's direction and still rests on the surface.
// Only colour and absorbance take light away. The material is not physical: if light goes the other way, it is scattered differently.

// In the author's program, roughness 0 is a mirror. Here the least roughness is this, so that each direction has a density.
// Use mirror() where reflectance is 1 and roughness is 0.
const float AUTHOR_LEAST_ROUGHNESS = 1.0e-3;

// The author's defaults are white, reflectance 0, roughness 1 and absorbance 0.1. Light that is reflected as by a mirror is not coloured.
Material author(vec3 color, float reflectance, float roughness, float absorbance) {
    Material material = material_new(MATERIAL_AUTHOR, (1.0 - absorbance) * mix(color, vec3(1.0), reflectance));
    material.reflectance = reflectance;
    material.roughness = max(roughness, AUTHOR_LEAST_ROUGHNESS);
    return material;
}

// Returns the density of the directions from the origin to uniform random points of a ball. The ball does not reach behind the origin.
// The density is (far^3 - near^3) / 3 divided by the ball's volume, where the ray is inside the ball from `near` to `far`.
float author_density(vec3 centre, float radius, vec3 direction) {
    float middle = dot(centre, direction);
    vec3 miss = centre - middle * direction;
    float half_chord = sqrt(max(radius * radius - dot(miss, miss), 0.0));
    float far = middle + half_chord;
    float outside = 2.0 * half_chord * (3.0 * middle * middle + half_chord * half_chord);
    float inside = max(far * far * far, 0.0);
    float cubes = middle > half_chord ? outside : inside;
    float density = cubes / (4.0 * PI * radius * radius * radius);
    return half_chord > 0.0 ? density : 0.0;
}

// Returns the centre of the ball for light that is reflected.
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

// v.x chooses between the two balls. The chosen part of its range is stretched to [0,1), so that v.x serves as a random number again.
Bounce author_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    bool reflected = v.x < material.reflectance;
    float below = v.x / material.reflectance;
    float above = (v.x - material.reflectance) / (1.0 - material.reflectance);
    float rest = reflected ? below : above;
    float radius = reflected ? material.roughness : 1.0;
    vec3 moved = author_centre(material, normal, incoming);
    vec3 centre = reflected ? moved : normal;
    vec3 direction = normalize(centre + 0.999999 * radius * pow(rest, 1.0 / 3.0) * sphere_sample(u));
    float pdf = author_pdf(material, normal, incoming, direction);
    return Bounce(direction, material.color, max(pdf, 1.0e-20), false);
}

// A ball of radius 0.5 reflects into a cone of some 30 degrees. Wider balls find the sun often.
const float AUTHOR_NARROW_ROUGHNESS = 0.5;

// The share of the light from it that is bright in few directions.
float author_throws(Material material) {
    return material.roughness < AUTHOR_NARROW_ROUGHNESS ? material.reflectance : 0.0;
}
