/* How noisy each shipped scene is with the default methods, without the sun's disk and with it: a lost
 * optimisation leaves the mean as it is, and shows here. Run as `test_noise measure > tests/data/noise.csv`
 * it writes its table anew. */
#include "failed.h"
#include "scene_list.h"
#include "spread.h"
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The size and samples that the table is of, and the air: the paper's, which has no tables that take long. */
#define PICTURE "--size 48x36 --spp 64 --atmosphere simmons2017"

/* What is measured may be above the table by this factor, or below it: then the table is remade, so that it
 * stays sharp. Other seeds change the figures by less than a tenth. */
static const double margin = 1.15;

static const char table_path[] = "tests/data/noise.csv";

/* Disk options of the two rows of a scene. */
static const char *const disks[] = {"off", "auto"};

static int by_size(const void *a, const void *b) {
    double difference = *(const double *)a - *(const double *)b;
    return (difference > 0) - (difference < 0);
}

/* The noise of one picture in percent of its mean: the root of the mean variance, without the hundredth of
 * the values that varies most, which a few rare paths decide. */
static double noise_percent(const Spread *spread) {
    static double sorted[SPREAD_MOST_VALUES];
    int kept = spread->values - spread->values / 100;
    double variance = 0, mean = 0;
    memcpy(sorted, spread->variance, (size_t)spread->values * sizeof *sorted);
    qsort(sorted, (size_t)spread->values, sizeof *sorted, by_size);
    for (int i = 0; i < kept; i++) variance += SPREAD_SEEDS * sorted[i] / kept;
    for (int i = 0; i < spread->values; i++) mean += spread->mean[i] / spread->values;
    return 100 * sqrt(variance) / mean;
}

static double measure(const char *scene, const char *disk, const char *more, int seed, Spread *spread) {
    char arguments[256];
    snprintf(arguments, sizeof arguments, PICTURE " --sun-disk=%s%s", disk, more);
    spread_render(scene, arguments, seed, spread);
    return noise_percent(spread);
}

/* The table's percentage; fails the test where there is none. */
static double expected_percent(const char *scene, const char *disk) {
    char line[512], key[400];
    double percent = 0;
    FILE *file = fopen(table_path, "r");
    if (!file) fail_msg("%s cannot be read", table_path);
    int length = snprintf(key, sizeof key, "%s,%s,", scene, disk);
    while (fgets(line, sizeof line, file)) {
        if (strncmp(line, key, (size_t)length) == 0) percent = strtod(line + length, NULL);
    }
    fclose(file);
    if (!(percent > 0))
        fail_msg("%s, --sun-disk=%s: not in %s; run test_noise measure", scene, disk, table_path);
    return percent;
}

static void expect_picture(const Spread *spread, const char *scene, const char *disk) {
    double sum = 0;
    for (int i = 0; i < spread->values; i++) {
        if (!isfinite(spread->mean[i])) fail_msg("%s, --sun-disk=%s: a value is not finite", scene, disk);
        sum += spread->mean[i];
    }
    if (!(sum > 0)) fail_msg("%s, --sun-disk=%s: a black picture", scene, disk);
}

static void test_every_scene(void **state) {
    (void)state;
    static Spread spread;
    SceneList list = scene_list();
    int wrong = 0;
    assert_true(list.count > 15);
    for (int i = 0; i < 2 * list.count; i++) {
        const char *scene = list.paths[i / 2], *disk = disks[i % 2];
        double got = measure(scene, disk, "", 0, &spread), expected = expected_percent(scene, disk);
        bool ok = got < margin * expected && got > expected / margin;
        expect_picture(&spread, scene, disk);
        /* The table is of all the samples. */
        if (support_block() > 1) continue;
        print_message("%s, --sun-disk=%s: noise %.3f %%, expected %.3f %%%s\n", scene, disk, got, expected,
                      ok               ? ""
                      : got > expected ? ": WORSE"
                                       : ": BETTER, run test_noise measure");
        support_table("noise", "| %s | %s | %.3f %% | %.3f %% |", scene, disk, got, expected);
        wrong += !ok;
    }
    if (wrong) fail_msg("%d of %d pictures have another noise than in %s", wrong, 2 * list.count, table_path);
}

/* The bounds are sharp enough to see what they are for. */
static void test_lost_optimisation(void **state) {
    (void)state;
    static const char *const lost[][3] = {
        {"scenes/crater.glsl", "off", " --sequence random"},
        {"scenes/fences.glsl", "off", " --light cosine"},
        {"scenes/pillars.glsl", "off", " --light cosine"},
    };
    static Spread spread;
    if (support_block() > 1) skip();
    size_t seen = 0;
    for (size_t i = 0; i < sizeof lost / sizeof *lost; i++) {
        double expected = expected_percent(lost[i][0], lost[i][1]);
        double got = measure(lost[i][0], lost[i][1], lost[i][2], 0, &spread);
        print_message("%s%s: noise %.3f %%, %.2f of the table's\n", lost[i][0], lost[i][2], got,
                      got / expected);
        seen += got > margin * expected;
    }
    assert_int_equal(seen, sizeof lost / sizeof *lost);
}

/* A second run with other seeds goes to standard error: by how much chance changes the figures. */
static void write_table(void **state) {
    (void)state;
    static Spread spread;
    SceneList list = scene_list();
    printf("# Noise of " PICTURE
           " with the default methods: scene, --sun-disk, percent. Written by test_noise measure.\n");
    for (int i = 0; i < 2 * list.count; i++) {
        const char *scene = list.paths[i / 2], *disk = disks[i % 2];
        double percent = measure(scene, disk, "", 0, &spread), again = measure(scene, disk, "", 50, &spread);
        printf("%s,%s,%.4f\n", scene, disk, percent);
        fflush(stdout);
        fprintf(stderr, "%s,%s: other seeds %+.1f %%\n", scene, disk, 100 * (again / percent - 1));
    }
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_scene),
        cmocka_unit_test(test_lost_optimisation),
    };
    if (argc > 1 && strcmp(argv[1], "measure") == 0) {
        write_table(NULL);
        return 0;
    }
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    return cmocka_run_group_tests_name("noise", tests, support_folder, support_clean);
}
