#include "view/orbit.h"

#include "base/vec3.h"

#include <math.h>
#include <string.h>

static const double nearest = 1e-3, farthest = 1e5, most_coordinate = 9e5, steepest_deg = 89.5;

/* A vector as length, azimuth from +z toward +x, and elevation. */
typedef struct Polar {
    double length, azimuth_deg, elevation_deg;
} Polar;

static Polar polar_of(const double from[3], const double to[3]) {
    double x = to[0] - from[0], y = to[1] - from[1], z = to[2] - from[2];
    double length = sqrt(x * x + y * y + z * z);
    return (Polar){length, atan2(x, z) / degree, asin(fmin(fmax(y / length, -1), 1)) / degree};
}

static void place(const double from[3], Polar polar, double out[3]) {
    double elevation = fmin(fmax(polar.elevation_deg, -steepest_deg), steepest_deg) * degree;
    double azimuth = polar.azimuth_deg * degree;
    out[0] = from[0] + polar.length * cos(elevation) * sin(azimuth);
    out[1] = from[1] + polar.length * sin(elevation);
    out[2] = from[2] + polar.length * cos(elevation) * cos(azimuth);
}

double orbit_distance(const Scene *scene) {
    return polar_of(scene->values.camera.target, scene->values.camera.eye).length;
}

void orbit_turn(Scene *scene, double right_deg, double up_deg) {
    Polar polar = polar_of(scene->values.camera.target, scene->values.camera.eye);
    polar.azimuth_deg -= right_deg;
    polar.elevation_deg -= up_deg;
    place(scene->values.camera.target, polar, scene->values.camera.eye);
}

void orbit_look(Scene *scene, double right_deg, double up_deg) {
    Polar polar = polar_of(scene->values.camera.eye, scene->values.camera.target);
    polar.azimuth_deg -= right_deg;
    polar.elevation_deg += up_deg;
    place(scene->values.camera.eye, polar, scene->values.camera.target);
}

void orbit_zoom(Scene *scene, double factor) {
    double distance = orbit_distance(scene), wanted = fmin(fmax(distance * factor, nearest), farthest);
    for (int i = 0; i < 3; i++)
        scene->values.camera.eye[i] =
            scene->values.camera.target[i] +
            (scene->values.camera.eye[i] - scene->values.camera.target[i]) * wanted / distance;
}

void orbit_move(Scene *scene, double right, double up, double ahead) {
    Polar view = polar_of(scene->values.camera.eye, scene->values.camera.target);
    double a = view.azimuth_deg * degree, e = view.elevation_deg * degree;
    double forward[3] = {cos(e) * sin(a), sin(e), cos(e) * cos(a)}, side[3] = {-cos(a), 0, sin(a)};
    double over[3] = {-sin(e) * sin(a), cos(e), -sin(e) * cos(a)}, step[3];
    for (int i = 0; i < 3; i++) step[i] = right * side[i] + up * over[i] + ahead * forward[i];
    for (int i = 0; i < 3; i++) {
        if (fabs(scene->values.camera.eye[i] + step[i]) > most_coordinate ||
            fabs(scene->values.camera.target[i] + step[i]) > most_coordinate)
            return;
    }
    for (int i = 0; i < 3; i++)
        scene->values.camera.eye[i] += step[i], scene->values.camera.target[i] += step[i];
}
