// a: u, v in [0,1)^2; b: the cosine and azimuth of the light that comes, roughness, index of refraction. c: rough metal's cosine,
// density by its peak, and weight, and how much a rounding grows in them; d: glass's cosine, the author's density by its peak, and
// their conditions.
#include "../item.glsl"
#include "material/author.glsl"
#include "material/glass.glsl"
#include "material/rough_metal.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    vec3 normal = normalize(vec3(0.3, 0.8, -0.5));
    vec2 u = vec2(a.x, a.y);
    vec2 v = vec2(a.z, a.w);
    float level = sqrt(max(1.0 - b.x * b.x, 0.0));
    vec3 incoming = in_frame(normal, level * cos(b.y), level * sin(b.y), -b.x);

    Material metal = rough_metal(vec3(0.5), b.z);
    float alpha = rough_metal_alpha(metal);
    Bounce bounce = rough_metal_sample(metal, normal, incoming, u, v);
    c = vec4(dot(bounce.direction, normal), bounce.pdf * alpha * alpha, bounce.weight.x, 1.0 / (alpha * b.x));

    // Which way it goes is a jump; toward the critical angle all grows.
    Material clear = glass(b.w);
    Bounce passed = glass_sample(clear, normal, incoming, u, v);
    float beyond = abs(1.0 - level * level / (b.w * b.w));

    Material authors = author(vec3(1.0), 0.5, b.z, 0.1);
    float peak = b.z * b.z;
    d = vec4(dot(passed.direction, normal), peak * author_sample(authors, normal, incoming, u, v).pdf, 1.0 / max(beyond, 1.0e-6),
             1.0 / b.z);
}
