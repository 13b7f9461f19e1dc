#include "sky/sky_reference.h"

#include "base/vec3.h"
#include "sky/air_path.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { KRONROD_PAIRS = 7, MAX_BREAKS = 64, MAX_PANELS = 400 };

/* The quadrature stops when its estimated error is below this share of the radiance; the true error is far
 * smaller. The floor (for a sun of irradiance 1) lets the loop end where the sky is black. */
static const double tolerance = 1e-10, tolerance_floor = 1e-26;

/* Gauss-Kronrod quadrature with 15 nodes, of which 7 are Gauss nodes: the positive half. The odd indices and
 * the middle are the Gauss nodes. */
static const double kronrod_node[KRONROD_PAIRS] = {
    0.991455371120812639, 0.949107912342758525, 0.864864423359769073, 0.74153118559939444,
    0.58608723546769113,  0.405845151377397167, 0.207784955007898468};
static const double kronrod_weight[KRONROD_PAIRS + 1] = {
    0.022935322010529225, 0.0630920926299785533, 0.10479001032225018, 0.140653259715525919,
    0.16900472663926790,  0.190350578064785410,  0.20443294007529889, 0.209482141084727828};
static const double kronrod_gauss_weight[KRONROD_PAIRS + 1] = {
    0, 0.129484966168869693, 0, 0.279705391489276668, 0, 0.381830050505118945, 0, 0.417959183673469388};

/* One direction of the sky. The sun's ray through the path's point at distance t has its perigee at the
 * distance sqrt(across_squared t^2 + 2 across_rise t + radius^2 - sun_rise^2) from the centre. "Across" is
 * the part of the view direction that is orthogonal to the sun's direction. */
typedef struct Sky {
    const Atmosphere *atmosphere;
    AirPath path;
    /* The cosine of the angle between view and sun. */
    double nu;
    /* The rise of the sun's ray through the path's origin. */
    double sun_rise;
    double across_squared, across_rise;
    double air_phase, aerosol_phase;
} Sky;

typedef struct Panel {
    double from, to, value[3], error[3];
} Panel;

typedef struct Breaks {
    double at[MAX_BREAKS], length;
    int count;
} Breaks;

/* The phase function of Cornette and Shanks. The identity 1 + g^2 - 2 g nu = (1 - |g|)^2 + |g| |v -+ s|^2 is
 * used because its right side keeps its digits in the peak. */
static double aerosol_phase(double g, const double view[3], const double sun[3]) {
    double sign = g < 0 ? -1 : 1, size = fabs(g), apart[3];
    for (int i = 0; i < 3; i++) apart[i] = view[i] - sign * sun[i];
    double base = (1 - size) * (1 - size) + size * vec3_dot(apart, apart), nu = vec3_dot(view, sun);
    return 3 / (8 * pi) * (1 - size) * (1 + size) * (1 + nu * nu) / ((2 + g * g) * base * sqrt(base));
}

static void scattered_at(const Sky *sky, double t, double out[3]) {
    const Atmosphere *atmosphere = sky->atmosphere;
    const AirPath *path = &sky->path;
    double height = air_altitude_along(path->height, path->radius, path->rise, t);
    AirColumns view = air_columns(atmosphere, path->height, path->rise, t);
    double sun_rise = sky->sun_rise + sky->nu * t;
    double to_top =
        air_distance_out(sun_rise, air_square_above(atmosphere, air_top_height(atmosphere), height));
    AirColumns sun = air_columns(atmosphere, height, sun_rise, to_top);
    double air = sky->air_phase * air_molecule_density(atmosphere, height);
    double aerosol = sky->aerosol_phase * air_aerosol_density(atmosphere, height);
    for (int c = 0; c < 3; c++) {
        out[c] = (atmosphere->rayleigh_scatter_per_m[c] * air + atmosphere->mie_scatter_per_m[c] * aerosol) *
                 exp(-air_extinction(atmosphere, &view, c) - air_extinction(atmosphere, &sun, c));
    }
}

/* The error is estimated as in QUADPACK: the plain difference of both rules is the error of the worse one. */
static void panel_integrate(const Sky *sky, Panel *panel) {
    double half = (panel->to - panel->from) / 2, middle = panel->from + half, f[2 * KRONROD_PAIRS + 1][3];
    for (int k = 0; k < KRONROD_PAIRS; k++) {
        scattered_at(sky, middle - half * kronrod_node[k], f[2 * k]);
        scattered_at(sky, middle + half * kronrod_node[k], f[2 * k + 1]);
    }
    scattered_at(sky, middle, f[2 * KRONROD_PAIRS]);
    for (int c = 0; c < 3; c++) {
        double fine = 0, coarse = 0, spread = 0;
        for (int i = 0; i <= 2 * KRONROD_PAIRS; i++) {
            fine += kronrod_weight[i / 2] * f[i][c];
            coarse += kronrod_gauss_weight[i / 2] * f[i][c];
        }
        for (int i = 0; i <= 2 * KRONROD_PAIRS; i++) {
            spread += kronrod_weight[i / 2] * fabs(f[i][c] - fine / 2);
        }
        double error = spread > 0 ? spread * fmin(1, pow(200 * fabs(fine - coarse) / spread, 1.5)) : 0;
        panel->value[c] = half * fine;
        /* Such a panel is too narrow to be cut again. */
        panel->error[c] = half < 1e-14 * panel->to ? 0 : half * error;
    }
}

/* Keeps the breaks in rising order. find_breaks() adds at most 47. */
static void add_break(Breaks *breaks, double t) {
    if (!(t > 0 && t < breaks->length) || breaks->count == MAX_BREAKS) return;
    int i = breaks->count++;
    for (; i > 0 && breaks->at[i - 1] > t; i--) breaks->at[i] = breaks->at[i - 1];
    breaks->at[i] = t;
}

/* Adds the roots of a t^2 + 2 b t + c. */
static void add_roots(Breaks *breaks, double a, double b, double c) {
    double square = b * b - a * c;
    if (square < 0) return;
    double sum = -b - copysign(sqrt(square), b);
    if (a != 0) add_break(breaks, sum / a);
    if (sum != 0) add_break(breaks, c / sum);
}

/* Adds the places where the path crosses an altitude. With `sun_perigee` it also adds those where the sun's
 * rays have their perigee at this altitude; for altitude 0 these are the edges of the planet's shadow. */
static void add_altitude(Breaks *breaks, const Sky *sky, double altitude, bool sun_perigee) {
    double square = air_square_above(sky->atmosphere, sky->path.height, altitude);
    add_roots(breaks, 1, sky->path.rise, square);
    if (!sun_perigee) return;
    add_roots(breaks, sky->across_squared, sky->across_rise, square - sky->sun_rise * sky->sun_rise);
}

/* Finds where the integrand is not smooth: at the perigee, the shadow's edges and the kinks of the ozone's
 * profile. It also adds places where the integrand may be steep, so that no panel's nodes miss a thin
 * layer of light altogether: altitudes that double from the lowest point up, and mean free paths from the
 * origin. */
static void find_breaks(const Sky *sky, Breaks *breaks) {
    const Atmosphere *atmosphere = sky->atmosphere;
    const AirPath *path = &sky->path;
    double low = fmin(path->height, air_altitude_along(path->height, path->radius, path->rise, path->length));
    *breaks = (Breaks){.length = path->length};
    if (-path->rise > 0 && -path->rise < path->length) {
        low = air_perigee_altitude(atmosphere, path->height, path->rise);
        add_break(breaks, -path->rise);
    }
    add_altitude(breaks, sky, 0, true);
    for (int i = -1; atmosphere->ozone > 0 && i <= 1; i++) {
        add_altitude(breaks, sky, atmosphere->ozone_height_m + i * atmosphere->ozone_half_width_m, true);
    }
    for (double gain = 1; gain <= 32; gain *= 2) {
        add_altitude(breaks, sky, low + gain * atmosphere->rayleigh_scale_height_m, false);
        add_altitude(breaks, sky, low + gain * atmosphere->mie_scale_height_m, false);
    }
    AirColumns per_m = {air_molecule_density(atmosphere, path->height),
                        air_aerosol_density(atmosphere, path->height),
                        air_ozone_density(atmosphere, path->height)};
    double most = 0;
    for (int c = 0; c < 3; c++) most = fmax(most, air_extinction(atmosphere, &per_m, c));
    for (double depth = 0.25; most > 0 && depth <= 64; depth *= 4) add_break(breaks, depth / most);
}

/* The shadow's edges are breaks, so a panel is in the shadow if its middle is. */
static bool is_lit(const Sky *sky, double t) {
    double square = air_square_above(sky->atmosphere, sky->path.height, 0) - sky->sun_rise * sky->sun_rise +
                    t * (sky->across_squared * t + 2 * sky->across_rise);
    return sky->sun_rise + sky->nu * t >= 0 || square >= 0;
}

static int start_panels(const Sky *sky, Panel panels[MAX_PANELS]) {
    Breaks breaks;
    double from = 0;
    int count = 0;
    find_breaks(sky, &breaks);
    for (int i = 0; i <= breaks.count; i++) {
        double to = i < breaks.count ? breaks.at[i] : breaks.length;
        if (to > from && is_lit(sky, from + (to - from) / 2)) {
            panels[count] = (Panel){.from = from, .to = to};
            panel_integrate(sky, &panels[count++]);
        }
        from = to;
    }
    return count;
}

/* Cuts the panel with the largest error in two until all channels have converged or MAX_PANELS is reached. */
static void integrate(const Sky *sky, double total[3]) {
    Panel panels[MAX_PANELS];
    int count = start_panels(sky, panels);
    for (;;) {
        double worst = 0;
        int at = 0;
        bool good = true;
        for (int c = 0; c < 3; c++) {
            double error = 0;
            total[c] = 0;
            for (int i = 0; i < count; i++) total[c] += panels[i].value[c], error += panels[i].error[c];
            double allowed = tolerance * total[c] + tolerance_floor;
            good = good && error <= allowed;
            for (int i = 0; i < count; i++) {
                if (panels[i].error[c] > worst * allowed) worst = panels[i].error[c] / allowed, at = i;
            }
        }
        if (good || count == MAX_PANELS) return;
        double middle = panels[at].from + (panels[at].to - panels[at].from) / 2;
        panels[count] = (Panel){.from = middle, .to = panels[at].to};
        panels[at].to = middle;
        panel_integrate(sky, &panels[at]);
        panel_integrate(sky, &panels[count++]);
    }
}

void sky_reference(const Atmosphere *atmosphere, double height_m, const double view[3], const double sun[3],
                   double radiance[3]) {
    double v[3], s[3], normal[3], across[3], start;
    Sky sky = {.atmosphere = atmosphere};
    vec3_normalize(view, v);
    vec3_normalize(sun, s);
    memset(radiance, 0, 3 * sizeof *radiance);
    if (!air_path_clip(atmosphere, height_m, v[1], &sky.path, &start)) return;
    vec3_cross(v, s, normal);
    vec3_cross(s, normal, across);
    double radius = atmosphere->planet_radius_m + height_m;
    sky.nu = vec3_dot(v, s);
    sky.sun_rise = radius * s[1] + sky.nu * start;
    sky.across_squared = vec3_dot(across, across);
    sky.across_rise = radius * across[1] + sky.across_squared * start;
    sky.air_phase = 3 / (16 * pi) * (1 + sky.nu * sky.nu);
    sky.aerosol_phase = aerosol_phase(atmosphere->mie_g, v, s);
    integrate(&sky, radiance);
    for (int c = 0; c < 3; c++) radiance[c] *= atmosphere->sun_irradiance[c];
}

void sky_reference_ground(const Atmosphere *atmosphere, double height_m, const double view[3],
                          const double sun[3], double radiance[3]) {
    double v[3], s[3], start, planet = atmosphere->planet_radius_m;
    AirPath path;
    vec3_normalize(view, v);
    vec3_normalize(sun, s);
    memset(radiance, 0, 3 * sizeof *radiance);
    /* On the ground the path has no length, but it ends there. */
    (void)air_path_clip(atmosphere, height_m, v[1], &path, &start);
    double rise = (planet + height_m) * s[1] + vec3_dot(v, s) * (start + path.length);
    if (!path.ground || rise <= 0) return;
    double to_top = air_distance_out(rise, air_square_above(atmosphere, air_top_height(atmosphere), 0));
    AirColumns down = air_columns(atmosphere, path.height, path.rise, path.length);
    AirColumns up = air_columns(atmosphere, 0, rise, to_top);
    for (int c = 0; c < 3; c++) {
        double kept = exp(-air_extinction(atmosphere, &down, c) - air_extinction(atmosphere, &up, c));
        radiance[c] =
            atmosphere->ground_albedo[c] / pi * rise / planet * kept * atmosphere->sun_irradiance[c];
    }
}

void sky_reference_transmittance(const Atmosphere *atmosphere, double height_m, const double direction[3],
                                 double transmittance[3]) {
    double unit[3], start;
    AirPath path;
    AirColumns columns = {0};
    vec3_normalize(direction, unit);
    if (air_path_clip(atmosphere, height_m, unit[1], &path, &start)) {
        columns = air_columns(atmosphere, path.height, path.rise, path.length);
    }
    for (int c = 0; c < 3; c++)
        transmittance[c] = path.ground ? 0 : exp(-air_extinction(atmosphere, &columns, c));
}
