/* Every light method and sequence gives the same picture, pixel by pixel, with the sun's disk and without;
 * and so does the disk found by chance. Means alone would not show a branch frozen by pixel or a light
 * counted twice in one place and lost in another. */
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SIZE = 64, VALUES = 3 * SIZE * SIZE, SEEDS = 8 };

/* A picture's mean over the seeds and the variance of that mean, by channel. */
typedef struct Spread {
    double mean[VALUES], variance[VALUES];
} Spread;

static void render_seeds(const char *arguments, int first_seed, Spread *spread) {
    memset(spread, 0, sizeof *spread);
    for (int seed = 0; seed < SEEDS; seed++) {
        Image image;
        Error error;
        int status = support_run("", "render scenes/crater.glsl --quiet --size %dx%d %s --seed %d -o '%s'",
                                 SIZE, SIZE, arguments, first_seed + seed, support_path("picture.pfm"));
        if (status == STATUS_NO_GL) skip();
        if (status != 0) fail_msg("render %s: %s", arguments, support_err);
        if (!image_read(&image, support_path("picture.pfm"), &error)) fail_msg("%s", error.text);
        for (int i = 0; i < VALUES; i++) {
            double value = (double)image.rgba[4 * (i / 3) + i % 3];
            spread->mean[i] += value / SEEDS;
            spread->variance[i] += value * value / SEEDS;
        }
        image_free(&image);
    }
    for (int i = 0; i < VALUES; i++)
        spread->variance[i] = fmax(spread->variance[i] - spread->mean[i] * spread->mean[i], 0) / (SEEDS - 1);
}

/* What two spreads say of each other. Expected: mean z^2 as Student's t with Welch's degrees of freedom makes
 * it. */
typedef struct Agreement {
    double difference, z2, expected, far; /* relative difference of the means; share of |z| > 4 */
} Agreement;

static Agreement agree(const Spread *a, const Spread *b) {
    Agreement result = {0};
    double sums[2] = {0};
    int counted = 0;
    for (int i = 0; i < VALUES; i++) {
        double va = a->variance[i], vb = b->variance[i], both = va + vb, difference = b->mean[i] - a->mean[i];
        sums[0] += a->mean[i];
        sums[1] += b->mean[i];
        if (both < 1e-6 * a->mean[i] * a->mean[i]) continue; /* the sky and the disk: no noise to speak of */
        double freedom = (SEEDS - 1) * both * both / (va * va + vb * vb);
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

/* One place's agreement, added to what is pooled over places. */
static void compare_at(const char *scene, const char *first, const char *second, const Spread *a,
                       Agreement *pool) {
    static Spread b;
    char arguments[256];
    snprintf(arguments, sizeof arguments, "%s %s", scene, second);
    render_seeds(arguments, 100, &b);
    Agreement got = agree(a, &b);
    print_message("%s: %s against %s: means differ by %+.3f %%, mean z^2 %.3f of %.3f, |z| > 4 in %.2f %%\n",
                  scene, second, first, 100 * got.difference, got.z2, got.expected, 100 * got.far);
    assert_true(fabs(got.difference) < 3e-3 && got.far < 0.01);
    pool->z2 += got.z2;
    pool->expected += got.expected;
}

/* One place's mean z^2 is itself known to 3 % only; over several it must be within 5 % of what it should be.
 * Student's t holds for even noise: where one rare find in eight seeds is all the noise, z^2 is nearer to 1,
 * which is no fault. */
static void expect_agreement(const char *name, const Agreement *pool, int places) {
    print_message("%s: over %d suns, mean z^2 %.3f of %.3f\n", name, places, pool->z2 / places,
                  pool->expected / places);
    assert_true(pool->z2 < 1.05 * pool->expected && pool->z2 > 0.95 * places);
}

static const char *const suns[] = {"60", "30", "5,90", "-2"};

static void test_sky(void **state) {
    (void)state;
    static const char plain[] = "--light cosine --sequence random";
    static const char *const others[] = {"--light control --sequence sobol",
                                         "--light control --sequence random",
                                         "--light cosine --sequence additive", "--light mis --sequence sobol",
                                         "--light mis --sequence random"};
    static Spread first;
    Agreement pools[5] = {{0}};
    for (int s = 0; s < 4; s++) {
        char scene[128], arguments[256];
        snprintf(scene, sizeof scene, "--spp 512 --sun %s", suns[s]);
        snprintf(arguments, sizeof arguments, "%s %s", scene, plain);
        render_seeds(arguments, 0, &first);
        for (int k = 0; k < 5; k++) compare_at(scene, plain, others[k], &first, &pools[k]);
    }
    for (int k = 0; k < 5; k++) expect_agreement(others[k], &pools[k], 4);
}

static void test_disk(void **state) {
    (void)state;
    static const char plain[] = "--light cosine --sequence random";
    static const char *const others[] = {"--light control --sequence sobol",
                                         "--light mis --sequence additive"};
    static Spread first;
    Agreement pools[2] = {{0}};
    for (int s = 0; s < 4; s++) {
        char scene[128], arguments[256];
        snprintf(scene, sizeof scene, "--spp 512 --sun-disk --sun %s", suns[s]);
        snprintf(arguments, sizeof arguments, "%s %s", scene, plain);
        render_seeds(arguments, 0, &first);
        for (int k = 0; k < 2; k++) compare_at(scene, plain, others[k], &first, &pools[k]);
    }
    for (int k = 0; k < 2; k++) expect_agreement(others[k], &pools[k], 4);
}

/* A wide disk, found by the bounces alone: direct light, penumbrae, the caustic, the disk in the picture and
 * its image in the ball, with nothing of what seeks them. At 15 degrees noise is small enough for a test by
 * pixel. */
static void test_chance(void **state) {
    (void)state;
    static const char *const places[] = {"20", "50,180", "50,90"};
    static const char chance[] = "--sun-disk=chance --light cosine --sequence random";
    static const char *const others[] = {"--sun-disk=sampled --light cosine --sequence random",
                                         "--sun-disk=sampled --light control --sequence random"};
    static Spread first;
    Agreement pool = {0};
    for (int s = 0; s < 3; s++) {
        char scene[128], arguments[256];
        snprintf(scene, sizeof scene, "--spp 1024 --set sun.radius=25 --sun %s", places[s]);
        snprintf(arguments, sizeof arguments, "%s %s", scene, chance);
        render_seeds(arguments, 0, &first);
        compare_at(scene, chance, others[s % 2], &first, &pool);
    }
    expect_agreement("chance", &pool, 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sky),
        cmocka_unit_test(test_disk),
        cmocka_unit_test(test_chance),
    };
    return cmocka_run_group_tests_name("estimators", tests, support_folder, support_clean);
}
