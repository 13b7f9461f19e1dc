#include "sky/sun_disk.h"

#include "base/memory.h"
#include "base/vec3.h"
#include "scene/spectrum.h"
#include "sky/sky.h"
#include "sky/sky_reference.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STRIPS = 48, COLUMNS = 512 };

SunDisk sun_disk(const Atmosphere *atmosphere, const Sun *sun) {
    const double *level = sun->level;
    double elevation = sun->elevation_deg * degree, radius = sun->radius_deg * degree;
    SunDisk disk = {.right = {-level[2], 0, level[0]},
                    .up = {-sin(elevation) * level[0], cos(elevation), -sin(elevation) * level[2]},
                    .radius = radius,
                    .horizon = sky_horizon_sine(atmosphere)};
    memcpy(disk.middle, sun->direction, sizeof disk.middle);
    double bottom = fmax(elevation - radius, -pi / 2), highest = fmin(elevation + radius, pi / 2);
    disk.lowest = fmax(sin(bottom), disk.horizon);
    disk.top = elevation + radius > pi / 2 ? 1 : sin(highest);
    if (elevation - radius < -pi / 2) disk.lowest = fmax(-1, disk.horizon);
    return disk;
}

bool sun_disk_visible(const SunDisk *disk) {
    return disk->top > disk->lowest;
}

static void radiance_toward(const SunDisk *disk, const Atmosphere *atmosphere, const double direction[3],
                            double radiance[3]) {
    double solid_angle = pi * sin(disk->radius) * sin(disk->radius);
    for (int c = 0; c < 3; c++) radiance[c] = 0;
    for (int band = 0; band < spectrum_bands(atmosphere); band++) {
        Atmosphere air = spectrum_band(atmosphere, band);
        double channels[3];
        sky_reference_transmittance(&air, air.observer_height_m, direction, channels);
        for (int c = 0; c < 3; c++) channels[c] *= air.sun_irradiance[c] / solid_angle;
        spectrum_add(atmosphere, band, channels, radiance);
    }
}

void sun_disk_radiance(const SunDisk *disk, const Atmosphere *atmosphere, const double direction[3],
                       double radiance[3]) {
    double squared = 0;
    for (int i = 0; i < 3; i++)
        squared += (disk->middle[i] - direction[i]) * (disk->middle[i] - direction[i]);
    /* The chord keeps its digits for small angles; a cosine does not. */
    bool inside = squared < 4 * sin(disk->radius / 2) * sin(disk->radius / 2);
    if (inside) radiance_toward(disk, atmosphere, direction, radiance);
    for (int c = 0; c < 3 && !inside; c++) radiance[c] = 0;
}

void sun_disk_table(const SunDisk *disk, const Atmosphere *atmosphere, int count, float *rgba) {
    for (int i = 0; i < count; i++) {
        /* The lowest value lies slightly above the horizon. On the horizon, rounding would decide whether the
         * planet blocks the light. */
        double at = fmax(i, 1e-2) / (count - 1), y = disk->lowest + (disk->top - disk->lowest) * at * at;
        double level = sqrt(fmax(1 - y * y, 0)), radiance[3];
        const double direction[3] = {level, y, 0};
        radiance_toward(disk, atmosphere, direction, radiance);
        for (int c = 0; c < 3; c++) rgba[4 * i + c] = (float)radiance[c];
        rgba[4 * i + 3] = 1;
    }
}

/* A convex polygon; a square clipped by two lines has at most 6 corners. */
typedef struct Polygon {
    double points[8][2];
    int count;
} Polygon;

/* The part of the polygon where line[0] x + line[1] y + line[2] >= 0. */
static Polygon clip(const Polygon *polygon, const double line[3]) {
    Polygon clipped = {.count = 0};
    for (int i = 0; i < polygon->count; i++) {
        const double *a = polygon->points[i], *b = polygon->points[(i + 1) % polygon->count];
        double fa = line[0] * a[0] + line[1] * a[1] + line[2], fb = line[0] * b[0] + line[1] * b[1] + line[2];
        if (fa >= 0) memcpy(clipped.points[clipped.count++], a, sizeof *clipped.points);
        if ((fa >= 0) != (fb >= 0)) {
            double *p = clipped.points[clipped.count++];
            for (int k = 0; k < 2; k++) p[k] = a[k] + (b[k] - a[k]) * fa / (fa - fb);
        }
    }
    return clipped;
}

/* The signed area of the part of the unit circle in the triangle (0, a, b). */
static double sector_area(const double a[2], const double b[2]) {
    double d[2] = {b[0] - a[0], b[1] - a[1]}, length2 = d[0] * d[0] + d[1] * d[1];
    double along = a[0] * d[0] + a[1] * d[1], off = a[0] * a[0] + a[1] * a[1] - 1;
    double discriminant = along * along - length2 * off;
    double area = 0, from = 0;
    if (length2 == 0) return 0;
    /* The part of the edge inside the circle makes a triangle, the rest of it makes sectors. */
    if (discriminant > 0) {
        double root = sqrt(discriminant);
        double t0 = fmin(fmax((-along - root) / length2, 0), 1),
               t1 = fmin(fmax((-along + root) / length2, 0), 1);
        double p[2] = {a[0] + t0 * d[0], a[1] + t0 * d[1]}, q[2] = {a[0] + t1 * d[0], a[1] + t1 * d[1]};
        if (t1 > t0) {
            area += (p[0] * q[1] - p[1] * q[0]) / 2;
            area += atan2(a[0] * p[1] - a[1] * p[0], a[0] * p[0] + a[1] * p[1]) / 2;
            area += atan2(q[0] * b[1] - q[1] * b[0], q[0] * b[0] + q[1] * b[1]) / 2;
            from = 1;
        }
    }
    if (from == 0) area = atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]) / 2;
    return area;
}

/* The area of a polygon's part inside the ellipse. */
static double area_in(const Ellipse *e, const Polygon *polygon) {
    double w[8][2], area = 0;
    for (int i = 0; i < polygon->count; i++) {
        double x = polygon->points[i][0] - e->centre[0], y = polygon->points[i][1] - e->centre[1];
        for (int k = 0; k < 2; k++) w[i][k] = e->shape[k][0] * x + e->shape[k][1] * y;
    }
    for (int i = 0; i < polygon->count; i++) area += sector_area(w[i], w[(i + 1) % polygon->count]);
    return fabs(area / (e->shape[0][0] * e->shape[1][1] - e->shape[0][1] * e->shape[1][0]));
}

/* The disk cut into level strips, thinnest at its lowest point. The lines between them are where up / middle
 * is constant, in the picture. */
typedef struct Strips {
    double line[STRIPS + 1][3];
} Strips;

static Strips cut(const SunDisk *disk, const Camera *camera) {
    Strips strips = {0};
    double elevation = asin(disk->middle[1]), slope = tan(disk->radius);
    /* The horizon may be more than 90 degrees below the disk, where a tangent has another sign. */
    double horizon = fmax(asin(disk->horizon) - elevation, -disk->radius);
    double from = tan(fmin(horizon, disk->radius)) / slope;
    for (int k = 0; k <= STRIPS; k++) {
        double edge = from + (1 - from) * ((double)k / STRIPS) * ((double)k / STRIPS), plane[3],
               on_picture[3];
        for (int i = 0; i < 3; i++) plane[i] = disk->up[i] - edge * slope * disk->middle[i];
        /* In pixels. The direction of pixel (x, y) is forward + (2 x / width - 1) right + (1 - 2 y / height)
         * up. */
        on_picture[0] = 2 * vec3_dot(plane, camera->right) / camera->width;
        on_picture[1] = -2 * vec3_dot(plane, camera->up) / camera->height;
        on_picture[2] =
            vec3_dot(plane, camera->forward) - vec3_dot(plane, camera->right) + vec3_dot(plane, camera->up);
        memcpy(strips.line[k], on_picture, sizeof on_picture);
    }
    return strips;
}

/* The disk's radiance at the middle of a part, from the table. */
static void radiance_of(const SunDisk *disk, const Camera *camera, const Polygon *part, const float *table,
                        double radiance[3]) {
    double middle[2] = {0}, area = 0, direction[3], length2 = 0;
    for (int i = 0; i < part->count; i++) {
        const double *a = part->points[i], *b = part->points[(i + 1) % part->count];
        double o[2] = {part->points[0][0], part->points[0][1]};
        double twice = (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
        for (int k = 0; k < 2; k++) middle[k] += twice * (a[k] + b[k] + o[k]) / 3;
        area += twice;
    }
    for (int k = 0; k < 2; k++) middle[k] = area != 0 ? middle[k] / area : part->points[0][k];
    for (int i = 0; i < 3; i++) {
        direction[i] = camera->forward[i] + (2 * middle[0] / camera->width - 1) * camera->right[i] +
                       (1 - 2 * middle[1] / camera->height) * camera->up[i];
        length2 += direction[i] * direction[i];
    }
    double height = (direction[1] / sqrt(length2) - disk->lowest) / (disk->top - disk->lowest);
    double at = sqrt(fmax(height, 0)) * (COLUMNS - 1);
    double clamped = fmin(fmax(at, 0), COLUMNS - 1.001);
    const float *entry = table + 4 * (int)clamped;
    for (int c = 0; c < 3; c++)
        radiance[c] = (double)entry[c] + (clamped - floor(clamped)) * (double)(entry[4 + c] - entry[c]);
}

static void cover_pixel(const SunDisk *disk, const Camera *camera, const Strips *strips,
                        const Ellipse *ellipse, const float *table, int x, int y, float rgba[4]) {
    const Polygon pixel = {{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}, 4};
    double sum[3] = {0};
    for (int k = 0; k < STRIPS; k++) {
        const double *bottom = strips->line[k], *top = strips->line[k + 1];
        const double below_top[3] = {-top[0], -top[1], -top[2]};
        Polygon above = clip(&pixel, bottom);
        /* The pixel is also below all strips that follow. */
        if (!above.count) break;
        Polygon part = clip(&above, below_top);
        double area = part.count > 2 ? area_in(ellipse, &part) : 0;
        if (area <= 0) continue;
        double radiance[3];
        radiance_of(disk, camera, &part, table, radiance);
        for (int c = 0; c < 3; c++) sum[c] += area * radiance[c];
    }
    for (int c = 0; c < 3; c++) rgba[c] = (float)sum[c];
    rgba[3] = 1;
}

bool sun_disk_cover(const SunDisk *disk, const Atmosphere *atmosphere, const Camera *camera,
                    Rectangle rectangle, float *rgba) {
    Ellipse ellipse;
    if (!camera_cone(camera, disk->middle, disk->radius, &ellipse)) return false;
    const Strips strips = cut(disk, camera);
    float *table = memory_get(4 * COLUMNS, sizeof *table);
    sun_disk_table(disk, atmosphere, COLUMNS, table);
    for (int y = 0; y < rectangle.height; y++) {
        for (int x = 0; x < rectangle.width; x++) {
            cover_pixel(disk, camera, &strips, &ellipse, table, rectangle.x + x, rectangle.y + y,
                        rgba + 4 * ((size_t)y * (size_t)rectangle.width + (size_t)x));
        }
    }
    free(table);
    return true;
}
