#include "scene/sun.h"

#include "base/vec3.h"

Sun sun_at(double elevation_deg, double azimuth_deg, double radius_deg) {
    double elevation = elevation_deg * degree, azimuth = azimuth_deg * degree;
    double across = sin(azimuth), ahead = cos(azimuth);
    return (Sun){.elevation_deg = elevation_deg,
                 .azimuth_deg = azimuth_deg,
                 .radius_deg = radius_deg,
                 .direction = {cos(elevation) * across, sin(elevation), cos(elevation) * ahead},
                 .level = {across, 0, ahead}};
}
