#include "sky/harmonics.h"

#include "base/vec3.h"

#include <math.h>

int harmonics_count(int most) {
    return (most + 1) * (most + 2) / 2;
}

int harmonics_index(int most, int l, int m) {
    return m * (most + 1) - m * (m - 1) / 2 + l - m;
}

HarmonicStep harmonics_step(int l, int m) {
    double ll = l * l, mm = m * m;
    if (l == 0) return (HarmonicStep){1 / sqrt(4 * pi), 0};
    /* The factor sqrt(2) of all harmonics with m > 0 enters once, at m = 1. */
    if (l == m) return (HarmonicStep){sqrt((2 * m + 1.0) / (2 * m)) * (m == 1 ? sqrt(2) : 1), 0};
    double before = (l - 1) * (l - 1);
    return (HarmonicStep){sqrt((4 * ll - 1) / (ll - mm)),
                          l == m + 1 ? 0 : sqrt((before - mm) / (4 * before - 1))};
}

void harmonics_steps(int most, HarmonicStep *steps) {
    for (int m = 0, k = 0; m <= most; m++) {
        for (int l = m; l <= most; l++, k++) steps[k] = harmonics_step(l, m);
    }
}

void harmonics_at(const HarmonicStep *steps, int most, double nu, double cos_psi, double *values) {
    double s = sqrt(fmax(0, 1 - nu * nu)), start = 1, cosine = 1, cosine_before = cos_psi;
    for (int m = 0, k = 0; m <= most; m++) {
        double y = 0, y_before = 0;
        for (int l = m; l <= most; l++, k++) {
            double next = l > m ? steps[k].rise * (nu * y - steps[k].fall * y_before)
                                : steps[k].rise * start * (m ? s : 1);
            y_before = l > m ? y : 0;
            y = next;
            if (l == m) start = y;
            values[k] = y * cosine;
        }
        /* cos((m + 1) psi) = 2 cos(psi) cos(m psi) - cos((m - 1) psi) */
        double cosine_next = 2 * cos_psi * cosine - cosine_before;
        cosine_before = cosine;
        cosine = cosine_next;
    }
}

double harmonics_azimuth(double mu, double mu_sun, double nu) {
    double across = fmax((1 - nu * nu) * (1 - mu_sun * mu_sun), 1e-30);
    return fmin(fmax((mu - nu * mu_sun) / sqrt(across), -1), 1);
}

/* The generating function of Legendre polynomials makes Henyey and Greenstein's function the sum of (2l+1)
 * g^l P_l, over 4 pi. Cornette and Shanks multiply it with 3/2 (1 + nu^2) / (2 + g^2) (1 - g^2) / (1 - g^2).
 * With nu P_l = ((l+1) P_(l+1) + l P_(l-1)) / (2l+1), the factor nu^2 couples l with l - 2, l and l + 2. */
void harmonics_mie(double g, int most, double *chi) {
    for (int l = 0; l <= most; l++) {
        double below = l > 1 ? l * (l - 1.0) / ((2.0 * l + 1) * (2 * l - 1)) * pow(g, l - 2) : 0;
        double above = (l + 1.0) * (l + 2) / ((2.0 * l + 1) * (2 * l + 3)) * pow(g, l + 2);
        double same = l * (double)l / ((2.0 * l + 1) * (2 * l - 1)) +
                      (l + 1.0) * (l + 1) / ((2.0 * l + 1) * (2 * l + 3));
        if (l == 0) same = 1.0 / 3;
        chi[l] = 1.5 / (2 + g * g) * (pow(g, l) * (1 + same) + below + above);
    }
}
