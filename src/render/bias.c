#include "render/bias.h"

#include <math.h>
#include <string.h>

/* Where the observer is, and whether there is ozone: what was measured is held by place. */
typedef enum Place { ON_GROUND, IN_AIR, ABOVE_AIR, PLACES } Place;

enum { SUNS = 15, FIGURES = 11, PAPER = 7, ROWS = 9, COLUMNS = 10 };

/* gauss:n by n from 4; there are no columns for 9 and 11, which are better than the one before them. */
static const int column_of_nodes[] = {0, 1, 2, 3, 4, 4, 5, 5, 6};

static const double suns_deg[SUNS] = {90, 30, 15, 5, 2, 1, 0.5, 0, -0.2, -1, -4, -6, -8, -10, -12};

/* Percent, by sun: gauss:4, 5, 6, 7, 8, 10, 12, paper:16x4, 64x16, and of a table's 96 rows and 32 columns a half, which err by the
 * inverse square of their numbers: second order to a few percent from 8x24 to 256x512.
 *
 * Measured against gauss:12, and against the adaptive quadrature (--sky reference) where that is the better: relRMSE of the crater
 * and the materials, 96x96, 32 samples, the same paths; of the whole sky; and of the 20 degrees about the visible horizon. The
 * largest of these, over heights of 0 to 1 km, 10 to 50 km, and 100 to 1000 km, at 32 suns between those listed, and a tenth more. */
static const double figures[2][PLACES][SUNS][FIGURES] = {
    {
        {
            /* the ground */
            {1.9, 0.4, 0.081, 0.011, 0.0036, 0.001, 0.001, 14, 0.86, 0.041, 0.001},
            {2.5, 0.51, 0.12, 0.017, 0.0043, 0.001, 0.001, 26, 1.1, 0.051, 0.001},
            {2.8, 0.94, 0.21, 0.032, 0.0047, 0.001, 0.001, 39, 1.6, 0.049, 0.001},
            {6.7, 1.9, 0.37, 0.029, 0.0035, 0.001, 0.001, 26, 7.2, 0.11, 0.001},
            {13, 2.5, 0.17, 0.095, 0.024, 0.0011, 0.001, 67, 7.3, 0.12, 0.0035},
            {15, 1.7, 0.66, 0.23, 0.026, 0.0044, 0.001, 82, 4.2, 0.13, 0.0079},
            {14, 2.2, 1.4, 0.26, 0.062, 0.0062, 0.001, 77, 2.6, 0.14, 0.013},
            {11, 6, 2, 0.34, 0.25, 0.013, 0.0017, 52, 1.2, 0.14, 0.022},
            {2.8, 0.62, 0.11, 0.025, 0.0035, 0.001, 0.001, 34, 1.7, 0.13, 0.023},
            {0.79, 0.19, 0.036, 0.0066, 0.0013, 0.001, 0.001, 12, 0.69, 0.19, 0.092},
            {2.6, 0.65, 0.12, 0.02, 0.0025, 0.001, 0.001, 31, 2.5, 0.17, 0.15},
            {1.5, 0.27, 0.047, 0.0082, 0.0014, 0.001, 0.001, 73, 7.2, 0.39, 0.12},
            {2.1, 0.29, 0.059, 0.011, 0.0017, 0.001, 0.001, 2.1e+02, 20, 0.94, 0.39},
            {3, 0.95, 0.2, 0.038, 0.0072, 0.0011, 0.001, 4.8e+02, 39, 2.2, 1.5},
            {17, 3, 0.55, 0.14, 0.046, 0.004, 0.002, 1.1e+03, 60, 6.6, 7.9},
        },
        {
            /* in the air */
            {2.1, 0.37, 0.25, 0.06, 0.015, 0.0017, 0.001, 0.001, 0.001, 0.64, 0.001},
            {2.9, 0.55, 0.31, 0.087, 0.022, 0.0032, 0.001, 0.001, 0.001, 0.66, 0.001},
            {3.7, 0.84, 0.32, 0.14, 0.037, 0.0033, 0.001, 0.001, 0.001, 0.67, 0.0023},
            {5.1, 1.4, 0.38, 0.24, 0.048, 0.019, 0.001, 0.001, 0.001, 0.67, 0.034},
            {6.2, 1.4, 0.45, 0.26, 0.04, 0.0082, 0.001, 0.001, 0.001, 0.66, 0.051},
            {7.2, 1.5, 0.58, 0.28, 0.057, 0.0079, 0.001, 0.001, 0.001, 0.66, 0.063},
            {7.8, 1.6, 0.59, 0.3, 0.041, 0.0078, 0.001, 0.001, 0.001, 0.66, 0.07},
            {8.5, 1.7, 0.7, 0.31, 0.054, 0.0076, 0.001, 0.001, 0.001, 0.65, 0.082},
            {8.4, 1.6, 0.84, 0.24, 0.074, 0.0054, 0.001, 0.001, 0.001, 0.65, 0.088},
            {7.9, 2.6, 0.79, 0.2, 0.072, 0.0048, 0.001, 0.001, 0.001, 0.64, 0.13},
            {5.4, 2, 0.36, 0.18, 0.024, 0.005, 0.001, 0.001, 0.001, 1.6, 0.77},
            {5.3, 0.96, 0.28, 0.075, 0.021, 0.0014, 0.001, 0.001, 0.001, 3.7, 4.2},
            {11, 1.7, 0.44, 0.076, 0.013, 0.001, 0.001, 0.001, 0.001, 5.6, 1.4},
            {23, 2.4, 0.37, 0.12, 0.027, 0.0013, 0.001, 0.001, 0.001, 1.4e+02, 17},
            {15, 2.3, 0.36, 0.071, 0.014, 0.0021, 0.0021, 0.001, 0.001, 8.5, 7.3},
        },
        {
            /* above the air */
            {1.5, 0.47, 0.35, 0.042, 0.016, 0.011, 0.001, 0.001, 0.001, 0.045, 0.026},
            {2.1, 0.91, 0.59, 0.079, 0.051, 0.0098, 0.0011, 0.001, 0.001, 0.061, 0.3},
            {2.7, 1.5, 0.72, 0.095, 0.074, 0.0093, 0.0017, 0.001, 0.001, 0.05, 0.59},
            {3.4, 1.6, 0.79, 0.22, 0.089, 0.016, 0.0045, 0.001, 0.001, 0.052, 0.81},
            {4.6, 2, 0.87, 0.22, 0.088, 0.042, 0.0031, 0.001, 0.001, 0.072, 0.85},
            {5.5, 2.2, 0.91, 0.24, 0.095, 0.25, 0.0037, 0.001, 0.001, 0.13, 0.48},
            {6.2, 2.5, 0.94, 0.29, 0.11, 0.13, 0.0096, 0.001, 0.001, 0.15, 0.54},
            {6.9, 2.7, 1, 0.32, 0.12, 0.16, 0.019, 0.001, 0.001, 0.18, 0.58},
            {7.4, 2.8, 1.1, 0.36, 0.12, 0.058, 0.0067, 0.001, 0.001, 0.27, 0.61},
            {10, 3.9, 1.3, 0.42, 0.14, 0.02, 0.0016, 0.001, 0.001, 0.16, 0.73},
            {17, 3.9, 1.6, 0.48, 0.13, 0.03, 0.0012, 0.001, 0.001, 0.35, 1.7},
            {11, 3.8, 2.1, 0.28, 0.095, 0.0095, 0.0011, 0.001, 0.001, 0.71, 3},
            {16, 5.8, 2.8, 0.36, 0.17, 0.0095, 0.001, 0.001, 0.001, 1.2, 8.7},
            {24, 8.4, 3.1, 0.73, 0.28, 0.017, 0.001, 0.001, 0.001, 3.2, 11},
            {35, 8.5, 1.9, 1.3, 0.25, 0.037, 0.001, 0.001, 0.001, 2, 4.2},
        },
    },
    {
        {
            /* the ground, with ozone */
            {1.8, 0.37, 0.075, 0.011, 0.0067, 0.002, 0.0019, 14, 0.86, 0.022, 0.001},
            {2.5, 0.57, 0.12, 0.017, 0.0088, 0.0027, 0.0014, 26, 1.1, 0.024, 0.001},
            {2.8, 0.94, 0.21, 0.03, 0.006, 0.0019, 0.001, 39, 1.6, 0.03, 0.0013},
            {6.7, 1.9, 0.37, 0.03, 0.014, 0.006, 0.0038, 26, 7.2, 0.044, 0.0031},
            {14, 2.7, 0.18, 0.098, 0.059, 0.031, 0.02, 67, 7.3, 0.058, 0.0077},
            {16, 1.8, 0.69, 0.25, 0.057, 0.05, 0.035, 82, 4.2, 0.065, 0.012},
            {15, 2.3, 1.5, 0.28, 0.11, 0.073, 0.054, 77, 2.6, 0.071, 0.02},
            {12, 6.4, 2.2, 0.35, 0.33, 0.2, 0.096, 52, 1.2, 0.083, 0.043},
            {3, 0.76, 0.32, 0.23, 0.15, 0.18, 0.082, 34, 1.7, 0.082, 0.038},
            {1.6, 0.97, 0.72, 0.27, 0.19, 0.32, 0.091, 12, 0.69, 0.09, 0.049},
            {5.3, 3.4, 1.5, 0.5, 0.46, 0.8, 0.23, 31, 2.5, 0.15, 0.12},
            {8.1, 3, 1.4, 0.76, 0.76, 1.1, 0.33, 73, 7.2, 0.27, 0.17},
            {16, 4.8, 1.9, 1.6, 1.6, 1.5, 0.67, 2.1e+02, 20, 0.95, 0.45},
            {14, 6.9, 3, 2.4, 2.3, 1.4, 0.74, 4.8e+02, 39, 2.1, 0.87},
            {16, 5.4, 3.3, 2.2, 1.3, 1.4, 0.62, 1.1e+03, 60, 5.4, 4.9},
        },
        {
            /* in the air, with ozone */
            {2.1, 0.39, 0.25, 0.055, 0.024, 0.014, 0.007, 0.001, 0.001, 0.099, 0.0078},
            {2.5, 0.51, 0.29, 0.069, 0.031, 0.016, 0.0085, 0.001, 0.001, 0.13, 0.012},
            {3.1, 0.7, 0.33, 0.099, 0.039, 0.021, 0.011, 0.001, 0.001, 0.14, 0.015},
            {6.2, 1.9, 0.35, 0.27, 0.094, 0.037, 0.02, 0.001, 0.001, 0.16, 0.033},
            {7.4, 1.8, 0.39, 0.35, 0.16, 0.078, 0.042, 0.001, 0.001, 0.26, 0.058},
            {8.8, 2.1, 0.43, 0.44, 0.17, 0.12, 0.054, 0.001, 0.001, 0.29, 0.093},
            {9.8, 2.2, 0.55, 0.5, 0.19, 0.14, 0.059, 0.001, 0.001, 0.28, 0.12},
            {11, 2.4, 0.74, 0.56, 0.22, 0.16, 0.071, 0.001, 0.001, 0.26, 0.14},
            {9, 2.6, 0.97, 0.41, 0.24, 0.16, 0.061, 0.001, 0.001, 0.26, 0.14},
            {4.3, 1.8, 0.63, 0.29, 0.26, 0.17, 0.055, 0.001, 0.001, 0.27, 0.16},
            {8.9, 3.2, 1.4, 1.2, 0.6, 0.76, 0.32, 0.001, 0.001, 0.66, 0.86},
            {16, 6.2, 1.8, 0.79, 1.2, 1.3, 0.82, 0.001, 0.001, 2.2, 2.3},
            {17, 14, 6.3, 3.2, 2.1, 2.4, 0.6, 0.001, 0.001, 3.8, 1.7},
            {42, 17, 6.2, 2.6, 2.2, 4.2, 1.2, 0.001, 0.001, 5.5, 1.8},
            {33, 12, 4.5, 6.7, 4.2, 3.6, 0.98, 0.001, 0.001, 6.8, 3.2},
        },
        {
            /* above the air, with ozone */
            {2.9, 0.53, 0.79, 0.046, 0.03, 0.013, 0.011, 0.001, 0.001, 0.034, 0.03},
            {3.1, 0.81, 0.8, 0.064, 0.038, 0.017, 0.014, 0.001, 0.001, 0.049, 0.049},
            {3.6, 1.1, 0.9, 0.098, 0.058, 0.048, 0.018, 0.001, 0.001, 0.057, 0.26},
            {6.7, 2.8, 1.2, 0.35, 0.2, 0.039, 0.041, 0.001, 0.001, 0.072, 0.47},
            {12, 4.3, 0.92, 0.91, 0.35, 0.12, 0.045, 0.001, 0.001, 0.11, 0.82},
            {14, 4.8, 0.92, 1.3, 0.39, 0.15, 0.055, 0.001, 0.001, 0.12, 0.96},
            {15, 4.7, 1.1, 1.6, 0.37, 0.19, 0.061, 0.001, 0.001, 0.13, 1},
            {17, 4.2, 2, 1.8, 0.31, 0.25, 0.075, 0.001, 0.001, 0.15, 0.99},
            {12, 3.6, 1.5, 0.86, 0.23, 0.2, 0.075, 0.001, 0.001, 0.16, 0.96},
            {16, 4.7, 1.1, 0.6, 0.23, 0.15, 0.11, 0.001, 0.001, 0.21, 0.85},
            {7.5, 2, 0.54, 0.53, 0.5, 0.34, 0.16, 0.001, 0.001, 0.61, 0.62},
            {6.9, 1.5, 0.76, 0.45, 0.29, 0.16, 0.11, 0.001, 0.001, 1.6, 2.6},
            {3.9, 1.2, 0.68, 0.16, 0.16, 0.12, 0.061, 0.001, 0.001, 2.8, 5.7},
            {5.2, 1.6, 0.84, 0.37, 0.19, 0.17, 0.077, 0.001, 0.001, 3.7, 2.1},
            {18, 5.7, 3.5, 1.8, 2.4, 1.1, 0.53, 0.001, 0.001, 3.4, 3},
        },
    },
};

/* Where `sun` lies among the suns: the row before it, and the share of the next. */
static int locate(double sun, double *share) {
    int row = 0;
    while (row < SUNS - 2 && sun < suns_deg[row + 1]) row++;
    *share = fmin(fmax((suns_deg[row] - sun) / (suns_deg[row] - suns_deg[row + 1]), 0), 1);
    return row;
}

static Place place_of(const Atmosphere *a) {
    if (a->observer_height_m > a->top_radius_m - a->planet_radius_m) return ABOVE_AIR;
    return a->observer_height_m > 1000 ? IN_AIR : ON_GROUND;
}

/* Between two suns the logarithm is interpolated: errors grow by orders of magnitude in twilight. */
static double figure(int column, double sun, const Atmosphere *a) {
    const double (*rows)[FIGURES] = figures[a->ozone > 0][place_of(a)];
    double share;
    int row = locate(sun, &share);
    return exp((1 - share) * log(rows[row][column]) + share * log(rows[row + 1][column]));
}

/* Whether the settings that the sky's shape depends on are within a tenth of a preset's. */
static bool is_measured_air(const Atmosphere *a) {
    static const char *const others[] = {"observer_height_m", "mie_g",          "sun_irradiance",
                                         "wavelengths_nm",    "refractive_index", "molecules_per_m3"};
    for (int i = 0; atmosphere_preset(i); i++) {
        bool like = true;
        for (int k = 0; like && atmosphere_field(k); k++) {
            const AtmosphereField *field = atmosphere_field(k);
            const double *value = atmosphere_value(a, field);
            const double *known = atmosphere_value(&atmosphere_preset(i)->atmosphere, field);
            bool counts = true;
            for (size_t o = 0; o < sizeof others / sizeof *others; o++) counts = counts && strcmp(field->name, others[o]) != 0;
            for (int c = 0; counts && c < field->count; c++) like = like && fabs(value[c] - known[c]) <= 0.1 * known[c];
        }
        if (like) return true;
    }
    return false;
}

static double nodes_percent(const MethodChoice *choice, double sun, const Atmosphere *a) {
    const int *counts = choice->counts;
    if (strcmp(choice->method->name, "gauss") == 0) return figure(column_of_nodes[counts[0] - 4], sun, a);
    if (counts[0] >= 64 && counts[1] >= 16) return figure(PAPER + 1, sun, a);
    return counts[0] >= 16 && counts[1] >= 4 ? figure(PAPER, sun, a) : NAN;
}

static double table_percent(int columns, int rows, double sun, const Atmosphere *a) {
    return figure(ROWS, sun, a) * pow(96.0 / rows, 2) + figure(COLUMNS, sun, a) * pow(32.0 / columns, 2);
}

void bias_table_size(double percent, double sun, const Atmosphere *a, int *columns, int *rows) {
    for (*columns = 16; *columns < 256 && table_percent(*columns, 3 * *columns, sun, a) > percent;) *columns *= 2;
    *rows = 3 * *columns;
}

double bias_sky_percent(const MethodChoice *choice, double sun, const Atmosphere *a) {
    int columns = choice->columns, rows = choice->rows;
    if (!choice->method->integrates) return 0;
    if (!is_measured_air(a) || sun < suns_deg[SUNS - 1]) return NAN;
    if (choice->table && !columns) bias_table_size(choice->table_percent, sun, a, &columns, &rows);
    return nodes_percent(choice, sun, a) + (choice->table ? table_percent(columns, rows, sun, a) : 0);
}
