#include "choice/bias.h"

#include "choice/bias_figures.h"

#include <math.h>
#include <string.h>

/* Where the observer is: what was measured is held by place. */
typedef enum Place { UP_TO_1_KM, UP_TO_20_KM, IN_AIR, ABOVE_AIR } Place;

/* The columns of the figures behind those of gauss. */
enum { PAPER_16X4 = 7, PAPER_64X16, TABLE_ROWS, TABLE_COLUMNS };

/* The column of gauss:n, by n from 4. gauss:9 has the figures of gauss:8, and gauss:11 those of gauss:10:
 * more nodes are more accurate. */
static const int column_of_nodes[] = {0, 1, 2, 3, 4, 4, 5, 5, 6};

/* The row of the last measured sun that is as high as `sun`, and the share that the next row has. */
static int locate(double sun, double *share) {
    const double *suns = bias_suns_deg;
    int row = 0;
    while (row < BIAS_SUNS - 2 && sun < suns[row + 1]) row++;
    *share = fmin(fmax((suns[row] - sun) / (suns[row] - suns[row + 1]), 0), 1);
    return row;
}

static Place place_of(const Atmosphere *a) {
    if (a->observer_height_m > a->top_radius_m - a->planet_radius_m) return ABOVE_AIR;
    return a->observer_height_m > 20e3 ? IN_AIR : a->observer_height_m > 1e3 ? UP_TO_20_KM : UP_TO_1_KM;
}

/* Whether each setting that decides how the sky's radiance varies with direction is within a tenth of the
 * other's. */
static bool is_like(const Atmosphere *a, const Atmosphere *known) {
    static const char *const others[] = {"observer_height_m", "mie_g",
                                         "sun_irradiance",    "wavelengths_nm",
                                         "refractive_index",  "molecules_per_m3"};
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
    return true;
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

/* Between two measured suns the logarithm is interpolated, as errors grow by orders of magnitude in twilight.
 * Of airs that were not measured nothing is claimed, but their tables need a size: they take the figures of
 * the measured air that has ozone as they have. */
static double figure(int column, double sun, const Atmosphere *a) {
    int air = find_air(a);
    const double(*rows)[BIAS_COLUMNS] = bias_figures[air >= 0 ? air : a->ozone > 0][place_of(a)];
    double share;
    int row = locate(sun, &share);
    return exp((1 - share) * log(rows[row][column]) + share * log(rows[row + 1][column]));
}

static double nodes_percent(const MethodChoice *choice, double sun, const Atmosphere *a) {
    MethodNumbers numbers = choice->method->numbers;
    if (numbers == NUMBERS_NODES) return figure(column_of_nodes[choice->nodes - 4], sun, a);
    if (numbers != NUMBERS_STEPS) return NAN;
    if (choice->steps.view >= 64 && choice->steps.light >= 16) return figure(PAPER_64X16, sun, a);
    return choice->steps.view >= 16 && choice->steps.light >= 4 ? figure(PAPER_16X4, sun, a) : NAN;
}

/* The errors of a table fall with the square of its rows and of its columns: measured from 8x24 to 256x512,
 * to a few percent. */
static double table_percent(int columns, int rows, double sun, const Atmosphere *a) {
    return figure(TABLE_ROWS, sun, a) * pow(96.0 / rows, 2) +
           figure(TABLE_COLUMNS, sun, a) * pow(32.0 / columns, 2);
}

void bias_table_size(const MethodChoice *choice, double sun, const Atmosphere *a, int *columns, int *rows) {
    *columns = choice->table_size.columns;
    *rows = choice->table_size.rows;
    if (!(choice->table_size.percent > 0)) return;
    for (*columns = 16; *columns < 256; *columns *= 2) {
        if (table_percent(*columns, 3 * *columns, sun, a) <= choice->table_size.percent) break;
    }
    *rows = 3 * *columns;
}

double bias_sky_percent(const MethodChoice *choice, double sun, const Atmosphere *a) {
    int columns, rows;
    if (!choice->method->integrates) return 0;
    if (find_air(a) < 0 || sun < bias_suns_deg[BIAS_SUNS - 1]) return NAN;
    if (!choice->table) return nodes_percent(choice, sun, a);
    bias_table_size(choice, sun, a, &columns, &rows);
    return nodes_percent(choice, sun, a) + table_percent(columns, rows, sun, a);
}
