/* The sun's disk: as wide as it is seen from the Earth, uniform, reddened by the air in front of each of its
 * points, cut by the observer's horizon. */
#pragma once

#include "gl/camera.h"
#include "scene/atmosphere.h"
#include "scene/sun.h"

typedef struct SunDisk {
    double middle[3], right[3],
        up[3];          /* unit vectors: toward the disk's middle, across, and toward the zenith */
    double radius;      /* radians */
    double lowest, top; /* direction.y of its lowest visible point and of its highest */
    double horizon;     /* sine of the visible horizon's elevation */
} SunDisk;

SunDisk sun_disk(const Atmosphere *atmosphere, const Sun *sun);

/* Whether any of it is above the horizon. */
bool sun_disk_visible(const SunDisk *disk);

/* Radiance of the disk's point in the unit vector `direction` as seen from the observer: sun irradiance times
 * transmittance over pi sin^2 of the radius, 0 outside of the disk and where the planet is in the way. */
void sun_disk_radiance(const SunDisk *disk, const Atmosphere *atmosphere, const double direction[3],
                       double radiance[3]);

/* Radiances at `count` values of direction.y from lowest to top, spaced by the square root above the lowest,
 * where they change most; four floats each. */
void sun_disk_table(const SunDisk *disk, const Atmosphere *atmosphere, int count, float *rgba);

/* The mean radiance that the unblocked disk gives each pixel of a rectangle, exact to 1e-4: four floats each,
 * rows from the top. False, and nothing written, where the disk is no ellipse in the picture. */
bool sun_disk_cover(const SunDisk *disk, const Atmosphere *atmosphere, const Camera *camera,
                    Rectangle rectangle, float *rgba);
