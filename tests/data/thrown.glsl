//@ title   Everything that throws sunlight, with a disk that paths find by chance, too
//@ camera  eye 0 2.6 -4.6 target 0 0.5 0 fov 50
//@ sun elevation 50 azimuth 90 radius 15
//@ sun-disk on
//@ sky uniform:0.3
//@ size 64 64
//@ mirror-sphere 1.5 0.5 -0.9 0.4
//@ mirror-plane 180 0
#include "material/author.glsl"
#include "material/glass.glsl"
#include "material/matte.glsl"
#include "material/mirror.glsl"
#include "material/rough_metal.glsl"
#include "shape/box.glsl"
#include "shape/plane.glsl"
#include "shape/sphere.glsl"

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);
    hit_sphere(ray, vec3(-0.3, 0.75, 0.0), 0.6, 1, hit);
    // A matte ball within the glass: light scatters there and goes on through glass.
    hit_sphere(ray, vec3(-0.3, 0.5, 0.0), 0.15, 2, hit);
    hit_box(ray, vec3(-1.9, 0.6, 0.0), vec3(0.1, 0.6, 0.9), 3, hit);
    hit_box(ray, vec3(2.0, 0.8, 0.6), vec3(0.1, 0.8, 0.7), 4, hit);
    hit_sphere(ray, vec3(1.5, 0.5, -0.9), 0.4, 5, hit);
    hit_box(ray, vec3(0.0, 0.7, 1.6), vec3(1.2, 0.7, 0.05), 6, hit);
    hit_sphere(ray, vec3(0.6, 0.3, -0.9), 0.3, 7, hit);
    hit_sphere(ray, vec3(-1.1, 0.3, -0.9), 0.3, 8, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == 1) return glass_tinted(vec3(0.9, 0.95, 1.0), 1.5);
    if (hit.object == 2) return matte(vec3(0.7, 0.2, 0.2));
    if (hit.object == 3) return rough_metal(vec3(0.9, 0.7, 0.4), 0.35);
    if (hit.object == 4) return mirror(vec3(0.9));
    if (hit.object == 5) return mirror(vec3(0.8));
    if (hit.object == 6) return mirror(vec3(0.7, 0.8, 0.9));
    if (hit.object == 7) return author(vec3(0.8, 0.5, 0.5), 0.7, 0.2, 0.1);
    if (hit.object == 8) return rough_metal(vec3(0.9), 0.65);
    return matte(vec3(0.6, 0.55, 0.5));
}
