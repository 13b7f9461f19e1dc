#include "skies.h"

#include "support.h"

#include "base/vec3.h"
#include "sky/gauss_table.h"
#include "sky/sky_reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double albedos[] = {0, 0.3, 0.8};

static int air_number(double albedo, double ozone) {
    int number = ozone > 0 ? 3 : 0;
    while (albedos[number % 3] < albedo) number++;
    return number;
}

/* Reads the numbers of the next row, `count` of them; false at the end. */
static bool next_row(FILE *file, int count, double *row) {
    char line[512];
    while (fgets(line, sizeof line, file)) {
        int at = 0, i = 0, size = 0;
        for (; i < count && sscanf(line + at, "%lf%n", &row[i], &size) == 1; i++) at += size + 1;
        if (i == count) return true;
    }
    return false;
}

static FILE *open_rows(const char *path) {
    FILE *file = fopen(path, "r");
    if (!file) fail_msg("%s cannot be read", path);
    return file;
}

int skies_radiances(SkiesRow rows[SKIES_MOST_ROWS]) {
    FILE *file = open_rows("tests/data/sky_multiple.csv");
    double v[12];
    int count = 0;
    for (; count < SKIES_MOST_ROWS && next_row(file, 12, v); count++) {
        rows[count] = (SkiesRow){.height_m = v[0],
                                 .sun_deg = v[1],
                                 .view_deg = v[2],
                                 .azimuth_deg = v[3],
                                 .air = air_number(v[4], v[5])};
        memcpy(rows[count].total, v + 6, sizeof rows[count].total);
        memcpy(rows[count].single, v + 9, sizeof rows[count].single);
    }
    fclose(file);
    assert_int_equal(count, 320);
    return count;
}

int skies_irradiances(SkiesRow rows[SKIES_MOST_ROWS]) {
    FILE *file = open_rows("tests/data/irradiance_multiple.csv");
    double v[10];
    int count = 0;
    for (; count < SKIES_MOST_ROWS && next_row(file, 10, v); count++) {
        rows[count] = (SkiesRow){.sun_deg = v[0], .height_m = v[1], .air = air_number(v[2], v[3])};
        memcpy(rows[count].total, v + 4, sizeof rows[count].total);
        memcpy(rows[count].single, v + 7, sizeof rows[count].single);
    }
    fclose(file);
    assert_int_equal(count, 60);
    return count;
}

Atmosphere skies_air(int number) {
    Atmosphere air;
    Error error;
    assert_true(atmosphere_choose(&air, number < 3 ? "simmons2017" : "simmons2017-ozone", &error));
    air.orders = INFINITY;
    for (int c = 0; c < 3; c++) air.ground_albedo[c] = albedos[number % 3];
    return air;
}

void skies_direction(double elevation_deg, double azimuth_deg, double out[3]) {
    double level = fabs(elevation_deg) == 90 ? 0 : cos(elevation_deg * degree);
    out[0] = level * sin(azimuth_deg * degree);
    out[1] = sin(elevation_deg * degree);
    out[2] = level * cos(azimuth_deg * degree);
}

void skies_errors_add(SkiesErrors *errors, double sun_deg, const double got[3], const double expected[3]) {
    SkiesClass of = sun_deg >= 5    ? SKIES_DAY
                    : sun_deg >= 0  ? SKIES_LOW
                    : sun_deg >= -6 ? SKIES_TWILIGHT
                                    : SKIES_DEEP;
    for (int c = 0; c < 3; c++)
        errors->errors[of][errors->counts[of]++] = 100 * fabs(got[c] / expected[c] - 1);
}

static int by_size(const void *left, const void *right) {
    double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

void skies_errors_expect(SkiesErrors *errors, const char *name, const SkiesBounds bounds[SKIES_CLASSES]) {
    static const char *const names[] = {"day", "low", "twilight", "deep"};
    bool good = true;
    for (int k = 0; k < SKIES_CLASSES; k++) {
        double *list = errors->errors[k], squares = 0;
        int count = errors->counts[k];
        for (int i = 0; i < count; i++) squares += list[i] * list[i];
        qsort(list, (size_t)count, sizeof *list, by_size);
        if (count == 0) continue;
        double rms = sqrt(squares / count), p99 = list[count * 99 / 100];
        print_message("%s, %s, %d values: RMS %.3f %%, 99th percentile %.3f %%, largest %.3f %%\n", name,
                      names[k], count, rms, p99, list[count - 1]);
        good = good && rms < bounds[k].rms && p99 < bounds[k].p99;
    }
    if (!good) fail_msg("%s: the errors are past the bounds", name);
}

/* Both angles go with a square: nodes crowd at the horizon and at the sun's azimuth. */
void skies_dome(SkiesDome *dome) {
    double u[24], wu[24], v[16], wv[16];
    gauss_nodes(24, u, wu);
    gauss_nodes(16, v, wv);
    for (int i = 0; i < SKIES_DOME; i++) {
        int along = i / 16, across = i % 16;
        double elevation = 90 * u[along] * u[along], azimuth = 180 * v[across] * v[across];
        double solid = wu[along] * 180 * degree * u[along] * cos(elevation * degree) * wv[across] * 720 *
                       degree * v[across];
        skies_direction(elevation, azimuth, dome->directions[i]);
        dome->weights[i] = solid * sin(elevation * degree);
    }
}

enum { BELOW = 12, LIMB = BELOW, AROUND = 10, VIEWS = (BELOW + LIMB) * AROUND };

/* The sines of the views' elevations are even in each of two parts: those that meet the ground, and those of
 * the limb. */
static void set_views(const Atmosphere *atmosphere, double (*views)[3], double *weights) {
    double u[BELOW], w[BELOW], ratio = atmosphere->planet_radius_m / atmosphere->top_radius_m;
    double horizon = -sqrt((1 - ratio) * (1 + ratio));
    gauss_nodes(BELOW, u, w);
    for (int i = 0; i < VIEWS; i++) {
        int along = i / AROUND, node = along % BELOW;
        bool ground = along < BELOW;
        double sine = ground ? -1 + u[node] * (horizon + 1) : horizon * (1 - u[node]);
        double width = ground ? horizon + 1 : -horizon;
        skies_direction(asin(sine) / degree, 180 * (i % AROUND + 0.5) / AROUND, views[i]);
        weights[i] = width * w[node] * -sine * 2 * pi / AROUND;
    }
}

/* The share of the sunlight in the disk of the top that passes the planet without being scattered. */
static void passing_share(const Atmosphere *atmosphere, double shares[3]) {
    double u[40], w[40], top = atmosphere->top_radius_m, planet = atmosphere->planet_radius_m;
    gauss_nodes(40, u, w);
    memset(shares, 0, 3 * sizeof *shares);
    for (int i = 0; i < 40; i++) {
        double b = planet + u[i] * (top - planet), kept[3];
        double direction[3] = {0, -sqrt((1 - b / top) * (1 + b / top)), b / top};
        sky_reference_transmittance(atmosphere, top - planet, direction, kept);
        for (int c = 0; c < 3; c++) shares[c] += w[i] * (top - planet) * 2 * b / (top * top) * kept[c];
    }
}

/* Through the disk pi R^2 of the top enters the sun's irradiance. Through each part of the sphere leaves the
 * flux of what is seen from there downward; it depends on the sun's elevation there, whose sine is even over
 * the sphere: 2 pi R^2 times the integral over the sine. */
void skies_balance(const Atmosphere *atmosphere, SkiesAsk *ask, void *state, double shares[3]) {
    /* The sines in three parts. Nearly all of twilight's light is in the middle one. */
    static const double parts[4] = {-0.34, -0.1, 0.1, 1};
    static const int counts[3] = {8, 20, 12};
    static double views[VIEWS][3], weights[VIEWS], radiances[VIEWS][3];
    double u[20], w[20];
    set_views(atmosphere, views, weights);
    passing_share(atmosphere, shares);
    for (int part = 0; part < 3; part++) {
        gauss_nodes(counts[part], u, w);
        for (int i = 0; i < counts[part]; i++) {
            double width = parts[part + 1] - parts[part], sine = parts[part] + u[i] * width;
            ask(state, asin(sine) / degree, views, VIEWS, radiances);
            for (int k = 0; k < VIEWS; k++) {
                for (int c = 0; c < 3; c++)
                    shares[c] +=
                        2 * width * w[i] * weights[k] * radiances[k][c] / atmosphere->sun_irradiance[c];
            }
        }
    }
}
