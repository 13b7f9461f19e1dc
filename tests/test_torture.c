/* Random scenes with random settings (torture.h): no picture holds a value that is not finite, and none is
 * negative where it must not be.
 *
 * The light method `control` takes off the light that blockers hide and adds the light of the open sky, which
 * is known. A few samples that are blocked may take off more than there is, so that its estimate of a pixel
 * may be negative, although its expectation is not. So a negative pixel of `control` is judged by another
 * picture, of independent samples and at least sixteen times as many: its value there must not be below zero
 * by more than its standard error explains, neither in a pixel nor in all such pixels together. No other
 * method may bring anything negative.
 *
 * TORTURE=N makes the first N of the cases, 300 at most. CASE=N makes one. */
#include "support.h"

#include "image/read_params.h"
#include "torture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ALL = 300, USUAL = 40, JUDGE_SAMPLES = 256 };

/* In standard errors. They come from 16 groups of samples or more, and Student's t is beyond 6 in one of
 * 100,000 pixels. The sum of many pixels is near normal. */
static const double pixel_limit = 6, sum_limit = 4;

static const char *scene_path, *picture_path;

static Image read_layer(const char *path, const char *layer) {
    Image image;
    Error error;
    ImageReadParams params = {.layer = layer};
    if (!image_read_as(&image, path, &params, &error)) fail_msg("%s", error.text);
    return image;
}

static int count_broken(const Image *image, int *negative) {
    int broken = 0;
    *negative = 0;
    for (int i = 0; i < 4 * image->width * image->height; i++) {
        if (i % 4 == 3) continue;
        broken += !isfinite(image->rgba[i]);
        *negative += image->rgba[i] < 0;
    }
    return broken;
}

/* Judges the values that are negative in `picture`. Says how far below zero they are expected to be. */
static bool judge(const Torture *torture, const char *scene, uint32_t number, const Image *picture) {
    const char *out = picture_path;
    int samples = torture->samples * 16 > JUDGE_SAMPLES ? torture->samples * 16 : JUDGE_SAMPLES;
    const char *light = strstr(torture->options, "--light auto") ? "--light control" : "";
    double sum = 0, variances = 0, worst = 0;
    support_expect(0, "",
                   "render '%s' %s %s --sequence random --seed %u --spp %d --aov variance --quiet -o '%s'",
                   scene, torture->options, light, 5000 + number, samples, out);
    Image mean = read_layer(out, NULL), variance = read_layer(out, "variance");
    for (int i = 0; i < 4 * picture->width * picture->height; i++) {
        if (i % 4 == 3 || !(picture->rgba[i] < 0)) continue;
        double value = (double)mean.rgba[i], square = (double)variance.rgba[i];
        sum += value;
        variances += square;
        if (value < 0) worst = fmin(worst, value / sqrt(square));
    }
    image_free(&mean);
    image_free(&variance);
    double z = sum < 0 ? sum / sqrt(variances) : 0;
    print_message("case %u: negative values of %d samples come to %+.2g at %d, the worst to %.1f standard "
                  "errors below 0, all together to %.1f\n",
                  number, torture->samples, sum, samples, fabs(worst), fabs(z));
    return worst >= -pixel_limit && z >= -sum_limit;
}

/* Makes the case and says what is wrong with it. */
static bool make(uint32_t number) {
    static Torture torture;
    torture_make(&torture, number);
    const char *scene = scene_path, *out = picture_path;
    FILE *file = fopen(scene, "w");
    assert_non_null(file);
    fputs(torture.scene, file);
    fclose(file);
    int negative, status = support_run("", "render '%s' %s --spp %d --quiet -o '%s'", scene, torture.options,
                                       torture.samples, out);
    bool ok = status == 0;
    if (!ok) print_message("case %u: status %d: %s\n", number, status, support_err);
    if (!ok) return false;
    Image picture = read_layer(out, NULL);
    int broken = count_broken(&picture, &negative);
    if (broken) print_message("case %u: %d values are not finite\n", number, broken);
    ok = !broken;
    if (negative && !torture.may_control) {
        print_message("case %u: %d values are negative\n", number, negative);
        ok = false;
    } else if (negative) {
        ok &= judge(&torture, scene, number, &picture);
    }
    image_free(&picture);
    if (!ok)
        print_message("case %u: --spp %d %s\n%s\n", number, torture.samples, torture.options, torture.scene);
    return ok;
}

static void test_cases(void **state) {
    const char *wanted = getenv("TORTURE"), *one = getenv("CASE");
    int count = wanted ? atoi(wanted) : USUAL, first = one ? atoi(one) : 0, failed = 0;
    Context context;
    (void)state;
    support_open(&context);
    context_close(&context);
    if (one) count = first + 1;
    scene_path = support_path("case.glsl");
    picture_path = support_path("case.exr");
    assert_true(count > first && count <= ALL);
    for (int i = first; i < count; i++) failed += !make((uint32_t)i);
    print_message("%d cases, %d failed\n", count - first, failed);
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_cases)};
    return cmocka_run_group_tests_name("torture", tests, support_folder, support_clean);
}
