#include "gl/camera.h"

#include "base/vec3.h"

#include <math.h>
#include <string.h>

static void scale_to(double v[3], double length) {
    vec3_scale(v, length / vec3_length(v), v);
}

Camera camera_of(const Scene *scene, int width, int height) {
    Camera camera = {.width = width, .height = height};
    double world_up[3] = {0, 1, 0};
    const Viewpoint *from = &scene->values.camera;
    double half_height = tan(from->fov_deg * degree / 2);
    memcpy(camera.eye, from->eye, sizeof camera.eye);
    vec3_subtract(from->target, from->eye, camera.forward);
    scale_to(camera.forward, 1);
    if (fabs(camera.forward[1]) > 1 - 1e-12) {
        /* The camera looks straight up or down, so the picture's top is +z. */
        world_up[1] = 0;
        world_up[2] = 1;
    }
    vec3_cross(camera.forward, world_up, camera.right);
    scale_to(camera.right, half_height * width / height);
    vec3_cross(camera.right, camera.forward, camera.up);
    scale_to(camera.up, half_height);
    return camera;
}

void camera_uniforms(const Camera *camera, Uniforms *uniforms) {
    double size[3] = {camera->width, camera->height, 0};
    uniforms_declared_in(uniforms, "pass/camera.glsl");
    uniforms_vec3(uniforms, "camera_eye", camera->eye);
    uniforms_vec3(uniforms, "camera_forward", camera->forward);
    uniforms_vec3(uniforms, "camera_right", camera->right);
    uniforms_vec3(uniforms, "camera_up", camera->up);
    uniforms_vec3(uniforms, "picture_size", size);
}

bool camera_project(const Camera *camera, const double direction[3], double out[2]) {
    double ahead = vec3_dot(direction, camera->forward);
    if (ahead <= 0) return false;
    double x = vec3_dot(direction, camera->right) / vec3_dot(camera->right, camera->right) / ahead;
    double y = vec3_dot(direction, camera->up) / vec3_dot(camera->up, camera->up) / ahead;
    out[0] = (1 + x) / 2 * camera->width;
    out[1] = (1 - y) / 2 * camera->height;
    return true;
}

/* On the plane at distance 1 ahead, the cone is where q(x, y) = (s . (x, y, 1))^2 - cos^2 (x^2 + y^2 + 1) >=
 * 0. Here s is the cone's axis in the camera's frame. This is an ellipse if all of the cone is ahead. */
bool camera_cone(const Camera *camera, const double axis[3], double half_angle, Ellipse *ellipse) {
    double width = vec3_length(camera->right), height = vec3_length(camera->up);
    double s[3] = {vec3_dot(axis, camera->right) / width, vec3_dot(axis, camera->up) / height,
                   vec3_dot(axis, camera->forward)};
    double cos2 = cos(half_angle) * cos(half_angle), sine = sin(half_angle);
    if (half_angle >= 90 * degree || s[2] <= sine * (1 + 1e-9)) return false;
    double a = cos2 - s[0] * s[0], b = -s[0] * s[1], c = cos2 - s[1] * s[1], determinant = a * c - b * b;
    double x = (c * s[0] - b * s[1]) * s[2] / determinant, y = (a * s[1] - b * s[0]) * s[2] / determinant;
    double ahead = s[0] * x + s[1] * y + s[2], top = ahead * ahead - cos2 * (x * x + y * y + 1);
    if (!(determinant > 0) || !(top > 0)) return false;
    /* `shape` is the transposed Cholesky factor of the quadratic form, which is divided by its value at the
     * centre, and is then converted from the plane to pixels. The y of pixels points down. */
    double l00 = sqrt(a / top), l10 = b / top / l00, l11 = sqrt(fmax(c / top - l10 * l10, 0));
    double pixels_x = camera->width / (2 * width), pixels_y = camera->height / (2 * height);
    *ellipse = (Ellipse){{camera->width / 2.0 + x * pixels_x, camera->height / 2.0 - y * pixels_y},
                         {{l00 / pixels_x, -l10 / pixels_y}, {0, -l11 / pixels_y}}};
    return true;
}

static Rectangle clip(const Camera *camera, double left, double top, double right, double bottom) {
    double x0 = fmax(floor(left), 0), x1 = fmin(ceil(right), camera->width);
    double y0 = fmax(floor(top), 0), y1 = fmin(ceil(bottom), camera->height);
    if (!(x0 < x1 && y0 < y1)) return (Rectangle){0};
    return (Rectangle){(int)x0, (int)y0, (int)(x1 - x0), (int)(y1 - y0)};
}

Rectangle camera_cone_rectangle(const Camera *camera, const double axis[3], double half_angle) {
    Ellipse e;
    if (!camera_cone(camera, axis, half_angle, &e)) {
        bool behind = vec3_dot(axis, camera->forward) <= -sin(half_angle);
        if (behind) return (Rectangle){0};
        return (Rectangle){0, 0, camera->width, camera->height};
    }
    /* The ellipse is centre + inverse(shape) * (unit circle). Half the width of its box is the length of the
     * first row of the inverse, and half the height is the length of the second. */
    double i11 = 1 / e.shape[1][1], i00 = 1 / e.shape[0][0], i01 = -e.shape[0][1] * i00 * i11;
    double half_width = hypot(i00, i01), half_height = fabs(i11);
    return clip(camera, e.centre[0] - half_width, e.centre[1] - half_height, e.centre[0] + half_width,
                e.centre[1] + half_height);
}
