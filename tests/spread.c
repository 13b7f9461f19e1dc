#include "spread.h"

#include "support.h"

#include <math.h>
#include <string.h>

void spread_render(const char *scene, const char *arguments, int size, int first_seed, Spread *spread) {
    memset(spread, 0, sizeof *spread);
    spread->values = 3 * size * size;
    for (int seed = 0; seed < SPREAD_SEEDS; seed++) {
        Image image;
        Error error;
        int status = support_run("", "render '%s' --quiet --size %dx%d %s --seed %d -o '%s'", scene, size,
                                 size, arguments, first_seed + seed, support_path("picture.pfm"));
        if (status == STATUS_NO_GL) support_no_gl(support_err);
        if (status != 0) fail_msg("render %s: %s", arguments, support_err);
        if (!image_read(&image, support_path("picture.pfm"), &error)) fail_msg("%s", error.text);
        for (int i = 0; i < spread->values; i++) {
            double value = (double)image.rgba[4 * (i / 3) + i % 3];
            spread->mean[i] += value / SPREAD_SEEDS;
            spread->variance[i] += value * value / SPREAD_SEEDS;
        }
        image_free(&image);
    }
    for (int i = 0; i < spread->values; i++)
        spread->variance[i] =
            fmax(spread->variance[i] - spread->mean[i] * spread->mean[i], 0) / (SPREAD_SEEDS - 1);
}

Agreement spread_agreement(const Spread *a, const Spread *b) {
    Agreement result = {0};
    double sums[2] = {0};
    int counted = 0;
    for (int i = 0; i < a->values; i++) {
        double va = a->variance[i], vb = b->variance[i], both = va + vb, difference = b->mean[i] - a->mean[i];
        sums[0] += a->mean[i];
        sums[1] += b->mean[i];
        if (both < 1e-6 * a->mean[i] * a->mean[i]) continue; /* the sky and the disk: no noise to speak of */
        double freedom = (SPREAD_SEEDS - 1) * both * both / (va * va + vb * vb);
        result.expected += freedom / (freedom - 2);
        result.z2 += difference * difference / both;
        result.far += difference * difference > 16 * both;
        counted++;
    }
    result.difference = sums[1] / sums[0] - 1;
    result.z2 /= counted;
    result.expected /= counted;
    result.far /= counted;
    return result;
}

/* Whether a pixel is off all edges: the picture is nearly even two pixels around it. */
bool spread_even_around(const Image *image, int x, int y) {
    double least = 1e30, most = 0;
    for (int i = 0; i < 25; i++) {
        const float *p = image->rgba + 4 * ((y + i / 5 - 2) * image->width + x + i % 5 - 2);
        double level = (double)p[0] + (double)p[1] + (double)p[2];
        least = fmin(least, level);
        most = fmax(most, level);
    }
    return most < 1.25 * least;
}
