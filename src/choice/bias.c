#include "choice/bias.h"

#include "choice/bias_factors.h"
#include "choice/bias_figures.h"

#include <math.h>
#include <string.h>

/* Where the observer is: what was measured is held by place. */
typedef enum Place { UP_TO_1_KM, UP_TO_20_KM, IN_AIR, ABOVE_AIR } Place;

/* The columns of the figures behind those of gauss. */
enum { PAPER_16X4 = 7, PAPER_64X16, TABLE_ROWS, TABLE_COLUMNS };

/* The columns of the figures of airs with further orders. Those of harmonics follow. */
enum { SINGLE_SHARE, TOTAL_ROWS, TOTAL_COLUMNS, HARMONICS_8, HARMONICS_10, HARMONICS_14 };

/* The columns of the factors behind those of gauss and paper, which are those of the figures. */
enum { FACTOR_TABLE = TABLE_ROWS, FACTOR_TOTAL_TABLE, FACTOR_HARMONICS };

/* The largest albedo of the ground that was measured. */
static const double most_albedo = 0.8;

/* The column of gauss:n, by n from 4, and the column of the next number of nodes that was measured. gauss:9
 * and gauss:11 have the larger of the two figures: where ozone counts, more nodes may be less accurate. */
static const int column_of_nodes[] = {0, 1, 2, 3, 4, 4, 5, 5, 6}, next_column[] = {0, 1, 2, 3, 4, 5, 5, 6, 6};

/* The row of the last measured sun that is as high as `sun`, and the share that the next row has. */
static int locate(double sun, double *share) {
    const double *suns = bias_suns_deg;
    int row = 0;
    while (row < BIAS_SUNS - 2 && sun < suns[row + 1]) row++;
    *share = fmin(fmax((suns[row] - sun) / (suns[row] - suns[row + 1]), 0), 1);
    return row;
}

static double air_thickness_m(const Atmosphere *a) {
    return a->top_radius_m - a->planet_radius_m;
}

static Place place_of(const Atmosphere *a) {
    if (a->observer_height_m > air_thickness_m(a)) return ABOVE_AIR;
    return a->observer_height_m > 20e3 ? IN_AIR : a->observer_height_m > 1e3 ? UP_TO_20_KM : UP_TO_1_KM;
}

/* The band of heights, for the factors. */
static int band_of(const Atmosphere *a) {
    double top = air_thickness_m(a), height = a->observer_height_m,
           edges[BIAS_BANDS - 1] = {2, 1e3, 10e3, 20e3, top - 18e3, top - 3e3, top, top + 3e3, top + 30e3};
    int band = 0;
    while (band < BIAS_BANDS - 1 && height > edges[band]) band++;
    return band;
}

/* Whether each setting that decides how the sky's radiance varies with direction is within a tenth of the
 * other's. Of the settings that are left out, a spectrum, the ground and the further orders have figures of
 * their own. */
static bool is_like(const Atmosphere *a, const Atmosphere *known) {
    static const char *const others[] = {
        "observer_height_m", "mie_g",    "sun_irradiance", "wavelengths_nm", "refractive_index",
        "molecules_per_m3",  "spectrum", "orders",         "ground_albedo"};
    for (int k = 0; atmosphere_field(k); k++) {
        const AtmosphereField *field = atmosphere_field(k);
        const double *value = atmosphere_value(a, field), *there = atmosphere_value(known, field);
        bool counts = true;
        for (size_t o = 0; o < sizeof others / sizeof *others; o++)
            counts = counts && strcmp(field->name, others[o]) != 0;
        for (int c = 0; counts && c < field->count; c++) {
            if (fabs(value[c] - there[c]) > 0.1 * there[c]) return false;
        }
    }
    /* A tenth of a radius is ten times the air. */
    double thickness = air_thickness_m(known);
    return fabs(air_thickness_m(a) - thickness) <= 0.1 * thickness;
}

/* Which of the measured airs this one is like; -1 if it is like none. */
static int find_air(const Atmosphere *a) {
    for (int air = 0; air < BIAS_AIRS; air++) {
        for (int i = 0; atmosphere_preset(i); i++) {
            const AtmospherePreset *preset = atmosphere_preset(i);
            if (strcmp(preset->name, bias_airs[air]) == 0 && is_like(a, &preset->atmosphere)) return air;
        }
    }
    return -1;
}

static bool has_further(const Atmosphere *a) {
    return a->orders > 1;
}

/* Close below the top of the air errors change fast with height and sun: claims that were raised to what a
 * scan saw there were passed 2.4 times at other heights and suns. */
static bool is_near_top(const Atmosphere *a) {
    double below = air_thickness_m(a) - a->observer_height_m;
    return below >= 0 && below < 3e3;
}

/* Whether the figures were measured for such an air, such a height and such a sun. */
static bool is_measured(double sun, const Atmosphere *a) {
    double albedo = fmax(fmax(a->ground_albedo[0], a->ground_albedo[1]), a->ground_albedo[2]);
    return find_air(a) >= 0 && !is_near_top(a) && sun >= bias_suns_deg[BIAS_SUNS - 1] &&
           albedo <= (has_further(a) ? 1.1 * most_albedo : 0);
}

/* A column of `rows`, each of which has `count` figures. Between two measured suns the logarithm is
 * interpolated, as errors grow by orders of magnitude in twilight. */
static double between_suns(const double *rows, int count, int column, double sun) {
    double share;
    int row = locate(sun, &share);
    return exp((1 - share) * log(rows[row * count + column]) + share * log(rows[(row + 1) * count + column]));
}

/* Of airs that were not measured nothing is claimed, but their tables need a size: they take the figures of
 * the measured air that has ozone as they have. */
static double figure(int column, double sun, const Atmosphere *a) {
    int air = find_air(a);
    return between_suns(bias_figures[air >= 0 ? air : a->ozone > 0][place_of(a)][0], BIAS_COLUMNS, column,
                        sun);
}

static double further_figure(int column, double sun, const Atmosphere *a) {
    return between_suns(bias_further_figures[place_of(a)][0], BIAS_FURTHER_COLUMNS, column, sun);
}

/* By how much the figures of a column are raised at this height. */
static double factor(int column, double sun, const Atmosphere *a) {
    return between_suns(bias_factors[band_of(a)][0], BIAS_FACTORS, column, sun);
}

/* The part of the light that was scattered once. Its errors are so much smaller as shares of all light. */
static double single_share(double sun, const Atmosphere *a) {
    return has_further(a) ? further_figure(SINGLE_SHARE, sun, a) / 100 : 1;
}

static double raised_figure(int column, double sun, const Atmosphere *a) {
    return figure(column, sun, a) * factor(column, sun, a);
}

static double nodes_percent(const MethodChoice *choice, double sun, const Atmosphere *a) {
    MethodNumbers numbers = choice->method->numbers;
    if (numbers == NUMBERS_NODES)
        return fmax(raised_figure(column_of_nodes[choice->nodes - 4], sun, a),
                    raised_figure(next_column[choice->nodes - 4], sun, a));
    if (numbers != NUMBERS_STEPS) return NAN;
    if (choice->steps.view >= 64 && choice->steps.light >= 16) return raised_figure(PAPER_64X16, sun, a);
    return choice->steps.view >= 16 && choice->steps.light >= 4 ? raised_figure(PAPER_16X4, sun, a) : NAN;
}

/* The errors of a table fall with the square of its rows and of its columns: measured from 8x24 to 256x512,
 * to a few percent. */
static double table_percent(int columns, int rows, double sun, const Atmosphere *a) {
    double of_rows = has_further(a) ? further_figure(TOTAL_ROWS, sun, a) : figure(TABLE_ROWS, sun, a),
           of_columns =
               has_further(a) ? further_figure(TOTAL_COLUMNS, sun, a) : figure(TABLE_COLUMNS, sun, a);
    return factor(has_further(a) ? FACTOR_TOTAL_TABLE : FACTOR_TABLE, sun, a) *
           (of_rows * pow(96.0 / rows, 2) + of_columns * pow(32.0 / columns, 2));
}

/* The further light is bright around the sun, and a table keeps no phase function of it. With fewer columns
 * than it has itself (sky/further.c), errors grow faster than by their square. */
static int fewest_columns(const Atmosphere *a) {
    return has_further(a) ? 32 : 16;
}

void bias_table_size(const MethodChoice *choice, double sun, const Atmosphere *a, int *columns, int *rows) {
    *columns = choice->table_size.columns;
    *rows = choice->table_size.rows;
    if (!(choice->table_size.percent > 0)) return;
    for (*columns = fewest_columns(a); *columns < 256; *columns *= 2) {
        if (table_percent(*columns, 3 * *columns, sun, a) <= choice->table_size.percent) break;
    }
    *rows = 3 * *columns;
}

/* Colours from a spectrum err as much as those of three channels, but from high in the air, in twilight,
 * where ozone counts most: there gauss:7 was seen to err 1.3 times as much. */
static double spectrum_factor(const Atmosphere *a) {
    return a->spectrum != SPECTRUM_RGB && a->observer_height_m > 20e3 ? 1.5 : 1;
}

double bias_sky_percent(const MethodChoice *choice, double sun, const Atmosphere *a) {
    int columns, rows;
    if (!choice->method->integrates) return 0;
    if (!is_measured(sun, a)) return NAN;
    double nodes = nodes_percent(choice, sun, a) * single_share(sun, a) * spectrum_factor(a);
    if (!choice->table) return nodes;
    bias_table_size(choice, sun, a, &columns, &rows);
    if (has_further(a) && columns < fewest_columns(a)) return NAN;
    return nodes + table_percent(columns, rows, sun, a);
}

double bias_further_guess_percent(const MethodChoice *further, double sun, const Atmosphere *a) {
    int column = further->degree >= 14 ? HARMONICS_14 : further->degree >= 10 ? HARMONICS_10 : HARMONICS_8;
    if (!has_further(a)) return 0;
    return further_figure(column, sun, a) * factor(FACTOR_HARMONICS + column - HARMONICS_8, sun, a);
}

double bias_further_percent(const MethodChoice *further, double sun, const Atmosphere *a) {
    if (has_further(a) && !is_measured(sun, a)) return NAN;
    return bias_further_guess_percent(further, sun, a);
}
