#include "scene.glsl"
#include "shape/march_careful.glsl"
#include "shape/march_quick.glsl"
#include "shape/search.glsl"

// The surface where a distance field is 0. The scene defines the field, for instance with the functions of distance/, and calls march() among
// its hit_NAME():
//
//     float scene_distance(vec3 p)    the distance from p to the surface in metres, or less; negative inside the solid
//
// A ray that starts inside a solid finds its way out.
// The numbers in a field (a centre, a radius) should not be much larger than the distance from which the surface is seen, or than the sphere
// that is given to march(). The rounding errors of float grow with these numbers.

// Returns the field's gradient by central differences. The differences are divided by the distances that rounding leaves between the points p +- h.
// The loop makes the compiler inline the field once, not six times.
vec3 march_gradient(vec3 p, float h) {
    vec3 high = p + h;
    vec3 low = p - h;
    vec3 change = vec3(0.0);
    for (int i = 0; i < 6; i++) {
        vec3 q = vec3(i == 0 ? high.x : (i == 3 ? low.x : p.x), i == 1 ? high.y : (i == 4 ? low.y : p.y),
                      i == 2 ? high.z : (i == 5 ? low.z : p.z));
        vec3 axis = vec3(i % 3 == 0 ? 1.0 : 0.0, i % 3 == 1 ? 1.0 : 0.0, i % 3 == 2 ? 1.0 : 0.0);
        change += (i < 3 ? scene_distance(q) : -scene_distance(q)) * axis;
    }
    return change / (high - low);
}

void march_between(Ray ray, float start, float end, float size, int object, INOUT(Hit) hit) {
    int broken = search_broken;
    float last = min(min(end, hit.t), MARCH_FAR);
    March march = march_careful(ray, march_quick(ray, start, last, size), start, last, size);
    search_rays += 1;
    search_steps += march.steps;
    // At an edge, the normal is blended of those of both sides, so that a bounce may be turned into the solid. The edge's other side is there at once.
    bool blocked = march.side < 0.0 && object == ray_leaves;
    float here = MARCH_PRECISION * (max(march_size(ray.origin), size) + start);
    float side = blocked ? 1.0 : march.side;
    float t = blocked ? here : march.found;
    if (t < INFINITY) {
        vec3 p = ray.origin + t * ray.direction;
        float near = max(march_size(p), size);
        vec3 gradient = march_gradient(p, MARCH_NORMAL_STEP * max(near, 0.25 * t));
        float steepness = length(gradient);
        if (steepness > MARCH_STEEP) search_broken = broken + 1;
        // The distance that is left to the surface, by the field's slope along the ray. It is long where the ray grazes the surface.
        float slope = dot(gradient, ray.direction);
        float reach = 64.0 * MARCH_PRECISION * (near + t);
        float rest = abs(slope) > 1.0e-4 && !blocked ? clamp(-march.field / slope, -reach, reach) : 0.0;
        hit.t = max(t + rest, 0.5 * t);
        vec3 normal = steepness > 0.0 ? gradient / steepness : -ray.direction;
        // On an edge the differences blend the normals of two sides. If the result faces away from the ray's origin, it is turned until the ray
        // grazes the surface; otherwise the path would go on within the solid.
        float facing = side * dot(normal, ray.direction);
        hit.normal = facing < 0.0 ? normal : normalize(normal - side * (facing + 1.0e-3) * ray.direction);
        hit.object = object;
    }
}

// Marches along the whole ray to the field's surface.
void march(Ray ray, int object, INOUT(Hit) hit) {
    march_between(ray, 0.0, INFINITY, 0.0, object, hit);
}

// Marches only inside a sphere, which must contain all of the surface. Rays that miss the sphere cost nothing.
void march(Ray ray, vec3 centre, float radius, int object, INOUT(Hit) hit) {
    vec3 to_centre = centre - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 miss = to_centre - middle * ray.direction;
    // The sphere is a little larger than given, so that a surface that touches it is found.
    float discriminant = 1.001 * radius * radius - dot(miss, miss);
    if (discriminant > 0.0) {
        float half_chord = sqrt(discriminant);
        float size = max(march_size(centre), radius);
        march_between(ray, max(middle - half_chord, 0.0), middle + half_chord, size, object, hit);
    }
}

// Marches only inside a box along the axes, with the distances `half_size` from its centre to its faces, which must contain all of the surface. Rays that
// miss the box cost nothing. A box is often much smaller than a sphere about the same surface.
void march(Ray ray, vec3 centre, vec3 half_size, int object, INOUT(Hit) hit) {
    vec3 to_centre = centre - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 near = middle * ray.direction - to_centre;
    // As the sphere, the box is a little larger than given.
    vec3 reach = half_size + 5.0e-4 * march_size(half_size);
    // Each axis counts along the ray. A ray that is parallel to two faces is taken to run between them.
    vec3 inverse = 1.0 / max(abs(ray.direction), 1.0e-20);
    vec3 enter = (-reach - sign(ray.direction) * near) * inverse;
    vec3 leave = (reach - sign(ray.direction) * near) * inverse;
    float start = max(middle + max(max(enter.x, enter.y), enter.z), 0.0);
    float end = middle + min(min(leave.x, leave.y), leave.z);
    if (start < end) march_between(ray, start, end, max(march_size(centre), march_size(half_size)), object, hit);
}
