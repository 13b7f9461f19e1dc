#include "scene.glsl"

// A half-space with a bowl cut out by a sphere: solid where dot(normal, p) < offset, but for the sphere. For rays that
// start in the open, above the plane or in the bowl.
//
// Watertight: one question, asked once (where does the ray cross the plane, in the sphere or out of it), decides between
// plane and bowl, so that no rounding at the rim lets a ray slip between them.
void hit_plane_minus_sphere(Ray ray, vec3 normal, float offset, vec3 centre, float radius, int object, INOUT(Hit) hit) {
    float height = dot(normal, ray.origin) - offset;
    float descent = -dot(normal, ray.direction);
    float crossing = descent != 0.0 ? height / descent : INFINITY;

    vec3 to_centre = centre - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 miss = to_centre - middle * ray.direction;
    float leaves_sphere = middle + sqrt(max(radius * radius - dot(miss, miss), 0.0));

    vec3 from_centre = crossing * ray.direction - to_centre;
    bool above = height > 0.0;
    bool meets_plane = above && descent > 0.0;
    bool on_plane = meets_plane && dot(from_centre, from_centre) > radius * radius;
    bool in_bowl = meets_plane ? !on_plane : !above && (descent >= 0.0 || leaves_sphere < crossing);
    float t = on_plane ? crossing : max(leaves_sphere, above ? crossing : 0.0);
    if ((on_plane || in_bowl) && t < hit.t) {
        hit.t = t;
        hit.normal = on_plane ? normal : normalize(to_centre - t * ray.direction);
        hit.object = object;
    }
}
