#include "chart/field.h"

#include <math.h>

/* The side of the square that the spheres lie on, in metres. */
static const double side = 8;

static int columns_of(int count) {
    return (int)ceil(sqrt(count));
}

/* Returns the spheres' radius. The gaps between spheres are a third of it. */
static double radius_of(int count) {
    return side / columns_of(count) * 0.43;
}

static const char head[] = "//@ title Spheres\n//@ camera eye 0 6 -8  target 0 0 0  fov 60\n"
                           "//@ sun elevation 30 azimuth 60\n"
                           "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n";

static const char material[] = "Material scene_material(Hit hit) {\n"
                               "    return matte(vec3(hit.object == 1 ? 0.7 : 0.4));\n}\n";

static const char intersect[] = "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                                "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n";

void field_of_calls(int count, Text *out) {
    int columns = columns_of(count);
    double radius = radius_of(count), step = side / columns;
    text_print(out, "%s#include \"shape/sphere.glsl\"\n%s", head, intersect);
    for (int i = 0; i < count; i++) {
        text_print(out, "    hit_sphere(ray, vec3(%.6f, %.6f, %.6f), %.6f, 1, hit);\n",
                   (i % columns + 0.5) * step - side / 2, radius, (i / columns + 0.5) * step - side / 2,
                   radius);
    }
    text_print(out, "}\n%s", material);
}

void field_of_set(int count, Text *out) {
    int columns = columns_of(count);
    double radius = radius_of(count), step = side / columns;
    text_print(out, "//@ spheres %d\n%s#include \"shape/spheres.glsl\"\n", count, head);
    text_print(out,
               "vec4 scene_sphere(int i) {\n"
               "    int row = i / %d;\n"
               "    vec2 at = (vec2(float(i - %d * row), float(row)) + 0.5) * %.6f - %.6f;\n"
               "    return vec4(at.x, %.6f, at.y, %.6f);\n}\n",
               columns, columns, step, side / 2, radius, radius);
    text_print(out, "%s    hit_spheres(ray, 1, hit);\n}\n%s", intersect, material);
}
