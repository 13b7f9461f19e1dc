#include "facets.h"

#include <math.h>
#include <stdbool.h>

typedef struct Walk {
    double direction[3]; /* of the light; the surface's normal is 0,0,1 */
    double below;        /* the share of the surface that lies below the place, 1 where none lies above */
    uint64_t state;      /* of the random numbers */
} Walk;

/* Vigna's xorshift64*: more than 0, less than 1. */
static double walk_random(Walk *walk) {
    walk->state ^= walk->state >> 12;
    walk->state ^= walk->state << 25;
    walk->state ^= walk->state >> 27;
    return ((double)(walk->state * 2685821657736338717u >> 11) + 0.5) / 9007199254740992.0;
}

static void normalise(double v[3]) {
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int c = 0; c < 3; c++) v[c] /= length;
}

/* Goes on to the next facet. False: there is none, and the light leaves. Smith's Lambda says how many facets
 * a ray meets on its way from all heights to all heights: the walk needs no heights, but only shares. */
static bool walk_reaches_facet(Walk *walk, double alpha) {
    double z = walk->direction[2];
    if (fabs(z) < 1e-9) z = z < 0 ? -1e-9 : 1e-9;
    double tangent2 = fmax(1 - z * z, 0) / (z * z);
    double lambda = 0.5 * (-1 + copysign(sqrt(1 + alpha * alpha * tangent2), z));
    double below = lambda > 0 || z < 0 ? walk->below * pow(walk_random(walk), -1 / lambda) : 1;
    if (z > 0 && below >= 1) return false;
    walk->below = fmax(below, 1e-300);
    return true;
}

/* Reflects the light at a facet, drawn in proportion to how much of it the light sees, from above or from
 * below, and returns the cosine between the light and the facet's normal. Stretched by 1 / alpha, the facets
 * are those of a hemisphere. Mirrored at them, the view becomes any direction above minus the view's own
 * height, all as likely (Dupuy and Benyoub 2023). */
static double walk_reflect(Walk *walk, double alpha) {
    double *d = walk->direction, view[3] = {-alpha * d[0], -alpha * d[1], -d[2]};
    normalise(view);
    double z = 1 - walk_random(walk) * (1 + view[2]), level = sqrt(fmax(1 - z * z, 0));
    double azimuth = 2 * 3.14159265358979323846 * walk_random(walk);
    double facet[3] = {alpha * (view[0] + level * cos(azimuth)), alpha * (view[1] + level * sin(azimuth)),
                       view[2] + z};
    normalise(facet);
    double cosine = fmin(fmax(-(d[0] * facet[0] + d[1] * facet[1] + d[2] * facet[2]), 0), 1);
    for (int c = 0; c < 3; c++) d[c] += 2 * cosine * facet[c];
    normalise(d);
    return cosine;
}

FacetsAlbedo facets_albedo(double alpha, const double tints[FACETS_TINTS], double cosine, uint64_t walks) {
    FacetsAlbedo albedo = {{0}, {0}};
    Walk walk = {.state = 88172645463325252u};
    for (uint64_t n = 0; n < walks; n++) {
        double light[FACETS_TINTS];
        int facets = 0;
        for (int k = 0; k < FACETS_TINTS; k++) light[k] = 1;
        walk.below = 1;
        walk.direction[0] = sqrt(1 - cosine * cosine);
        walk.direction[1] = 0;
        walk.direction[2] = -cosine;
        for (; walk_reaches_facet(&walk, alpha); facets++) {
            double grazing = pow(1 - walk_reflect(&walk, alpha), 5);
            for (int k = 0; k < FACETS_TINTS; k++) light[k] *= tints[k] + (1 - tints[k]) * grazing;
        }
        for (int k = 0; k < FACETS_TINTS; k++) {
            albedo.all[k] += light[k] / (double)walks;
            if (facets == 1) albedo.once[k] += light[k] / (double)walks;
        }
    }
    return albedo;
}
