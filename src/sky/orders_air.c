#include "sky/orders_air.h"

#include "base/vec3.h"
#include "sky/air_column.h"

#include <math.h>
#include <string.h>

/* Nodes of a segment crowd where the air is dense: u of (0,1) lies at c u / (1 + c - u). */
static const double crowding = 0.5;

/* Where sunlight has passed this many scale heights above the ground, it is cut: next to the shadow it falls
 * to nothing within a short distance. */
static const double dusk = 0.5;

OrdersAir orders_air(const Atmosphere *atmosphere, int most, bool peak) {
    OrdersAir air = {.atmosphere = *atmosphere};
    double chi[HARMONICS_MOST_DEGREE + 4];
    harmonics_mie(atmosphere->mie_g, most + 3, chi);
    double share = peak && atmosphere->mie_g > 0 ? chi[most + 3] : 0;
    air.kept = 1 - share / atmosphere->mie_extinction_ratio;
    for (int l = 0; l <= most; l++) air.weights[l] = chi[l] - share;
    return air;
}

OrdersGauss orders_gauss(int count) {
    OrdersGauss gauss = {.count = count};
    gauss_nodes(count, gauss.nodes, gauss.weights);
    return gauss;
}

static void transmit(const OrdersAir *air, AirColumns columns, double kept, double out[3]) {
    columns.aerosol *= kept;
    for (int c = 0; c < 3; c++) out[c] = exp(-air_extinction(&air->atmosphere, &columns, c));
}

/* a + factor (b - c) */
static AirColumns columns_add(AirColumns a, double factor, AirColumns b, AirColumns c) {
    return (AirColumns){a.air + factor * (b.air - c.air), a.aerosol + factor * (b.aerosol - c.aerosol),
                        a.ozone + factor * (b.ozone - c.ozone)};
}

/* The columns above the point at distance t, along the ray or against it, whichever rises. */
static AirColumns columns_above(const OrdersAir *air, const AirPath *path, double t, double height) {
    return air_column_to_top(&air->atmosphere, height, fabs(path->rise + t));
}

static void add_node(const OrdersAir *air, OrdersRay *ray, double t, double length, double height,
                     const AirColumns *view) {
    const Atmosphere *a = &air->atmosphere;
    OrdersNode *node = &ray->nodes[ray->count++];
    double kept[3], molecules = length * air_molecule_density(a, height),
                    aerosols = length * air_aerosol_density(a, height);
    *node = (OrdersNode){.t = t, .height = height, .radius = a->planet_radius_m + height};
    transmit(air, *view, air->kept, kept);
    for (int c = 0; c < 3; c++) {
        node->air[c] = kept[c] * molecules * a->rayleigh_scatter_per_m[c];
        node->aerosol[c] = kept[c] * aerosols * a->mie_scatter_per_m[c];
    }
}

/* A segment rises or falls throughout. `before` are the columns from the origin to its begin, then to its
 * end. */
static void add_segment(const OrdersAir *air, OrdersRay *ray, double from, double to,
                        const OrdersGauss *gauss, AirColumns *before) {
    const AirPath *path = &ray->path;
    double length = to - from;
    bool descends = path->rise + (from + to) / 2 < 0;
    double sign = descends ? 1 : -1;
    AirColumns begin =
        columns_above(air, path, from, air_altitude_along(path->height, path->radius, path->rise, from));
    AirColumns end =
        columns_above(air, path, to, air_altitude_along(path->height, path->radius, path->rise, to));
    for (int i = 0; i < gauss->count; i++) {
        double u = gauss->nodes[i], s = 1 / (1 + crowding - u), x = length * crowding * u * s;
        double t = descends ? to - x : from + x, stretch = length * crowding * (1 + crowding) * s * s;
        double height = air_altitude_along(path->height, path->radius, path->rise, t);
        AirColumns view = columns_add(*before, sign, columns_above(air, path, t, height), begin);
        add_node(air, ray, t, gauss->weights[i] * stretch, height, &view);
    }
    *before = columns_add(*before, sign, end, begin);
}

void orders_ray(const OrdersAir *air, double height, double cosine, const OrdersGauss *gauss,
                const double *cuts, int cut_count, OrdersRay *ray) {
    AirColumns before = {0};
    ray->count = 0;
    memset(ray->ground, 0, sizeof ray->ground);
    /* The length is 0 for a ray that misses the air, and for an observer on the ground who looks at it. */
    if (!air_path_clip(&air->atmosphere, height, cosine, &ray->path, &ray->start)) ray->path.length = 0;
    for (double from = 0; from < ray->path.length && ray->count + gauss->count <= ORDERS_MOST_RAY_NODES;) {
        double to = ray->path.length;
        if (-ray->path.rise > from && -ray->path.rise < to) to = -ray->path.rise;
        for (int i = 0; i < cut_count; i++) {
            double cut = cuts[i] - ray->start;
            if (cut > from && cut < to) to = cut;
        }
        add_segment(air, ray, from, to, gauss, &before);
        from = to;
    }
    if (ray->path.ground) transmit(air, before, air->kept, ray->ground);
}

void orders_air_sunlight(const OrdersAir *air, double sine, double irradiance[3]) {
    double up = fmax(sine, 0);
    transmit(air, air_column_to_top(&air->atmosphere, 0, air->atmosphere.planet_radius_m * up), 1,
             irradiance);
    for (int c = 0; c < 3; c++) irradiance[c] *= up;
}

/* Where the ray crosses the edge of the shadow of a planet whose surface is at an altitude: half of a
 * cylinder, whose other half is on the sun's side of the planet's centre. Returns the number of places. */
static int cross_shadow(const Atmosphere *a, double altitude, double height, double rise, double sun_rise,
                        double nu, double places[2]) {
    double square = 1 - nu * nu, half = rise - sun_rise * nu;
    double rest = air_square_above(a, height, altitude) - sun_rise * sun_rise;
    double root = half * half - square * rest;
    if (square < 1e-14 || root <= 0) return 0;
    double sum = -half - copysign(sqrt(root), half);
    double middle = nu != 0 ? -sun_rise / nu : INFINITY;
    places[0] = sum / square;
    places[1] = sum != 0 ? rest / sum : 0;
    for (int i = 0; i < 2; i++) places[i] = nu >= 0 ? fmin(places[i], middle) : fmax(places[i], middle);
    return 2;
}

static double rayleigh_phase(double nu) {
    return 3 / (16 * pi) * (1 + nu * nu);
}

/* The phase function of Cornette and Shanks. */
static double mie_phase(double g, double nu) {
    double base = 1 + g * g - 2 * g * nu;
    return 3 / (8 * pi) * (1 - g * g) * (1 + nu * nu) / ((2 + g * g) * base * sqrt(base));
}

void orders_air_first(const OrdersAir *air, double height, double mu, double mu_sun, double nu,
                      const OrdersGauss *gauss, double radiance[3]) {
    const Atmosphere *a = &air->atmosphere;
    double radius = a->planet_radius_m + height, rise = radius * mu, sun_rise = radius * mu_sun, cuts[4];
    double by_air = rayleigh_phase(nu), by_aerosol = mie_phase(a->mie_g, nu);
    OrdersRay ray;
    int count = cross_shadow(a, 0, height, rise, sun_rise, nu, cuts);
    count += cross_shadow(a, dusk * a->rayleigh_scale_height_m, height, rise, sun_rise, nu, cuts + count);
    orders_ray(air, height, mu, gauss, cuts, count, &ray);
    sun_rise += nu * ray.start;
    memset(radiance, 0, 3 * sizeof *radiance);
    for (int i = 0; i < ray.count; i++) {
        const OrdersNode *node = &ray.nodes[i];
        double s = sun_rise + nu * node->t, light[3];
        if (s < 0 && air_square_above(a, node->height, 0) < s * s) continue;
        transmit(air, air_column_to_top(a, node->height, s), 1, light);
        for (int c = 0; c < 3; c++)
            radiance[c] += light[c] * (by_air * node->air[c] + by_aerosol * node->aerosol[c]);
    }
    if (!ray.path.ground) return;
    double light[3];
    orders_air_sunlight(air, (sun_rise + nu * ray.path.length) / a->planet_radius_m, light);
    for (int c = 0; c < 3; c++) radiance[c] += ray.ground[c] * a->ground_albedo[c] / pi * light[c];
}
