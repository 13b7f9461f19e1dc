#include "spread.h"

#include "failed.h"
#include "studio.h"
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The means of blocks of side x side pixels; the picture is given up. What is left at the right and below is
 * cut off. */
static Image average_blocks(Image *image, int side) {
    if (side == 1) return *image;
    Image blocks = image_create(image->width / side, image->height / side);
    for (int i = 0; i < blocks.width * blocks.height * side * side; i++) {
        int block = i / (side * side), x = block % blocks.width * side + i % side;
        int y = block / blocks.width * side + i / side % side;
        for (int c = 0; c < 4; c++)
            blocks.rgba[4 * block + c] += image->rgba[4 * (y * image->width + x) + c] / (float)(side * side);
    }
    image_free(image);
    return blocks;
}

void spread_render(const char *scene, const char *arguments, int first_seed, Spread *spread) {
    static Studio studio;
    memset(spread, 0, sizeof *spread);
    studio_open(&studio, scene, arguments);
    for (int seed = 0; seed < SPREAD_SEEDS; seed++) {
        Image picture = studio_picture(&studio, (unsigned)(first_seed + seed));
        Image image = average_blocks(&picture, support_block());
        spread->width = image.width;
        spread->height = image.height;
        spread->values = 3 * image.width * image.height;
        assert_true(spread->values <= SPREAD_MOST_VALUES);
        for (int i = 0; i < spread->values; i++) {
            double value = (double)image.rgba[4 * (i / 3) + i % 3];
            spread->mean[i] += value / SPREAD_SEEDS;
            spread->variance[i] += value * value / SPREAD_SEEDS;
        }
        image_free(&image);
    }
    studio_close(&studio);
    for (int i = 0; i < spread->values; i++)
        spread->variance[i] =
            fmax(spread->variance[i] - spread->mean[i] * spread->mean[i], 0) / (SPREAD_SEEDS - 1);
}

Image spread_image(const Spread *spread) {
    Image image = image_create(spread->width, spread->height);
    for (int i = 0; i < spread->values; i++) image.rgba[4 * (i / 3) + i % 3] = (float)spread->mean[i];
    for (int i = 0; i < spread->values / 3; i++) image.rgba[4 * i + 3] = 1;
    return image;
}

/* By Welch's degrees of freedom. */
static void compare_values(const Spread *got, const Spread *wanted, ZTest *test) {
    for (int i = 0; i < got->values; i++) {
        double a = got->variance[i], b = wanted->variance[i], both = a + b;
        /* The sky and the disk have no noise to speak of. */
        if (both < 1e-6 * wanted->mean[i] * wanted->mean[i]) continue;
        ztest_add(test, got->mean[i] - wanted->mean[i], both,
                  (SPREAD_SEEDS - 1) * both * both / (a * a + b * b));
    }
}

typedef struct Means {
    double difference, variance, sum;
} Means;

/* The channels of a pixel have the same paths: they may all be off together. */
static Means compare_means(const Spread *got, const Spread *wanted) {
    Means means = {0};
    for (int i = 0; i < got->values; i++) {
        means.difference += got->mean[i] - wanted->mean[i];
        means.variance += 3 * (got->variance[i] + wanted->variance[i]);
        means.sum += wanted->mean[i];
    }
    return means;
}

void spread_expect_same(const char *name, const Spread *got, const Spread *wanted, long comparisons,
                        ZTest *pool) {
    ZTest test = {.together = 3, .comparisons = comparisons};
    assert_int_equal(got->values, wanted->values);
    compare_values(got, wanted, &test);
    if (pool) ztest_pool(pool, &test);
    Means means = compare_means(got, wanted);
    bool mean = ztest_difference(name, means.difference, means.variance, means.sum, comparisons);
    bool square = ztest_mean_square(name, &test), outliers = ztest_outliers(name, &test);
    support_table("z-tests", "| %s | %+.3f %% | %.3f %% | %.2f | %.2f | %.2f %% | %.2f %% |", name,
                  100 * means.difference / means.sum,
                  100 * ztest_difference_limit(means.variance, comparisons) / means.sum,
                  test.z2 / (double)test.count, test.expected / (double)test.count,
                  100 * test.far / (double)test.count, 100 * test.far_expected / (double)test.count);
    if (mean && square && outliers) return;
    Image pictures[] = {spread_image(got), spread_image(wanted)};
    failed_keep(name, &pictures[0], &pictures[1]);
    for (int i = 0; i < 2; i++) image_free(&pictures[i]);
    fail_msg("%s: not the same picture", name);
}

void spread_expect_pool(const char *name, const ZTest *pool) {
    double mean = pool->z2 / (double)pool->count, expected = pool->expected / (double)pool->count;
    bool ok = ztest_mean_square(name, pool);
    /* Where there are values enough for limits of about 5 %, they are no wider than that. */
    if (support_block() == 1) ok = ok && mean < 1.05 * expected && mean > 0.95;
    if (!ok) fail_msg("%s: not the same pictures", name);
}

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
