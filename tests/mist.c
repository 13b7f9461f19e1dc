#include "mist.h"

#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

Image mist_render(const char *environment, const char *scene, const char *arguments) {
    Image image;
    Error error;
    int status = support_run(environment, "render '%s' --quiet %s -o '%s'", scene, arguments,
                             support_path("picture.pfm"));
    if (status == STATUS_NO_GL) support_no_gl(support_err);
    if (status != 0) fail_msg("render %s %s: %s", scene, arguments, support_err);
    if (!image_read(&image, support_path("picture.pfm"), &error)) fail_msg("%s", error.text);
    return image;
}

void mist_means(const Image *image, double mean[3], double error[3]) {
    int pixels = image->width * image->height;
    for (int c = 0; c < 3; c++) {
        double squares = 0;
        mean[c] = 0;
        for (int i = 0; i < pixels; i++) mean[c] += (double)image->rgba[4 * i + c] / pixels;
        for (int i = 0; i < pixels; i++) squares += pow((double)image->rgba[4 * i + c] - mean[c], 2);
        if (error) error[c] = sqrt(squares) / pixels;
    }
}

static const char ball[] =
    "//@ size 64 64\n//@ sun elevation 40 azimuth 60\n%s\n%s"
    "uniform float dense; //@ slider 0.2 min 0 max 1\nuniform float wide; //@ slider 3 min -1 max 8\n"
    "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n#include \"shape/sphere.glsl\"\n"
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
    "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n"
    "    hit_sphere(ray, vec3(0.0, 0.7, 0.0), 0.7, 1, hit);\n}\n"
    "Material scene_material(Hit hit) { return matte(vec3(%s)); }\n";

const char *mist_ball(const char *name, const char *annotations, const char *albedo) {
    char text[4096];
    bool own = strstr(annotations, "//@ camera") != NULL;
    snprintf(text, sizeof text, ball, annotations,
             own ? "" : "//@ camera eye 0 1.5 -4 target 0 0.5 0 fov 50\n", albedo);
    return support_write(name, text);
}
