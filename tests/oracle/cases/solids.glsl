// a: origin, solid; b: direction. c: distance, normal; d: object, and the condition of the distance and of the normal.
#include "../item.glsl"
#include "shape/box.glsl"
#include "shape/capsule.glsl"
#include "shape/cone.glsl"
#include "shape/cylinder.glsl"
#include "shape/disk.glsl"
#include "shape/ellipsoid.glsl"
#include "shape/rounded_box.glsl"
#include "shape/torus.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    Ray ray = Ray(vec3(a), vec3(b));
    vec3 centre = vec3(0.125, -0.25, 0.5);
    vec3 axis = vec3(0.48, 0.6, 0.64);
    vec3 half_size = vec3(0.7, 0.4, 1.0);
    Hit hit = hit_none();
    if (a.w == 0.0) hit_box(ray, centre, half_size, 5, hit);
    if (a.w == 1.0) hit_rounded_box(ray, centre, half_size, 0.25, 5, hit);
    if (a.w == 2.0) hit_disk(ray, centre, axis, 0.9, 5, hit);
    if (a.w == 3.0) hit_cylinder(ray, centre - 0.8 * axis, centre + 0.8 * axis, 0.4, 5, hit);
    if (a.w == 4.0) hit_capsule(ray, centre - 0.6 * axis, centre + 0.6 * axis, 0.4, 5, hit);
    if (a.w == 5.0) hit_cone(ray, centre - 0.8 * axis, centre + 0.8 * axis, 0.6, 5, hit);
    if (a.w == 6.0) hit_torus(ray, centre, axis, 0.8, 0.3, 5, hit);
    if (a.w == 7.0) hit_ellipsoid(ray, centre, half_size, 5, hit);
    // Grazing, all errors grow; at an edge, they jump.
    float reach = length(ray.origin) + 1.0;
    float t = min(hit.t, reach);
    float cosine = max(abs(dot(hit.normal, ray.direction)), 1.0e-6);
    float condition = hit.t < INFINITY ? reach / (t * cosine) : 1.0;
    c = vec4(hit.t, hit.normal.x, hit.normal.y, hit.normal.z);
    d = vec4(float(hit.object), condition, hit.t < INFINITY ? 4.0 * reach / cosine : 1.0, 0.0);
}
