/* Finds the wavelengths that colours are best computed from, and the matrices that bring their radiances to
 * linear sRGB (src/scene/spectrum_figures.h). It is called by tools/spectrum.sh.
 *
 * spectrum_fit FILE...   reads rows of `magichour sky --at FILE --spectrum=360:830:10`, adds the light of the
 *                        sun's disk, prints a header to standard output, and a report to standard error.
 *
 * A row's true colour is that of its 48 wavelengths (tests/colors.h). The matrix is a least-squares fit to
 * half of the rows, each divided by its luminance, under the condition that the sun above the air stays
 * white. Errors are reported of the other half. Wavelengths are moved by steps of 10 nm as long as that makes
 * the fit's errors smaller. With KEEP in the environment they stay as they are, and the matrices alone are
 * found anew. */
#include "colors.h"

#include "base/vec3.h"
#include "scene/spectrum.h"
#include "scene/spectrum_figures.h"
#include "sky/sky_reference.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ROWS = 200000, MOST_SOURCES = 64, STARTS = 6, MOST = MOST_WAVELENGTHS };

typedef struct Row {
    /* Radiances as shares of the sun's irradiance, divided by the row's luminance. */
    double shares[COLORS_SAMPLES];
    double rgb[3];
    double height_m, sun_deg, luminance;
    int source;
    /* Whether it is in the half that the fit does not see. */
    bool unseen;
} Row;

/* Wavelengths as numbers of samples, and the matrix. */
typedef struct Fit {
    int count, sample[MOST];
    double matrix[3][MOST];
} Fit;

typedef struct Errors {
    double mean, most, luminance_mean, luminance_most;
    int rows;
} Errors;

static Row *rows;
static int row_count;
static bool keep[MOST_ROWS];
static const char *sources[MOST_SOURCES];
static int source_count;

static void fail(const char *words, const char *name) {
    fprintf(stderr, "spectrum_fit: %s: %s\n", name, words);
    exit(1);
}

static void add_row(const double shares[COLORS_SAMPLES], double height_m, double sun_deg) {
    Row row = {.height_m = height_m, .sun_deg = sun_deg, .source = source_count - 1};
    colors_of_shares(shares, row.rgb);
    double luminance = row.luminance = colors_luminance(row.rgb);
    if (!(luminance > 0)) return;
    if (row_count == MOST_ROWS) fail("too many rows", sources[source_count - 1]);
    for (int i = 0; i < COLORS_SAMPLES; i++) row.shares[i] = shares[i] / luminance;
    for (int c = 0; c < 3; c++) row.rgb[c] /= luminance;
    rows[row_count++] = row;
}

/* Leaves out the rows of the last source from `first` on that are a thousand times darker than the brightest
 * of the same height and sun, and chooses those that the fit does not see. */
static void choose_rows(int first) {
    int kept = first;
    for (int r = first; r < row_count; r++) {
        double brightest = 0;
        for (int k = first; k < row_count; k++) {
            if (rows[k].height_m == rows[r].height_m && rows[k].sun_deg == rows[r].sun_deg)
                brightest = fmax(brightest, rows[k].luminance);
        }
        keep[r] = rows[r].luminance > 1e-3 * brightest;
    }
    for (int r = first; r < row_count; r++) {
        if (!keep[r]) continue;
        rows[kept] = rows[r];
        rows[kept].unseen = (uint32_t)kept * 2654435761U >> 31;
        kept++;
    }
    row_count = kept;
}

static void add_source(const char *name) {
    if (source_count == MOST_SOURCES) fail("too many files", name);
    sources[source_count++] = name;
}

static void read_rows(const char *name) {
    char line[4096];
    int first = row_count;
    FILE *file = fopen(name, "r");
    if (!file) fail("cannot be read", name);
    add_source(name);
    while (fgets(line, sizeof line, file)) {
        double values[4 + COLORS_SAMPLES], shares[COLORS_SAMPLES];
        int count = 0;
        for (char *at = line, *end; count < 4 + COLORS_SAMPLES; at = end + 1) {
            values[count] = strtod(at, &end);
            if (end == at) break;
            count++;
            if (*end != ',') break;
        }
        if (count < 4 + COLORS_SAMPLES) continue;
        for (int i = 0; i < COLORS_SAMPLES; i++) shares[i] = values[4 + i] / colors_sun_per_nm(i);
        add_row(shares, values[0], values[1]);
    }
    fclose(file);
    choose_rows(first);
}

/* The light of the sun's disk at many elevations, from three heights. */
static void add_disk(const char *name, double ozone) {
    static const double heights[] = {1, 3000, 15000};
    Atmosphere atmosphere = atmosphere_preset(0)->atmosphere;
    int first = row_count;
    atmosphere.ozone = ozone;
    add_source(name);
    for (int k = 0; k < 3 * 40; k++) {
        double sun = 90 * pow((k / 3 + 0.5) / 40, 2), shares[COLORS_SAMPLES];
        const double direction[3] = {cos(sun * degree), sin(sun * degree), 0};
        for (int i = 0; i < COLORS_SAMPLES; i += 3) {
            double nm[3];
            for (int c = 0; c < 3; c++) nm[c] = colors_wavelength_nm(i + c);
            Atmosphere air = spectrum_air_at(&atmosphere, nm);
            sky_reference_transmittance(&air, heights[k % 3], direction, shares + i);
        }
        add_row(shares, heights[k % 3], sun);
    }
    choose_rows(first);
}

/* Solves the symmetric system a x = b in place by elimination with pivots. */
static void solve(int n, double a[MOST][MOST], double b[MOST]) {
    for (int k = 0; k < n; k++) {
        int pivot = k;
        for (int i = k + 1; i < n; i++) {
            if (fabs(a[i][k]) > fabs(a[pivot][k])) pivot = i;
        }
        for (int j = 0; j < n; j++) {
            double swap = a[k][j];
            a[k][j] = a[pivot][j], a[pivot][j] = swap;
        }
        double swap = b[k];
        b[k] = b[pivot], b[pivot] = swap;
        for (int i = 0; i < n; i++) {
            double factor = i == k ? 0 : a[i][k] / a[k][k];
            for (int j = k; j < n && factor != 0; j++) a[i][j] -= factor * a[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (int k = 0; k < n; k++) b[k] /= a[k][k];
}

/* A row of the matrix has the sum 1. So its last number is 1 less the others, and the fit is of differences
 * from the last wavelength. */
static void find_matrix(Fit *fit) {
    int n = fit->count - 1, last = fit->sample[n];
    double normal[MOST][MOST] = {{0}}, right[3][MOST] = {{0}};
    for (int r = 0; r < row_count; r++) {
        const Row *row = &rows[r];
        double x[MOST];
        if (row->unseen) continue;
        for (int i = 0; i < n; i++) x[i] = row->shares[fit->sample[i]] - row->shares[last];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) normal[i][j] += x[i] * x[j];
            for (int c = 0; c < 3; c++) right[c][i] += x[i] * (row->rgb[c] - row->shares[last]);
        }
    }
    for (int c = 0; c < 3; c++) {
        double copy[MOST][MOST];
        memcpy(copy, normal, sizeof copy);
        solve(n, copy, right[c]);
        fit->matrix[c][n] = 1;
        for (int i = 0; i < n; i++) {
            /* As it is printed. */
            fit->matrix[c][i] = round(1e6 * right[c][i]) / 1e6;
            fit->matrix[c][n] -= fit->matrix[c][i];
        }
    }
}

/* Of the rows of one half, of one source or (if it is below 0) of all, and of suns in a range. */
static Errors errors_of(const Fit *fit, bool unseen, int source, double low, double high) {
    Errors errors = {0};
    for (int r = 0; r < row_count; r++) {
        const Row *row = &rows[r];
        double rgb[3] = {0};
        if (row->unseen != unseen || (source >= 0 && row->source != source)) continue;
        if (row->sun_deg < low || row->sun_deg > high) continue;
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < fit->count; i++) rgb[c] += fit->matrix[c][i] * row->shares[fit->sample[i]];
        }
        double off = 100 * (colors_luminance(rgb) - 1), difference = colors_difference_of_hues(rgb, row->rgb);
        errors.mean += difference;
        errors.luminance_mean += off;
        errors.most = fmax(errors.most, difference);
        errors.luminance_most = fmax(errors.luminance_most, fabs(off));
        errors.rows++;
    }
    errors.mean /= fmax(errors.rows, 1);
    errors.luminance_mean /= fmax(errors.rows, 1);
    return errors;
}

static double largest(const Fit *fit) {
    double most = 0;
    for (int i = 0; i < 3 * fit->count; i++)
        most = fmax(most, fabs(fit->matrix[i / fit->count][i % fit->count]));
    return most;
}

/* What the search makes small. Large numbers in the matrix would amplify the errors of the sky's methods. */
static double judge(Fit *fit) {
    find_matrix(fit);
    Errors errors = errors_of(fit, false, -1, -90, 90);
    return 0.1 * fmax(largest(fit) - 1.5, 0) + errors.mean + 0.2 * errors.most + 0.1 * errors.luminance_most;
}

/* Moves one wavelength or two at a time until no move is better. */
static void improve(Fit *fit) {
    double best = judge(fit);
    for (bool better = true; better;) {
        better = false;
        for (int move = 0; move < 49 * fit->count * fit->count; move++) {
            int i = move % fit->count, k = move / fit->count % fit->count,
                step = move / fit->count / fit->count;
            Fit tried = *fit;
            bool rising = false;
            tried.sample[i] += step % 7 - 3;
            if (i != k) tried.sample[k] += step / 7 - 3;
            for (int c = 0; c < tried.count; c++) {
                rising = rising || tried.sample[c] < 0 || tried.sample[c] >= COLORS_SAMPLES ||
                         (c && tried.sample[c] >= tried.sample[c - 1]);
            }
            double value = rising ? INFINITY : judge(&tried);
            if (value >= best) continue;
            best = value;
            *fit = tried;
            better = true;
        }
    }
    judge(fit);
}

/* Starts from the wavelengths of before, and from others that are chosen at random, the same in each run. */
static void search(Fit *fit) {
    uint32_t random = 1;
    improve(fit);
    for (int start = 0; start < STARTS; start++) {
        Fit tried = *fit;
        for (int i = 0; i < fit->count; i++) {
            random = random * 1664525U + 1013904223U;
            /* Each in its part of the wavelengths from 700 down to 400 nm. */
            tried.sample[i] = 34 - (int)((i + (random >> 8) / 16777216.0) * 30 / fit->count);
            if (i && tried.sample[i] >= tried.sample[i - 1]) tried.sample[i] = tried.sample[i - 1] - 1;
        }
        improve(&tried);
        if (judge(&tried) < judge(fit)) *fit = tried;
    }
    judge(fit);
}

static Fit fit_of(int count, const double *nm) {
    Fit fit = {.count = count};
    for (int i = 0; i < count; i++) fit.sample[i] = (int)lround((nm[i] - 360) / 10);
    return fit;
}

static void report_line(const char *words, const Errors *e) {
    fprintf(stderr, "  %-44s %6d rows: dE mean %.3f, max %.3f; luminance mean %+.2f %%, max %.2f %%\n", words,
            e->rows, e->mean, e->most, e->luminance_mean, e->luminance_most);
}

static void report(const Fit *fit, const char *title) {
    static const double suns[] = {90, 15, 0.5, -2.5, -90};
    fprintf(stderr, "%s:", title);
    for (int i = 0; i < fit->count; i++) fprintf(stderr, " %g", colors_wavelength_nm(fit->sample[i]));
    fprintf(stderr, " nm, largest number of the matrix %.2f\n", largest(fit));
    Errors all = errors_of(fit, true, -1, -90, 90);
    report_line("all", &all);
    for (int s = 0; s < source_count; s++) {
        Errors errors = errors_of(fit, true, s, -90, 90);
        report_line(sources[s], &errors);
    }
    for (int i = 0; i < 4; i++) {
        char words[60];
        Errors errors = errors_of(fit, true, -1, nextafter(suns[i + 1], 90), suns[i]);
        snprintf(words, sizeof words, "suns above %g, up to %g", suns[i + 1], suns[i]);
        report_line(words, &errors);
    }
}

static void print_fit(const Fit *fit, const char *name, const char *count) {
    printf("\nstatic const double spectrum_%s_nm[%s] = {", name, count);
    for (int i = 0; i < fit->count; i++) printf("%s%g", i ? ", " : "", colors_wavelength_nm(fit->sample[i]));
    printf("};\n\nstatic const double spectrum_%s[3][%s] = {\n", name, count);
    for (int c = 0; c < 3; c++) {
        for (int i = 0; i < fit->count; i++) printf("%s%.6f", i ? ", " : "    {", fit->matrix[c][i]);
        printf("},\n");
    }
    printf("};\n");
}

int main(int argc, char **argv) {
    static const double rgb_nm[3] = {680, 550, 440};
    rows = calloc(MOST_ROWS, sizeof *rows);
    for (int i = 1; i < argc; i++) read_rows(argv[i]);
    add_disk("the sun's disk without ozone", 0);
    add_disk("the sun's disk with ozone", 1);
    Fit rgb = fit_of(3, rgb_nm), few = fit_of(SPECTRUM_FEW, spectrum_few_nm),
        many = fit_of(SPECTRUM_MANY, spectrum_many_nm);
    for (int c = 0; c < 3; c++) rgb.matrix[c][c] = 1;
    report(&rgb, "rgb");
    bool keep_wavelengths = getenv("KEEP") != NULL;
    find_matrix(&few);
    find_matrix(&many);
    if (!keep_wavelengths) search(&few);
    report(&few, "3 wavelengths");
    if (!keep_wavelengths) search(&many);
    report(&many, "6 wavelengths");
    printf("/* The wavelengths that colours are computed from, and the matrices that bring their radiances "
           "to linear\n"
           " * sRGB: tools/spectrum.sh makes this file, and says how.\n *\n"
           " * The rows of a matrix are R, G and B. Its columns are the wavelengths, and each row's sum is "
           "1: white is\n"
           " * the sun above the air. */\n#pragma once\n\nenum { SPECTRUM_FEW = 3, SPECTRUM_MANY = 6 };\n");
    print_fit(&few, "few", "SPECTRUM_FEW");
    print_fit(&many, "many", "SPECTRUM_MANY");
    free(rows);
    return 0;
}
