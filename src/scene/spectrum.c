#include "scene/spectrum.h"

int spectrum_bands(const Atmosphere *atmosphere) {
    return atmosphere->spectrum > 3 ? 2 : 1;
}

Atmosphere spectrum_band(const Atmosphere *atmosphere, int band) {
    (void)band;
    return *atmosphere;
}

void spectrum_matrix(const Atmosphere *atmosphere, int band, double matrix[3][3]) {
    (void)atmosphere;
    (void)band;
    for (int i = 0; i < 9; i++) matrix[i / 3][i % 3] = i % 4 == 0;
}
