// The first half of the inputs' rows hold a table of spheres, with the entries of a list in its last texel; the others rays, origin
// and direction in pairs of texels. Results: distance, sphere, and the same by asking every sphere.
#include "../inputs.glsl"
#include "shape/spheres.glsl"

const int COLUMNS = 256;
const int TABLE_ROWS = 32;

vec4 spheres_texel(int i) {
    return texelFetch(inputs, ivec2(i % COLUMNS, i / COLUMNS), 0);
}

int spheres_entries() {
    return int(spheres_texel(COLUMNS * TABLE_ROWS - 1).x);
}

Hit hit_each(Ray ray) {
    Hit hit = hit_none();
    for (int i = 0; i < spheres_entries(); i++) {
        vec4 a = spheres_texel(2 * i);
        vec4 b = spheres_texel(2 * i + 1);
        float before = hit.t;
        if (b.w == 0.0) hit_sphere(ray, vec3(a), a.w, 3, hit);
        if (hit.t < before) hit.item = int(b.x);
    }
    return hit;
}

vec4 evaluate(vec2 texel) {
    int first = int(texel.x) / 2 * 2;
    int row = int(texel.y);
    if (row < TABLE_ROWS) return vec4(0.0);
    Ray ray = Ray(vec3(texelFetch(inputs, ivec2(first, row), 0)), vec3(texelFetch(inputs, ivec2(first + 1, row), 0)));
    Hit each = hit_each(ray);
    Hit hit = hit_none();
    int before = search_steps;
    hit_spheres(ray, 3, hit);
    float off = length(hit.normal - each.normal);
    return int(texel.x) == first ? vec4(hit.t, each.t, float(hit.item), float(each.item))
                                 : vec4(float(hit.object), float(each.object), off, float(search_steps - before));
}
