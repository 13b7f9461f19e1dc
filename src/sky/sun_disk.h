/* The sun's disk has the angular size that is seen from the Earth and the same brightness all over. The air
 * in front of each of its points reddens it, and the observer's horizon cuts it. */
#pragma once

#include "gl/camera.h"
#include "scene/atmosphere.h"
#include "scene/sun.h"

typedef struct SunDisk {
    /* Unit vectors: toward the disk's middle, toward its right, and toward the zenith. */
    double middle[3], right[3], up[3];
    /* In radians. */
    double radius;
    /* direction.y of its lowest visible point and of its highest point. */
    double lowest, top;
    /* The sine of the visible horizon's elevation. */
    double horizon;
} SunDisk;

SunDisk sun_disk(const Atmosphere *atmosphere, const Sun *sun);

/* Whether any of it is above the horizon. */
bool sun_disk_visible(const SunDisk *disk);

/* The radiance of the disk's point in the unit vector `direction`, as the observer sees it: the sun's
 * irradiance times transmittance, divided by pi sin^2 of the disk's radius. It is 0 outside of the disk and
 * where the planet blocks it. */
void sun_disk_radiance(const SunDisk *disk, const Atmosphere *atmosphere, const double direction[3],
                       double radiance[3]);

/* The radiance at `count` values of direction.y from `lowest` to `top`, four floats each. The values are
 * closest at `lowest`, where radiance changes most: value i is lowest + (top - lowest) (i / (count -
 * 1))^2. */
void sun_disk_table(const SunDisk *disk, const Atmosphere *atmosphere, int count, float *rgba);

/* The mean radiance that the unblocked disk gives each pixel of a rectangle, accurate to 1e-4: four floats
 * each, rows from the top. If the disk is no ellipse in the picture it returns false and writes nothing. */
bool sun_disk_cover(const SunDisk *disk, const Atmosphere *atmosphere, const Camera *camera,
                    Rectangle rectangle, float *rgba);
