// The sunlight by way of flat mirrors, for those that the scene names (`mirror-plane`). Each chain of up to PLANE_CHAIN reflections
// shows the disk in one direction and at its true size.
//
// A name is a hint, and a wrong one does no harm: the ray in that direction must hit exactly those mirrors and leave the scene.
// planes_know() is true for exactly the light that planes_reflect() adds, so that it is counted once.
#include "light/through.glsl"
#include "material/mirror.glsl"
#include <mirror-planes>

const int PLANE_CHAIN = 4;

// The mirror's normal. The opposite one would serve as well.
vec3 plane_normal(int i) {
    // Azimuth and elevation.
    vec2 angles = radians(mirror_plane(i));
    return vec3(cos(angles.y) * sin(angles.x), sin(angles.y), cos(angles.y) * cos(angles.x));
}

// The number of a mirror on which a hit may lie, the first if several face the same way; -1 if there is none. Only the normals are
// compared, to a two-hundredth of the sun's radius.
int plane_at(Hit hit) {
    int at = -1;
    for (int i = MIRROR_PLANES - 1; i >= 0; i--) {
        vec3 normal = plane_normal(i);
        if (min(length(hit.normal - normal), length(hit.normal + normal)) < 2.0e-5) at = i;
    }
    return at;
}

bool planes_know(Hit hit, Material material) {
    return material.kind == MATERIAL_MIRROR && plane_at(hit) >= 0;
}

// The mirror at a place of the chain. The digits of u in a base of the number of mirrors choose the chain.
int plane_of_chain(float u, int place) {
    float planes = float(MIRROR_PLANES);
    float digits = u;
    for (int i = 0; i < place; i++) digits = fract(digits * planes);
    return min(int(digits * planes), MIRROR_PLANES - 1);
}

// One chain of at most `mirrors` reflections stands for all. One more reflection has a probability of one half, and each mirror is
// as likely as the others.
vec3 planes_reflect(Hit hit, Material material, vec3 incoming, vec3 toward, int mirrors, INOUT(Sequence) sequence) {
    vec2 u = sequence_pair(sequence);
    int most = min(mirrors, PLANE_CHAIN);
    int count = 1;
    // The density of the chain.
    float share = 1.0 / float(MIRROR_PLANES);
    float rest = u.x;
    for (int i = 1; i < PLANE_CHAIN; i++) {
        bool may = count == i && i < most;
        bool longer = may && rest < 0.5;
        share *= may ? 0.5 : 1.0;
        share /= longer ? float(MIRROR_PLANES) : 1.0;
        count += longer ? 1 : 0;
        rest = fract(2.0 * rest);
    }
    vec3 direction = toward;
    for (int i = PLANE_CHAIN - 1; i >= 0; i--) {
        vec3 normal = plane_normal(plane_of_chain(u.y, i));
        if (i < count) direction = mirror_direction(direction, normal);
    }
    vec3 reflected = material_value(material, hit.normal, incoming, direction);
    if (most > 0 && max(reflected.x, max(reflected.y, reflected.z)) > 0.0) {
        Ray ray = ray_from(hit, direction);
        bool open = true;
        for (int i = 0; i < PLANE_CHAIN; i++) {
            if (open && i < count) {
                Hit seen = surface_hit(ray);
                open = seen.t < INFINITY && plane_at(seen) == plane_of_chain(u.y, i);
                if (open) {
                    Material mirror = surface_material(seen);
                    open = mirror.kind == MATERIAL_MIRROR;
                    reflected *= mirror.color * light_through(ray, seen.t);
                    ray = ray_from(seen, mirror_direction(ray.direction, seen.normal));
                }
            }
        }
        vec3 sun = sun_solid_angle() / share * sun_radiance(ray.direction);
        reflected *= open ? sun * light_arriving(ray) : vec3(0.0);
    } else {
        reflected = vec3(0.0);
    }
    return reflected;
}
