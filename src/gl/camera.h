/* The camera of a picture. It gives pass/camera.glsl what the rays are made from, and finds where a direction
 * is in the picture. */
#pragma once

#include "base/rectangle.h"
#include "gl/uniforms.h"
#include "scene/scene.h"

typedef struct Camera {
    /* The picture's size in pixels. */
    int width, height;
    /* `right` and `up` lead from the middle of the picture to its edges, in the plane at distance 1 ahead. */
    double eye[3], forward[3], right[3], up[3];
} Camera;

Camera camera_of(const Scene *scene, int width, int height);

/* Adds the uniforms of pass/camera.glsl. */
void camera_uniforms(const Camera *camera, Uniforms *uniforms);

/* Sets `out` to the place of a direction in the picture, in pixels from the top left corner. Returns false if
 * the direction is behind the camera. */
bool camera_project(const Camera *camera, const double direction[3], double out[2]);

/* An ellipse in the picture. On its edge, the vector shape * (pixel - centre) has length 1. */
typedef struct Ellipse {
    double centre[2], shape[2][2];
} Ellipse;

/* Sets `ellipse` to the image of a cone of directions. Returns false if the cone reaches beside or behind the
 * camera; its image is then no ellipse. */
bool camera_cone(const Camera *camera, const double axis[3], double half_angle, Ellipse *ellipse);

/* Returns the pixels that a cone of directions may touch. If its image is no ellipse but may be seen, these
 * are all pixels of the picture. */
Rectangle camera_cone_rectangle(const Camera *camera, const double axis[3], double half_angle);
