// a: origin, shape (0 sphere, 1 plane, 2 plane minus sphere); b: direction, radius. c: distance, normal; d: the object,
// and the condition of the distance and of the normal.
#include "../item.glsl"
#include "shape/plane.glsl"
#include "shape/plane_minus_sphere.glsl"
#include "shape/sphere.glsl"

// How many times a rounding of the inputs grows in the distance to the plane through (0, 0.3, 0), and to the sphere.
float plane_condition(Ray ray, vec3 normal) {
    float height = abs(dot(normal, ray.origin) - 0.3);
    return 1.0 + (length(ray.origin) + 0.3) / height + 1.0 / abs(dot(normal, ray.direction));
}

float sphere_condition(Ray ray, vec3 centre, float radius, float t) {
    vec3 to_centre = centre - ray.origin;
    vec3 miss = to_centre - dot(to_centre, ray.direction) * ray.direction;
    float half_chord = sqrt(abs(radius * radius - dot(miss, miss)));
    float reach = length(to_centre) + radius;
    return 1.0 + reach / abs(t) * (1.0 + radius / max(half_chord, 1.0e-20));
}

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    Ray ray = Ray(vec3(a), vec3(b));
    float radius = b.w;
    vec3 up = vec3(0.0, 1.0, 0.0);
    vec3 centre = vec3(0.0, 0.3, 0.0);
    Hit hit = hit_none();
    if (a.w == 0.0) hit_sphere(ray, centre, radius, 5, hit);
    if (a.w == 1.0) hit_plane(ray, up, 0.3, 6, hit);
    if (a.w == 2.0) hit_plane_minus_sphere(ray, up, 0.3, centre, radius, 7, hit);

    // The rim decides between plane and bowl, the plane's height between above and below.
    float t = min(hit.t, length(ray.origin));
    float plane = a.w == 0.0 ? 1.0 : plane_condition(ray, up);
    float sphere = a.w == 1.0 ? 1.0 : sphere_condition(ray, centre, radius, t);
    vec3 crossing = ray.origin + (0.3 - ray.origin.y) / ray.direction.y * ray.direction - centre;
    float off_rim = abs(length(crossing) - radius) / (length(crossing) + radius);
    float rim = a.w == 2.0 ? 1.0 / off_rim : 1.0;
    float condition = max(max(plane, sphere), rim);
    c = vec4(hit.t, hit.normal.x, hit.normal.y, hit.normal.z);
    d = vec4(float(hit.object), condition, condition * (1.0 + t / radius), 0.0);
}
