#include "colors.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double degree = 3.14159265358979323846 / 180;

/* sRGB (IEC 61966-2-1): its primaries as rows of a matrix from XYZ, and its white D65. */
static const double rgb_from_xyz[3][3] = {{3.2404541621, -1.5371385128, -0.4985314096},
                                          {-0.9692660305, 1.8760108454, 0.0415560175},
                                          {0.0556434309, -0.2040259135, 1.0572251882}};
static const double bradford[3][3] = {
    {0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}};

static double spectra[COLORS_SAMPLES][4];
/* XYZ to linear sRGB, from the sun's white; and sRGB to XYZ. */
static double adapted[3][3], xyz_from_rgb[3][3];

double colors_wavelength_nm(int i) {
    return 360 + 10.0 * i;
}

static void times(const double m[3][3], const double v[3], double out[3]) {
    for (int i = 0; i < 3; i++) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
}

static void multiply(const double a[3][3], const double b[3][3], double out[3][3]) {
    for (int i = 0; i < 9; i++) {
        out[i / 3][i % 3] = 0;
        for (int k = 0; k < 3; k++) out[i / 3][i % 3] += a[i / 3][k] * b[k][i % 3];
    }
}

static void invert(const double m[3][3], double out[3][3]) {
    double determinant = 0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            int a = (k + 1) % 3, b = (k + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            out[i][k] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    }
    for (int k = 0; k < 3; k++) determinant += m[0][k] * out[k][0];
    for (int i = 0; i < 9; i++) out[i / 3][i % 3] /= determinant;
}

static void xyz_of_shares(const double shares[COLORS_SAMPLES], double xyz[3]) {
    for (int c = 0; c < 3; c++) {
        xyz[c] = 0;
        for (int i = 0; i < COLORS_SAMPLES; i++) xyz[c] += shares[i] * spectra[i][0] * spectra[i][c + 1];
    }
}

static void read_spectra(void) {
    char line[256];
    int count = 0;
    FILE *file = fopen("tests/data/spectral.csv", "r");
    while (file && fgets(line, sizeof line, file)) {
        double nm, sun, ozone, xyz[3];
        if (sscanf(line, "%lf,%lf,%lf,%lf,%lf,%lf", &nm, &sun, &ozone, &xyz[0], &xyz[1], &xyz[2]) != 6)
            continue;
        if (count == COLORS_SAMPLES || nm != colors_wavelength_nm(count)) break;
        spectra[count][0] = sun;
        memcpy(&spectra[count++][1], xyz, sizeof xyz);
    }
    if (file) fclose(file);
    if (count == COLORS_SAMPLES) return;
    fprintf(stderr, "tests/data/spectral.csv cannot be read (from the repository's folder)\n");
    exit(1);
}

static void prepare(void) {
    static bool ready;
    double ones[COLORS_SAMPLES], sun[3], cones[3], white[3], white_cones[3], back[3][3],
        scale[3][3] = {{0}}, both[3][3], all[3][3];
    static const double unit[3] = {1, 1, 1};
    if (ready) return;
    ready = true;
    read_spectra();
    for (int i = 0; i < COLORS_SAMPLES; i++) ones[i] = 1;
    invert(rgb_from_xyz, xyz_from_rgb);
    times(xyz_from_rgb, unit, white);
    xyz_of_shares(ones, sun);
    times(bradford, sun, cones);
    times(bradford, white, white_cones);
    for (int c = 0; c < 3; c++) scale[c][c] = white_cones[c] / cones[c];
    invert(bradford, back);
    multiply(scale, bradford, both);
    multiply(back, both, all);
    multiply(rgb_from_xyz, all, adapted);
}

void colors_of_shares(const double shares[COLORS_SAMPLES], double rgb[3]) {
    double xyz[3];
    prepare();
    xyz_of_shares(shares, xyz);
    times(adapted, xyz, rgb);
}

double colors_sun_per_nm(int i) {
    prepare();
    return spectra[i][0];
}

double colors_luminance(const double rgb[3]) {
    prepare();
    return xyz_from_rgb[1][0] * rgb[0] + xyz_from_rgb[1][1] * rgb[1] + xyz_from_rgb[1][2] * rgb[2];
}

void colors_lab(const double rgb[3], double lab[3]) {
    static const double unit[3] = {1, 1, 1};
    double xyz[3], white[3], f[3];
    prepare();
    times(xyz_from_rgb, rgb, xyz);
    times(xyz_from_rgb, unit, white);
    for (int c = 0; c < 3; c++) {
        double t = xyz[c] / white[c];
        f[c] = t > 216.0 / 24389 ? cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    }
    lab[0] = 116 * f[1] - 16;
    lab[1] = 500 * (f[0] - f[1]);
    lab[2] = 200 * (f[1] - f[2]);
}

static double hue_deg(double a, double b) {
    double hue = a == 0 && b == 0 ? 0 : atan2(b, a) / degree;
    return hue < 0 ? hue + 360 : hue;
}

/* Of two hues of colours that are not grey; the mean is that of the shorter way around. */
static double mean_hue_deg(double h, double k) {
    if (fabs(h - k) <= 180) return (h + k) / 2;
    return h + k < 360 ? (h + k + 360) / 2 : (h + k - 360) / 2;
}

/* Sharma, Wu and Dalal 2005, with all weights 1. */
double colors_difference(const double lab[3], const double other[3]) {
    double mean_c = (hypot(lab[1], lab[2]) + hypot(other[1], other[2])) / 2, c7 = pow(mean_c, 7);
    double g = 0.5 * (1 - sqrt(c7 / (c7 + pow(25, 7))));
    double a = (1 + g) * lab[1], other_a = (1 + g) * other[1];
    double c = hypot(a, lab[2]), other_c = hypot(other_a, other[2]);
    double h = hue_deg(a, lab[2]), other_h = hue_deg(other_a, other[2]), turn = other_h - h;
    bool grey = c * other_c == 0;
    if (turn > 180) turn -= 360;
    if (turn < -180) turn += 360;
    double dl = other[0] - lab[0], dc = other_c - c;
    double dh = grey ? 0 : 2 * sqrt(c * other_c) * sin(turn / 2 * degree);
    double l = (lab[0] + other[0]) / 2, chroma = (c + other_c) / 2;
    double hue = grey ? h + other_h : mean_hue_deg(h, other_h);
    double t = 1 - 0.17 * cos((hue - 30) * degree) + 0.24 * cos(2 * hue * degree) +
               0.32 * cos((3 * hue + 6) * degree) - 0.20 * cos((4 * hue - 63) * degree);
    double away = (hue - 275) / 25, chroma7 = pow(chroma, 7), l50 = (l - 50) * (l - 50);
    double sl = 1 + 0.015 * l50 / sqrt(20 + l50), sc = 1 + 0.045 * chroma, sh = 1 + 0.015 * chroma * t;
    double rt = -2 * sqrt(chroma7 / (chroma7 + pow(25, 7))) * sin(60 * exp(-away * away) * degree);
    dl /= sl;
    dc /= sc;
    dh /= sh;
    return sqrt(fmax(dl * dl + dc * dc + dh * dh + rt * dc * dh, 0));
}

double colors_difference_of_hues(const double rgb[3], const double other[3]) {
    double scaled[3], other_scaled[3], lab[3], other_lab[3];
    for (int c = 0; c < 3; c++) {
        scaled[c] = 0.5 * rgb[c] / colors_luminance(rgb);
        other_scaled[c] = 0.5 * other[c] / colors_luminance(other);
    }
    colors_lab(scaled, lab);
    colors_lab(other_scaled, other_lab);
    return colors_difference(lab, other_lab);
}
