/* A ray is held as the altitude of its origin, the origin's distance from the planet's centre ("radius") and
 * "rise", radius times the cosine of the zenith angle: the origin's position along the ray, counted from the
 * ray's perigee. All altitudes follow from differences of squares written as products, never as |p| - R,
 * which would lose seven digits; so double is enough, and noise stays near 1e-9 m. */
#include "sky/sky_reference.h"

#include "base/vec3.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { GAUSS_PAIRS = 8, KRONROD_PAIRS = 7, MAX_BREAKS = 64, MAX_PANELS = 400 };

/* The quadrature stops at this share of the radiance, as estimated; the true error is far below. The floor
 * (for a sun of irradiance 1) lets a black sky end. */
static const double tolerance = 1e-10, tolerance_floor = 1e-26;

/* Gauss-Legendre, 16 nodes: the positive half. */
static const double gauss_node[GAUSS_PAIRS] = {
    0.0950125098376374402, 0.281603550779258913, 0.458016777657227386, 0.617876244402643748,
    0.755404408355003034,  0.865631202387831744, 0.944575023073232576, 0.989400934991649933};
static const double gauss_weight[GAUSS_PAIRS] = {
    0.189450610455068496, 0.182603415044923589,  0.169156519395002538,  0.149595988816576732,
    0.124628971255533872, 0.0951585116824927848, 0.0622535239386478929, 0.0271524594117540949};

/* Gauss-Kronrod, 7 nodes within 15: the positive half; odd indices and the middle are Gauss nodes too. */
static const double kronrod_node[KRONROD_PAIRS] = {
    0.991455371120812639, 0.949107912342758525, 0.864864423359769073, 0.74153118559939444,
    0.58608723546769113,  0.405845151377397167, 0.207784955007898468};
static const double kronrod_weight[KRONROD_PAIRS + 1] = {
    0.022935322010529225, 0.0630920926299785533, 0.10479001032225018, 0.140653259715525919,
    0.16900472663926790,  0.190350578064785410,  0.20443294007529889, 0.209482141084727828};
static const double kronrod_gauss_weight[KRONROD_PAIRS + 1] = {
    0, 0.129484966168869693, 0, 0.279705391489276668, 0, 0.381830050505118945, 0, 0.417959183673469388};

typedef struct Path {
    double height, radius, rise, length; /* the first three are the origin's */
    bool ground;                         /* ends there */
} Path;

/* Density times length, in metres at density 1. */
typedef struct Columns {
    double air, aerosol, ozone;
} Columns;

typedef double Density(const Atmosphere *atmosphere, double height);

/* One direction of the sky. The sun's ray through the path's point at distance t has the perigee distance
 * sqrt(across_squared t^2 + 2 across_rise t + radius^2 - sun_rise^2) from the centre; across is the part of
 * the view direction that is orthogonal to the sun's. */
typedef struct Sky {
    const Atmosphere *atmosphere;
    Path path;
    double nu;       /* cosine between view and sun */
    double sun_rise; /* of the sun's ray from the path's origin */
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

static double air_density(const Atmosphere *atmosphere, double height) {
    return atmosphere->rayleigh * exp(-height / atmosphere->rayleigh_scale_height_m);
}

static double aerosol_density(const Atmosphere *atmosphere, double height) {
    return atmosphere->mie * exp(-height / atmosphere->mie_scale_height_m);
}

static double ozone_density(const Atmosphere *atmosphere, double height) {
    double off = fabs(height - atmosphere->ozone_height_m) / atmosphere->ozone_half_width_m;
    return atmosphere->ozone * fmax(0, 1 - off);
}

static double extinction(const Atmosphere *atmosphere, const Columns *columns, int c) {
    return atmosphere->rayleigh_scatter_per_m[c] * columns->air +
           atmosphere->mie_extinction_ratio * atmosphere->mie_scatter_per_m[c] * columns->aerosol +
           atmosphere->ozone_absorb_per_m[c] * columns->ozone;
}

static double top_height(const Atmosphere *atmosphere) {
    return atmosphere->top_radius_m - atmosphere->planet_radius_m;
}

/* Squared distance from the centre, less that of an altitude. */
static double square_above(const Atmosphere *atmosphere, double height, double altitude) {
    return (height - altitude) * (2 * atmosphere->planet_radius_m + height + altitude);
}

static double altitude_along(double height, double radius, double rise, double t) {
    double gained = t * (2 * rise + t);
    return height + gained / (sqrt(fmax(0, radius * radius + gained)) + radius);
}

static double perigee_altitude(const Atmosphere *atmosphere, double height, double rise) {
    double radius = atmosphere->planet_radius_m;
    double above = square_above(atmosphere, height, 0) - rise * rise;
    return above / (radius + sqrt(fmax(0, radius * radius + above)));
}

/* Distance to the far crossing of the sphere that lies `square` outside the origin's (as square_above). */
static double distance_out(double rise, double square) {
    double root = sqrt(fmax(0, rise * rise + square));
    if (rise <= 0) return root - rise;
    return fmax(0, square) / (rise + root);
}

/* From a leg's low end upward, where density falls. Beside the exponential itself an altitude has
 * singularities at the complex distances -radius exp(+-i angle), so panels longer than a radius are cut by
 * doubling. */
static double leg_integral(const Atmosphere *atmosphere, const Path *leg, double from, double to,
                           Density *density) {
    double sum = 0;
    while (from < to) {
        double end = fmin(to, from + fmax(from, leg->radius)), half = (end - from) / 2, part = 0;
        for (int i = 0; i < 2 * GAUSS_PAIRS; i++) {
            double t = from + half * (1 + (i % 2 ? 1 : -1) * gauss_node[i / 2]);
            double height = altitude_along(leg->height, leg->radius, leg->rise, t);
            part += gauss_weight[i / 2] * density(atmosphere, height);
        }
        sum += half * part;
        from = end;
    }
    return sum;
}

/* Cut at three altitudes, in rising order; nothing is counted above the third. */
static double leg_column(const Atmosphere *atmosphere, const Path *leg, const double altitudes[3],
                         Density *density) {
    double sum = 0, from = 0;
    for (int i = 0; i < 3; i++) {
        double gain = fmax(0, altitudes[i] - leg->height);
        double to = fmin(leg->length, distance_out(leg->rise, gain * (2 * leg->radius + gain)));
        sum += leg_integral(atmosphere, leg, from, to, density);
        from = to;
    }
    return sum;
}

/* 16 nodes over 16 scale heights are good to 1e-13 of the column, both for a steep leg (an exponential) and
 * for one from its perigee (a Gaussian); past 48 there is no more than exp(-48) of it. */
static double exponential_column(const Atmosphere *atmosphere, const Path *leg, double scale,
                                 Density *density) {
    double low = leg->height, altitudes[3] = {low + 16 * scale, low + 32 * scale, low + 48 * scale};
    return leg_column(atmosphere, leg, altitudes, density);
}

static void add_leg(const Atmosphere *atmosphere, const Path *leg, Columns *columns) {
    double middle = atmosphere->ozone_height_m, half = atmosphere->ozone_half_width_m;
    double tent[3] = {middle - half, middle, middle + half};
    double air = atmosphere->rayleigh_scale_height_m, aerosol = atmosphere->mie_scale_height_m;
    if (atmosphere->rayleigh > 0) columns->air += exponential_column(atmosphere, leg, air, air_density);
    if (atmosphere->mie > 0)
        columns->aerosol += exponential_column(atmosphere, leg, aerosol, aerosol_density);
    if (atmosphere->ozone > 0) columns->ozone += leg_column(atmosphere, leg, tent, ozone_density);
}

/* Columns along a straight way within the atmosphere, cut at its perigee into legs that rise. */
static Columns columns_along(const Atmosphere *atmosphere, double height, double rise, double length) {
    Columns columns = {0};
    bool has_perigee = rise < 0 && -rise < length;
    Path leg = {.height = height, .rise = rise, .length = length};
    if (has_perigee) {
        leg = (Path){.height = perigee_altitude(atmosphere, height, rise), .length = -rise};
    } else if (rise < 0) {
        leg.height = altitude_along(height, atmosphere->planet_radius_m + height, rise, length);
        leg.rise = -rise - length;
    }
    leg.radius = atmosphere->planet_radius_m + leg.height;
    add_leg(atmosphere, &leg, &columns);
    if (has_perigee) {
        leg.length = length + rise;
        add_leg(atmosphere, &leg, &columns);
    }
    return columns;
}

/* The part of a ray within the atmosphere, from `*start` on; false if there is none. */
static bool path_clip(const Atmosphere *atmosphere, double height, double cosine, Path *path, double *start) {
    double top = top_height(atmosphere), radius = atmosphere->planet_radius_m + height;
    *path = (Path){height, radius, radius * cosine, 0, false};
    *start = 0;
    if (height > top) {
        double square = square_above(atmosphere, height, top), chord = path->rise * path->rise - square;
        if (path->rise >= 0 || chord <= 0) return false;
        *start = square / (sqrt(chord) - path->rise);
        *path = (Path){top, atmosphere->top_radius_m, -sqrt(chord), 0, false};
    }
    double square = square_above(atmosphere, path->height, 0), chord = path->rise * path->rise - square;
    path->ground = path->rise < 0 && chord > 0;
    path->length = path->ground ? square / (sqrt(chord) - path->rise)
                                : distance_out(path->rise, square_above(atmosphere, top, path->height));
    return path->length > 0;
}

/* Cornette-Shanks. 1 + g^2 - 2 g nu = (1 - |g|)^2 + |g| |v -+ s|^2, whose right side keeps its digits in
 * the peak. */
static double aerosol_phase(double g, const double view[3], const double sun[3]) {
    double sign = g < 0 ? -1 : 1, size = fabs(g), apart[3];
    for (int i = 0; i < 3; i++) apart[i] = view[i] - sign * sun[i];
    double base = (1 - size) * (1 - size) + size * vec3_dot(apart, apart), nu = vec3_dot(view, sun);
    return 3 / (8 * pi) * (1 - size) * (1 + size) * (1 + nu * nu) / ((2 + g * g) * base * sqrt(base));
}

static void scattered_at(const Sky *sky, double t, double out[3]) {
    const Atmosphere *atmosphere = sky->atmosphere;
    const Path *path = &sky->path;
    double height = altitude_along(path->height, path->radius, path->rise, t);
    Columns view = columns_along(atmosphere, path->height, path->rise, t);
    double sun_rise = sky->sun_rise + sky->nu * t;
    double to_top = distance_out(sun_rise, square_above(atmosphere, top_height(atmosphere), height));
    Columns sun = columns_along(atmosphere, height, sun_rise, to_top);
    double air = sky->air_phase * air_density(atmosphere, height);
    double aerosol = sky->aerosol_phase * aerosol_density(atmosphere, height);
    for (int c = 0; c < 3; c++) {
        out[c] = (atmosphere->rayleigh_scatter_per_m[c] * air + atmosphere->mie_scatter_per_m[c] * aerosol) *
                 exp(-extinction(atmosphere, &view, c) - extinction(atmosphere, &sun, c));
    }
}

/* The error's estimate is QUADPACK's: the plain difference of both rules is the error of the worse one. */
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
        panel->error[c] = half < 1e-14 * panel->to ? 0 : half * error; /* too narrow to cut again */
    }
}

/* In rising order. 47 is the most that find_breaks can add. */
static void add_break(Breaks *breaks, double t) {
    if (!(t > 0 && t < breaks->length) || breaks->count == MAX_BREAKS) return;
    int i = breaks->count++;
    for (; i > 0 && breaks->at[i - 1] > t; i--) breaks->at[i] = breaks->at[i - 1];
    breaks->at[i] = t;
}

/* The roots of a t^2 + 2 b t + c. */
static void add_roots(Breaks *breaks, double a, double b, double c) {
    double square = b * b - a * c;
    if (square < 0) return;
    double sum = -b - copysign(sqrt(square), b);
    if (a != 0) add_break(breaks, sum / a);
    if (sum != 0) add_break(breaks, c / sum);
}

/* Where the path crosses an altitude, and where its sun rays have their perigee there: for altitude 0 the
 * edges of the planet's shadow. */
static void add_altitude(Breaks *breaks, const Sky *sky, double altitude, bool sun_perigee) {
    double square = square_above(sky->atmosphere, sky->path.height, altitude);
    add_roots(breaks, 1, sky->path.rise, square);
    if (!sun_perigee) return;
    add_roots(breaks, sky->across_squared, sky->across_rise, square - sky->sun_rise * sky->sun_rise);
}

/* Where the integrand is not smooth (the perigee, the shadow's edges, the ozone's kinks), and where it may be
 * steep: by doubling altitudes above the lowest point, and by free paths from the origin, so that no panel's
 * nodes miss a thin layer of light altogether. */
static void find_breaks(const Sky *sky, Breaks *breaks) {
    const Atmosphere *atmosphere = sky->atmosphere;
    const Path *path = &sky->path;
    double low = fmin(path->height, altitude_along(path->height, path->radius, path->rise, path->length));
    *breaks = (Breaks){.length = path->length};
    if (-path->rise > 0 && -path->rise < path->length) {
        low = perigee_altitude(atmosphere, path->height, path->rise);
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
    Columns per_m = {air_density(atmosphere, path->height), aerosol_density(atmosphere, path->height),
                     ozone_density(atmosphere, path->height)};
    double most = 0;
    for (int c = 0; c < 3; c++) most = fmax(most, extinction(atmosphere, &per_m, c));
    for (double depth = 0.25; most > 0 && depth <= 64; depth *= 4) add_break(breaks, depth / most);
}

/* The shadow's edges are breaks, so a panel lies in it or out of it as its middle does. */
static bool is_lit(const Sky *sky, double t) {
    double square = square_above(sky->atmosphere, sky->path.height, 0) - sky->sun_rise * sky->sun_rise +
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

/* Cuts the worst panel in two until the sum is good in all channels; bounded by the count of panels. */
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
    if (!path_clip(atmosphere, height_m, v[1], &sky.path, &start)) return;
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

void sky_reference_transmittance(const Atmosphere *atmosphere, double height_m, const double direction[3],
                                 double transmittance[3]) {
    double unit[3], start;
    Path path;
    Columns columns = {0};
    vec3_normalize(direction, unit);
    if (path_clip(atmosphere, height_m, unit[1], &path, &start)) {
        columns = columns_along(atmosphere, path.height, path.rise, path.length);
    }
    for (int c = 0; c < 3; c++)
        transmittance[c] = path.ground ? 0 : exp(-extinction(atmosphere, &columns, c));
}
