/* `magichour chart`: fronts and slopes of known points, drawings, the CSV that a chart is resumed from, and
 * small charts of a small scene. */
#include "support.h"

#include "base/file.h"
#include "base/memory.h"
#include "chart/chart_further.h"
#include "chart/ledger.h"
#include "chart/pareto.h"
#include "chart/plot_axis.h"
#include "chart/plot_write.h"
#include "chart/reference.h"
#include "chart/sky_error.h"
#include "chart/slope.h"
#include "sky/sky_probe.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Two curves that cross at (4, 4): each is the front on its side. */
static void test_front(void **state) {
    (void)state;
    const ParetoPoint steep[] = {{2, 16}, {4, 4}, {8, 1}}, flat[] = {{1, 8}, {4, 4}, {16, 2}};
    const ParetoCurve curves[] = {{steep, 3}, {flat, 3}};
    ParetoPoint front[31];
    assert_true(fabs(pareto_seconds(&curves[0], 8) - 2 * sqrt(2)) < 1e-9);
    assert_true(pareto_seconds(&curves[0], 20) == 2);
    assert_true(isinf(pareto_seconds(&curves[0], 0.5)));
    int count = pareto_front(curves, 2, front, 31);
    assert_int_equal(count, 31);
    assert_true(fabs(front[0].percent - 8) < 1e-6 && front[0].seconds == 1);
    assert_true(fabs(front[30].percent - 1) < 1e-6 && fabs(front[30].seconds - 8) < 1e-6);
    for (int i = 0; i < count; i++) {
        double percent = front[i].percent;
        double expected = percent > 4 ? pow(8 / percent, 2) : 4 * sqrt(4 / percent);
        if (fabs(front[i].seconds / expected - 1) > 1e-6)
            fail_msg("%g %%: %g, not %g", percent, front[i].seconds, expected);
    }
    assert_int_equal(pareto_front(curves, 0, front, 31), 0);
}

static void test_slope(void **state) {
    (void)state;
    const double x[] = {1, 10, 100, 1000}, power[] = {3, 3 * sqrt(10), 30, 30 * sqrt(10)};
    const double line[] = {2, 22, 200, 2000};
    assert_true(fabs(slope_fit(x, power, 4) - 0.5) < 1e-12);
    assert_true(fabs(slope_fit(x, line, 4) - 1) < 0.02);
    /* 1.1 beside three of 1: off by 1.1^(3/4) - 1. */
    assert_true(fabs(slope_departure(x, line, 4) - (pow(1.1, 0.75) - 1)) < 1e-12);
    assert_true(isnan(slope_fit(x, power, 1)));
}

static void test_axis(void **state) {
    (void)state;
    PlotAxis axis = {0};
    PlotTick ticks[PLOT_TICKS];
    plot_axis_include(&axis, -1);
    plot_axis_include(&axis, INFINITY);
    plot_axis_include(&axis, 0.03);
    plot_axis_include(&axis, 3);
    plot_axis_finish(&axis);
    assert_true(fabs(axis.low - 0.02) < 1e-9 && fabs(axis.high - 5) < 1e-9);
    int count = plot_axis_ticks(&axis, ticks);
    assert_int_equal(count, 8 + 9 + 5);
    assert_string_equal(ticks[0].label, "0.02");
    assert_true(ticks[8].strong);
    assert_string_equal(ticks[8].label, "0.1");
    assert_true(fabs(plot_axis_at(&axis, 1) - log(50) / log(250)) < 1e-9);
}

static void read_text(const char *path, Text *text) {
    Error error;
    if (!file_read(path, STATUS_FAILURE, text, &error)) fail_msg("%s", error.text);
    text_append(text, "", 0);
}

/* Both files are whole, of the size that they say, and bear what was drawn: nothing else makes them differ.
 */
static void test_plot(void **state) {
    (void)state;
    Plot *plot = memory_get(1, sizeof *plot);
    Error error;
    Text svg = {0}, empty = {0}, png = {0};
    PlotPanel *panel = &plot->panels[plot->panel_count++];
    assert_true(plot_write(plot, support_path("empty"), &error));
    PlotSeries *series = plot_add_series(panel, 0, PLOT_DOT, PLOT_DASHED, "a < b & c");
    for (int i = 0; i < 2 * PLOT_POINTS; i++) plot_add_point(series, i, 1 / (i + 1.0));
    assert_int_equal(series->count, PLOT_POINTS); /* none at 0, none past the room */
    panel->ring = series->points[3];
    snprintf(panel->ring_label, sizeof panel->ring_label, "here");
    if (!plot_write(plot, support_path("plot"), &error)) fail_msg("%s", error.text);
    read_text(support_path("plot.svg"), &svg);
    read_text(support_path("empty.svg"), &empty);
    read_text(support_path("plot.png"), &png);
    assert_non_null(strstr(svg.data, "<svg "));
    assert_non_null(strstr(svg.data, "</svg>"));
    assert_true(svg.size > empty.size + 1000);
    assert_memory_equal(png.data, "\x89PNG\r\n\x1a\n", 8);
    assert_int_equal((unsigned char)png.data[18] << 8 | (unsigned char)png.data[19], 1600);
    assert_memory_equal(png.data + png.size - 8, "IEND", 4);
    assert_false(plot_write(plot, "/none/plot", &error));
    assert_int_equal(error.status, STATUS_OUTPUT);
    free(plot);
    text_free(&svg);
    text_free(&empty);
    text_free(&png);
}

/* Rows outlive the program; half a row does not; rows of another identity are set aside. */
static void test_ledger(void **state) {
    (void)state;
    Ledger ledger;
    Error error;
    Text said = {0};
    const char *path = support_path("ledger.csv");
    LedgerRow a = {.words = {"a", "b"}, .numbers = {1, 0.25}},
              b = {.words = {"c", "d"}, .numbers = {2, 1e-9}};
    assert_true(ledger_open(&ledger, path, "# one\n# two\n", 2, "x,y,n,m", &said, &error));
    assert_true(ledger_add(&ledger, &a, &error) && ledger_add(&ledger, &b, &error));
    assert_true(ledger_add(&ledger, &a, &error));
    ledger_close(&ledger);
    FILE *file = fopen(path, "ab");
    fputs("e,f,3,0.", file);
    fclose(file);
    assert_true(ledger_open(&ledger, path, "# one\n# two\n", 2, "x,y,n,m", &said, &error));
    assert_int_equal(ledger.count, 3);
    assert_true(ledger_same(&ledger, &ledger.rows[1], &b) && ledger.rows[1].numbers[1] == 1e-9);
    assert_true(ledger_drop(&ledger, &a, &error));
    ledger_close(&ledger);
    assert_true(ledger_open(&ledger, path, "# one\n# two\n", 2, "x,y,n,m", &said, &error));
    assert_int_equal(ledger.count, 1);
    assert_int_equal(said.size, 0);
    ledger_close(&ledger);
    assert_true(ledger_open(&ledger, path, "# one\n# three\n", 2, "x,y,n,m", &said, &error));
    assert_int_equal(ledger.count, 0);
    assert_non_null(strstr(text_string(&said), "its line '# two' is '# three' now: set aside as "));
    ledger_close(&ledger);
    assert_int_equal(access(support_path("ledger.csv.old"), F_OK), 0);
    text_free(&said);
}

/* An estimate of its own noise that is right: two references by other seeds differ by it. */
static void test_reference(void **state) {
    (void)state;
    Context context;
    Scene scene;
    Error error;
    Reference reference;
    support_open(&context);
    assert_true(scene_read(&scene, "scenes/crater.glsl", "glsl", &error));
    RenderParams params = {.scene = &scene, .width = 24, .height = 24};
    const Monitor monitor = {0};
    const char *path = support_path("reference.exr");
    if (!reference_get(&reference, path, "one", &context, &params, 1, &monitor, &error))
        fail_msg("%s", error.text);
    assert_false(reference.kept);
    assert_true(reference.noise[NOISE_RADIANCE] > 0 && reference.noise[NOISE_RADIANCE] < 3);
    double percent;
    assert_true(reference_error(&reference, &reference.image, NOISE_RADIANCE, &percent, &error));
    assert_true(percent == 0); /* less than its own noise is none */
    double noise = reference.noise[NOISE_RADIANCE];
    reference_free(&reference);
    assert_true(reference_get(&reference, path, "one", &context, &params, 1, &monitor, &error));
    assert_true(reference.kept && fabs(reference.noise[NOISE_RADIANCE] / noise - 1) < 1e-4);
    reference_free(&reference);
    assert_true(reference_get(&reference, path, "two", &context, &params, 0.2, &monitor, &error));
    assert_false(reference.kept);
    reference_free(&reference);
    scene_destroy(&scene);
    context_close(&context);
}

static void test_sky_error(void **state) {
    (void)state;
    const float radiances[8] = {1.01F, 2, 3, 1, 4, 5, 0, 1};
    const double truth[6] = {1, 2, 3, 4, 5, 0};
    SkyError error = sky_error(radiances, truth, 2);
    assert_true(fabs(error.largest - 1) < 1e-4 && fabs(error.p99 - 1) < 1e-4);
    assert_true(fabs(error.rms - sqrt(1.0 / 6)) < 1e-4);
}

enum { FURTHER_DIRECTIONS = 16 };

/* The points of the further orders' qualities. The best of them stands for the truth here, as the reference
 * takes too long for a test. */
static void test_further(void **state) {
    (void)state;
    Context context;
    Scene scene;
    Error error;
    MethodChoice sky;
    SkyProbe probe;
    Text said = {0}, csv = {0};
    float directions[4 * FURTHER_DIRECTIONS], radiances[4 * FURTHER_DIRECTIONS];
    double truth[3 * FURTHER_DIRECTIONS], seconds[3], rms[3];
    support_open(&context);
    assert_true(scene_read(&scene, "scenes/crater.glsl", "glsl", &error));
    scene.values.atmosphere.orders = INFINITY;
    SkyState air = {scene.values.atmosphere, scene.values.sun};
    for (int i = 0; i < FURTHER_DIRECTIONS; i++) {
        double up = (i + 0.5) / FURTHER_DIRECTIONS, level = sqrt(1 - up * up);
        directions[4 * i] = (float)(level * sin(i));
        directions[4 * i + 1] = (float)up;
        directions[4 * i + 2] = (float)(level * cos(i));
        directions[4 * i + 3] = 0;
    }
    assert_true(method_choose(&sky, METHOD_SKY, REFERENCE_SKY, &error));
    assert_true(sky_probe_create(&probe, &context, scene.file->sources, &sky, &air.atmosphere, &error));
    assert_true(method_choose(&probe.further, METHOD_FURTHER, "harmonics:14", &error));
    assert_true(sky_probe_ask(&probe, &air, directions, FURTHER_DIRECTIONS, radiances, &error));
    for (int i = 0; i < 3 * FURTHER_DIRECTIONS; i++) truth[i] = (double)radiances[4 * (i / 3) + i % 3];
    sky_probe_destroy(&probe);
    ChartParams params = {.context = &context,
                          .picture = {.scene = &scene},
                          .folder = support_path("."),
                          .identity = "# test\n",
                          .said = &said};
    if (!chart_further(&params, &air, directions, truth, FURTHER_DIRECTIONS, &error))
        fail_msg("%s", error.text);
    assert_non_null(strstr(text_string(&said), "further.csv"));
    assert_int_equal(access(support_path("further.svg"), F_OK), 0);
    assert_int_equal(access(support_path("further.png"), F_OK), 0);
    read_text(support_path("further.csv"), &csv);
    static const char *const rows[3] = {"harmonics:8,", "harmonics:10,", "harmonics:14,"};
    for (int i = 0; i < 3; i++) {
        const char *row = strstr(csv.data, rows[i]);
        if (!row || sscanf(row + strlen(rows[i]), "%lf,%lf", &seconds[i], &rms[i]) != 2)
            fail_msg("no %s in %s", rows[i], csv.data);
    }
    if (!(rms[0] > rms[1] && rms[1] > rms[2] && rms[0] < 1 && rms[2] < 1e-4))
        fail_msg("%g %g %g", rms[0], rms[1], rms[2]);
    assert_true(seconds[0] > 0 && seconds[2] > seconds[0]);
    text_free(&said);
    text_free(&csv);
    scene_destroy(&scene);
    context_close(&context);
}

static int count_lines(const char *path) {
    Text text = {0};
    int lines = 0;
    read_text(path, &text);
    for (const char *c = text.data; *c; c++) lines += *c == '\n' && c > text.data && text.data[0] == '#';
    text_free(&text);
    return lines;
}

static void remove_charts(void) {
    char command[512];
    snprintf(command, sizeof command, "rm -rf '%s'", support_path("charts"));
    assert_int_equal(system(command), 0);
}

/* Charts of the crater at 16x16: files there, rows whole, and a second run that measures nothing. */
static void test_charts(void **state) {
    (void)state;
    const char *folder = support_path("charts");
    const char *arguments = "chart scenes/crater.glsl -o '%s' --size 16x16 --time 1.5 --charts paths,sky";
    support_expect(0, "", arguments, folder);
    assert_non_null(strstr(support_out, "reference: relRMSE "));
    assert_non_null(strstr(support_out, "\nauto, "));
    static const char *const names[] = {"paths.csv", "paths.svg", "paths.png", "reference.exr",
                                        "sky.csv",   "sky.svg",   "sky.png"};
    for (int i = 0; i < 7; i++) {
        char path[512];
        snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        if (access(path, F_OK) != 0) fail_msg("no %s", path);
    }
    char paths[512], sky[512];
    snprintf(paths, sizeof paths, "%s/paths.csv", folder);
    snprintf(sky, sizeof sky, "%s/sky.csv", folder);
    Text before = {0}, after = {0};
    read_text(paths, &before);
    static const char *const rows[] = {",mis,sobol,even,off,1,",
                                       "\ngauss:12,cosine,sobol,even,off,1,",
                                       "\npaper:64x16,cosine,sobol,even,off,1,",
                                       ",control,random,even,off,1,",
                                       ",control,metropolis,even,off,1,",
                                       ",cosine,sobol,adaptive,"};
    for (int i = 0; i < 6; i++) {
        if (!strstr(before.data, rows[i])) fail_msg("no %s in %s", rows[i], before.data);
    }
    assert_true(count_lines(sky) > 15);
    support_expect(0, "", arguments, folder);
    assert_non_null(strstr(support_out, "kept from before"));
    assert_null(strstr(support_out, "set aside"));
    read_text(paths, &after);
    assert_string_equal(before.data, after.data);
    text_free(&after);
    text_free(&before);

    /* Levels are in files of their own, by the same reference. */
    support_expect(0, "",
                   "chart scenes/crater.glsl -o '%s' --size 16x16 --time 1.5 --charts paths --error 2levels",
                   folder);
    assert_non_null(strstr(support_out, "reference: RMS "));
    assert_non_null(strstr(support_out, "kept from before"));
    assert_true(strstr(support_out, " levels in ") ||
                strstr(support_out, " levels, the least measured, in "));
    assert_non_null(strstr(support_out, "/paths-levels.csv"));
    assert_true(strstr(support_out, "/paths-levels.png") && access(paths, F_OK) == 0);

    /* Another sun is another chart. */
    support_expect(0, "", "chart scenes/crater.glsl -o '%s' --sun 5 --time 0.5 --charts sky", folder);
    assert_non_null(strstr(support_out, "sky.csv: its line '# sun 30,0' is '# sun 5,0' now: set aside"));
    remove_charts();
}

/* Points of other programs stand in the chart under their names, and do not change what is measured. A scene
 * whose sunlight is traced has curves of `sampled` too. */
static void test_points(void **state) {
    (void)state;
    const char *folder = support_path("charts");
    const char *points = support_write(
        "points.csv",
        "# comment\nprogram,seconds,percent\nOther 1.0 path,0.5,9\nOther 1.0 path,2,4\nthe paper,1,30\n");
    support_expect(0, "",
                   "chart tests/data/glass.glsl -o '%s' --size 12x12 --time 1.5 --charts paths --points '%s'",
                   folder, points);
    char path[512];
    Text svg = {0}, csv = {0};
    snprintf(path, sizeof path, "%s/paths.svg", folder);
    read_text(path, &svg);
    snprintf(path, sizeof path, "%s/paths.csv", folder);
    read_text(path, &csv);
    assert_non_null(strstr(csv.data, ",cosine,sobol,even,sampled,1,"));
    assert_non_null(strstr(csv.data, ",cosine,sobol,even,traced,1,"));
    assert_null(strstr(csv.data, "Other"));
    size_t with = svg.size;
    text_free(&svg);
    support_expect(0, "", "chart tests/data/glass.glsl -o '%s' --size 12x12 --time 1.5 --charts paths",
                   folder);
    snprintf(path, sizeof path, "%s/paths.svg", folder);
    read_text(path, &svg);
    assert_true(with > svg.size + 500);
    text_free(&svg);
    text_free(&csv);
    remove_charts();

    static const struct {
        const char *text, *error;
    } bad[] = {
        {"program,seconds\n", ":1: the first line is 'program,seconds', and not 'program,seconds,percent'"},
        {"program,seconds,percent\na,1\n", ":2: a row is program,seconds,percent"},
        {"program,seconds,percent\na,1,x\n", ":2: percent 'x' is not a number above 0"},
        {"program,seconds,percent\na,0,1\n", ":2: seconds '0' is not a number above 0"},
        {"program,seconds,percent\na,2,1\na,1,1\n", ":3: the points of a program are in the order of time"},
        {"program,seconds,percent\na,1,1\nb,1,1\nc,1,1\nd,1,1\ne,1,1\n", ":6: more than 4 programs"},
        {"program,seconds,percent\n", ": no points"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        support_expect(2, bad[i].error, "chart scenes/crater.glsl -o '%s' --points '%s'", folder,
                       support_write("points.csv", bad[i].text));
    support_expect(2, "points are in percent",
                   "chart scenes/crater.glsl -o '%s' --error 2levels --points '%s'", folder, points);
}

/* What Ctrl-C leaves is gone on with. */
static void test_interrupted(void **state) {
    (void)state;
    const char *program = getenv("MAGICHOUR"), *folder = support_path("charts");
    char command[2048];
    snprintf(
        command, sizeof command,
        "'%s' chart scenes/crater.glsl -o '%s' --size 16x16 --time 40 --charts scale --progress json "
        ">/dev/null 2>'%s' & until [ -s '%s' ]; do sleep 0.05; done; sleep 1; kill -INT $!; wait $!; exit $?",
        program ? program : "build/magichour", folder, support_path("interrupted"),
        support_path("interrupted"));
    assert_int_equal(WEXITSTATUS(system(command)), 130);
    Text said = {0};
    read_text(support_path("interrupted"), &said);
    assert_non_null(strstr(said.data, "the same command goes on"));
    text_free(&said);
    char path[512];
    snprintf(path, sizeof path, "%s/scale.csv", folder);
    assert_true(count_lines(path) >= 7); /* its head, at least */
    snprintf(path, sizeof path, "%s/field.glsl", folder);
    assert_int_not_equal(access(path, F_OK), 0);
    remove_charts();
}

static void test_usage(void **state) {
    (void)state;
    const char *folder = support_path("charts");
    support_expect(2, "where to? (-o DIR", "chart scenes/crater.glsl");
    support_expect(2, "--charts: unknown 'frob' (known: paths, sky, scale)",
                   "chart scenes/crater.glsl --charts sky,frob -o '%s'", folder);
    support_expect(3, "none.glsl: cannot be read", "chart none.glsl -o '%s'", folder);
    support_expect(5, "no folder can be made there", "chart scenes/crater.glsl -o /none/charts");
    support_expect(5, "no folder can be made there: File exists", "chart scenes/crater.glsl -o '%s'",
                   support_write("file", "x"));
    support_expect(2, "each side must be from 1", "chart scenes/crater.glsl --size 99999x1 -o '%s'", folder);
    const char *bad = support_write("bad.glsl", "//@ frob\n");
    support_expect(3, "bad.glsl:1: unknown annotation", "chart '%s' -o '%s'", bad, folder);
    assert_int_not_equal(access(folder, F_OK), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_front),     cmocka_unit_test(test_slope),   cmocka_unit_test(test_axis),
        cmocka_unit_test(test_plot),      cmocka_unit_test(test_ledger),  cmocka_unit_test(test_reference),
        cmocka_unit_test(test_sky_error), cmocka_unit_test(test_further), cmocka_unit_test(test_usage),
        cmocka_unit_test(test_charts),    cmocka_unit_test(test_points),  cmocka_unit_test(test_interrupted),
    };
    return cmocka_run_group_tests_name("chart", tests, support_folder, support_clean);
}
