// a: u, v in [0,1)^2; b: a normal. c: a point on the sphere; d: the light method's direction, and its condition.
#include "scene.glsl"
#include "sun/off.glsl"
#include "emission/none.glsl"
#include "mist/none.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    vec2 u = vec2(a.x, a.y);
    vec3 point = sphere_sample(u);
    // Opposite to the normal the sum that is normalised vanishes, and its direction is all rounding.
    float condition = 1.0 / length(vec3(b) + 0.999999 * point);
    c = vec4(point, 0.0);
    d = vec4(matte_direction(vec3(b), u, vec2(a.z, a.w)), condition);
}

// What a light method asks of a scene; no path is traced here.
void scene_intersect(Ray ray, INOUT(Hit) hit) {}
Material scene_material(Hit hit) { return material_new(0, vec3(1.0)); }
Bounce material_sample(Material m, vec3 normal, vec3 incoming, vec2 u, vec2 v) { return Bounce(normal, vec3(1.0), 0.0, false); }
float material_pdf(Material m, vec3 normal, vec3 incoming, vec3 outgoing) { return 0.0; }
vec3 material_value(Material m, vec3 normal, vec3 incoming, vec3 outgoing) { return vec3(0.0); }
vec3 sky_radiance(vec3 direction) { return vec3(1.0); }
