/* The camera of a picture: what pass/camera.glsl makes its rays from, and where directions fall in the
 * picture. */
#pragma once

#include "base/rectangle.h"
#include "gl/program.h"
#include "scene/scene.h"

typedef struct Camera {
    int width, height; /* of the picture, pixels */
    double eye[3], forward[3], right[3],
        up[3]; /* right and up reach the picture's edges at distance 1 ahead */
} Camera;

Camera camera_of(const Scene *scene, int width, int height);

/* Tells the program in use. */
void camera_set(const Camera *camera, const Program *program);

/* Where a direction falls, in pixels from the top left corner, in out[0] and out[1]; false behind the camera.
 */
bool camera_project(const Camera *camera, const double direction[3], double out[2]);

/* A cone of directions as an ellipse in the picture: w = shape (pixel - centre) has length 1 on its edge.
 * False where the cone reaches beside or behind the camera and is none. */
typedef struct Ellipse {
    double centre[2], shape[2][2];
} Ellipse;
bool camera_cone(const Camera *camera, const double axis[3], double half_angle, Ellipse *ellipse);

/* The pixels that the cone may touch: all of the picture's where it is no ellipse but may be seen. */
Rectangle camera_cone_rectangle(const Camera *camera, const double axis[3], double half_angle);
