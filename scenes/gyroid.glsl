//@ title   Gyroid
//@ look    "a distance field: a gyroid cut by a ball; its channels' shade, and no holes where the field is steep"
//@ camera  eye 0 1.6 -4  target 0 1.1 0  fov 50
//@ sun     elevation 30  azimuth 140
//@ atmosphere earth
//@ size    512 512
//@ bound   0 1.2 0 1.2
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4
#include "color/checker.glsl"
#include "distance/boolean.glsl"
#include "distance/sphere.glsl"
#include "material/matte.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"

uniform float cells;      //@ slider 6  min 2  max 12  unit 1/m  label "how fine"
uniform float thickness;  //@ slider 0.03  min 0.01  max 0.1  unit m  label "of the walls"

const int GROUND = 0;
const int GYROID = 1;

// The gyroid's level set is not a distance. Its gradient is at most sqrt(3) * cells, so it is divided by that.
float scene_distance(vec3 p) {
    vec3 q = cells * p;
    float level = dot(sin(q), vec3(cos(q.y), cos(q.z), cos(q.x)));
    float wall = abs(level) / (1.7320508 * cells) - thickness;
    return op_intersection(wall, distance_sphere(p, vec3(0.0, 1.2, 0.0), 1.2));
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    march_thinnest = thickness;
    march(ray, vec3(0.0, 1.2, 0.0), 1.2, GYROID, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == GYROID) return matte(vec3(0.8, 0.45, 0.3));
    return matte(checker(hit.position, vec3(0.7), vec3(0.3)));
}
