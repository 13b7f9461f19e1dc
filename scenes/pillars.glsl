//@ title   Pillars
//@ look    "rows of pillars at the magic hour: each one's soft shade away from the glow, no seam halfway between two"
//@ camera  eye 3.3 1.7 -8.2  target -0.4 1.0 0  fov 50
//@ sun     elevation 3  azimuth 60
//@ atmosphere earth
//@ size    640 480
//@ exposure 0.8
//@ preset  noon      sun.elevation 60  exposure 0
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4
#include "color/checker.glsl"
#include "distance/boolean.glsl"
#include "distance/box.glsl"
#include "distance/cylinder.glsl"
#include "distance/offset.glsl"
#include "distance/repeat.glsl"
#include "material/matte.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"

uniform float spacing; //@ slider 1.6  min 1.2  max 3  unit m  label "from pillar to pillar"
uniform float height;  //@ slider 2.2  min 0.5  max 4  unit m  label "of the pillars"
uniform float radius;  //@ slider 0.22  min 0.05  max 0.4  unit m  label "of the pillars"

const vec3 COUNT = vec3(5.0, 0.0, 6.0);
const int GROUND = 0;
const int PILLAR = 1;

// A pillar about the origin: a shaft between two slabs.
float pillar(vec3 p) {
    float shaft = distance_cylinder(p, vec3(0.0), vec3(0.0, height, 0.0), radius);
    // The absolute value makes one slab stand for both.
    vec3 to_slab = vec3(p.x, abs(p.y - 0.5 * height) - 0.5 * height, p.z);
    float slab = op_round(distance_box(to_slab, vec3(0.0), vec3(1.3 * radius, 0.06, 1.3 * radius)), 0.02);
    return op_union(shaft, slab);
}

// The nearest pillar stands in the cell of p, or in one of the three neighbours next to the quarter of the cell where p is.
float scene_distance(vec3 p) {
    float d = INFINITY;
    for (int i = 0; i < 4; i++) d = min(d, pillar(repeat_cell(p, vec3(spacing, 0.0, spacing), COUNT, i)));
    return d;
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    float slab = 1.3 * radius + 0.02;
    vec3 reach = vec3(2.0 * spacing + slab, 0.5 * height + 0.08, 2.5 * spacing + slab);
    march_thinnest = min(radius, 0.1);
    march(ray, vec3(0.0, 0.5 * height, 0.0), reach, PILLAR, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == PILLAR) return matte(vec3(0.75, 0.7, 0.62));
    return matte(checker(hit.position, vec3(0.5), vec3(0.4)));
}
