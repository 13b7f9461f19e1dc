#include "scene.glsl"

// A half-space from which a sphere cuts out a bowl. It is solid where dot(normal, p) < offset, except in the sphere. Rays must start in
// the open, above the plane or in the bowl.
//
// The surface has no gap. One test decides between plane and bowl: whether the ray crosses the plane inside the sphere. Rounding at the rim can
// therefore not let a ray slip between the two.
void hit_plane_minus_sphere(Ray ray, vec3 normal, float offset, vec3 centre, float radius, int object, INOUT(Hit) hit) {
    float height = dot(normal, ray.origin) - offset;
    float descent = -dot(normal, ray.direction);
    float ratio = height / descent;
    float crossing = descent != 0.0 ? ratio : INFINITY;

    vec3 to_centre = centre - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 miss = to_centre - middle * ray.direction;
    float leaves_sphere = middle + sqrt(max(radius * radius - dot(miss, miss), 0.0));

    vec3 from_centre = crossing * ray.direction - to_centre;
    bool above = height > 0.0;
    bool meets_plane = above && descent > 0.0;
    bool on_plane = meets_plane && dot(from_centre, from_centre) > radius * radius;
    bool from_bowl = !above && (descent >= 0.0 || leaves_sphere < crossing);
    bool off_plane = !on_plane;
    bool in_bowl = meets_plane ? off_plane : from_bowl;
    float on_bowl = max(leaves_sphere, above ? crossing : 0.0);
    float t = on_plane ? crossing : on_bowl;
    if ((on_plane || in_bowl) && t < hit.t) {
        hit.t = t;
        vec3 inward = normalize(to_centre - t * ray.direction);
        hit.normal = on_plane ? normal : inward;
        hit.object = object;
    }
}
