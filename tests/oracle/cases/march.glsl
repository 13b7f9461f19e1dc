// a: origin; b: direction. c: distance to a field's surface, normal; d: object, and the condition of the distance and of the
// normal.
#include "../item.glsl"
#include "distance/box.glsl"
#include "distance/smooth.glsl"
#include "distance/torus.glsl"
#include "shape/march.glsl"

float scene_distance(vec3 p) {
    float box = distance_box(p, vec3(0.125, -0.25, 0.5), vec3(0.7, 0.4, 1.0));
    return op_smooth_union(box, distance_torus(p, vec3(0.125, -0.25, 0.5), vec3(0.0, 1.0, 0.0), 0.8, 0.3), 0.2);
}

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    Ray ray = Ray(vec3(a), vec3(b));
    Hit hit = hit_none();
    march(ray, vec3(0.0), 2.5, 5, hit);
    // Grazing, all errors grow.
    float reach = length(ray.origin) + 1.0;
    float t = min(hit.t, reach);
    float cosine = max(abs(dot(hit.normal, ray.direction)), 1.0e-6);
    c = vec4(hit.t, hit.normal.x, hit.normal.y, hit.normal.z);
    d = vec4(float(hit.object), hit.t < INFINITY ? reach / (t * cosine) : 1.0, hit.t < INFINITY ? 4.0 * reach / cosine : 1.0,
             float(search_broken + search_cut));
}
