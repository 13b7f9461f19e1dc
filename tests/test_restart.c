/* renderer_restart() against renderer_create(): a renderer that was started anew, in any order of parameters,
 * makes the same picture to the bit as one that is new. */
#include "failed.h"
#include "support.h"

#include "render/renderer.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 24, HEIGHT = 18, SAMPLES = 32 };

/* What may differ between two starts; a row is chosen of each column by dice. */
static const char *const skies[] = {NULL, "gauss:6", "uniform:2"},
                         *const lights[] = {NULL, "cosine", "mis", "control"},
                         *const sequences[] = {NULL, "random"},
                         *const sun_disks[] = {"off", "sampled", "chance"};
static const int depths[] = {0, 0, 1, 3};
static const double elevations[] = {60, 5, -2};
static const char *const settings[][2] = {{"ball", "1"},
                                          {"ball", "0"},
                                          {"camera.fov", "40"},
                                          {"atmosphere.mie_g", "0.5"},
                                          {"atmosphere.ozone", "1e-6"},
                                          {"mist", "off"},
                                          {"density", "0.2"}};

static uint64_t dice_state = 7;

static size_t dice(size_t sides) {
    dice_state = dice_state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (size_t)(dice_state >> 33) % sides;
}

#define ONE_OF(array) array[dice(sizeof(array) / sizeof *(array))]

static RenderParams draw(Scene *scene, const Scene *original) {
    Error error;
    *scene = *original;
    const char *const *setting = ONE_OF(settings);
    double elevation = ONE_OF(elevations);
    scene_set_sun(scene, elevation, 10 * (double)dice(36));
    /* Not every scene has each of the settings. */
    if (!scene_set(scene, setting[0], setting[1], &error)) scene_set_sun(scene, elevation, 0);
    return (RenderParams){.scene = scene,

                          .sky = ONE_OF(skies),
                          .light = ONE_OF(lights),
                          .sequence = ONE_OF(sequences),
                          .sun_disk = ONE_OF(sun_disks),
                          .width = WIDTH + 8 * (int)dice(2),
                          .height = HEIGHT,
                          .seed = (unsigned)dice(3),
                          .max_hits = ONE_OF(depths),
                          .variance = dice(2)};
}

static void describe(const RenderParams *params, char *words, size_t size) {
    const Sun *sun = &params->scene->values.sun;
    snprintf(words, size,
             "sky %s, light %s, sequence %s, disk %s, sun %g,%g, depth %d, width %d, seed %u, variance %d",
             params->sky ? params->sky : "auto", params->light ? params->light : "auto",
             params->sequence ? params->sequence : "auto", params->sun_disk, sun->elevation_deg,
             sun->azimuth_deg, params->max_hits, params->width, params->seed, params->variance);
}

/* A picture, and its variance where that was asked for. */
typedef struct Result {
    Image image;
    float variance[3 * (WIDTH + 8) * HEIGHT];
} Result;

static void take(Renderer *renderer, bool variance, Result *result) {
    FilmCount count;
    Error error;
    memset(result, 0, sizeof *result);
    while (renderer->film.samples < SAMPLES) {
        if (!renderer_pass(renderer, SAMPLES - renderer->film.samples, NULL, &error))
            fail_msg("%s", error.text);
    }
    if (!film_read(&renderer->film, &result->image, &count, &error) ||
        (variance && !film_read_variance(&renderer->film, result->variance, &error))) {
        fail_msg("%s", error.text);
    }
}

static void expect_equal(const char *words, const Result *got, const Result *wanted) {
    size_t pixels = (size_t)wanted->image.width * HEIGHT;
    if (got->image.width == wanted->image.width &&
        memcmp(got->image.rgba, wanted->image.rgba, 4 * pixels * sizeof(float)) == 0 &&
        memcmp(got->variance, wanted->variance, sizeof got->variance) == 0)
        return;
    failed_keep("restart", &got->image, &wanted->image);
    fail_msg("started anew it differs: %s", words);
}

/* Every second time only values change, so that programs and tables are kept. */
static void keep_methods(RenderParams *params, const RenderParams *before) {
    params->sky = before->sky;
    params->light = before->light;
    params->sequence = before->sequence;
    params->sun_disk = before->sun_disk;
}

static void restart_often(const Context *context, const char *path, int rounds) {
    static Result got, wanted;
    Scene original, scene;
    Renderer again, fresh;
    Error error;
    char words[512];
    int compared = 0;
    if (!scene_read(&original, path, "glsl", &error)) fail_msg("%s", error.text);
    /* Whatever the scene's own is: the further orders of `earth` would take seconds at each start. */
    original.values.atmosphere = atmosphere_preset(0)->atmosphere;
    RenderParams before = {.scene = &original, .sun_disk = "off", .width = WIDTH, .height = HEIGHT};
    if (!renderer_create(&again, context, &before, &error)) fail_msg("%s", error.text);
    for (int i = 0; i < rounds; i++) {
        RenderParams params = draw(&scene, &original);
        if (i % 2) keep_methods(&params, &before);
        describe(&params, words, sizeof words);
        bool restarted = renderer_restart(&again, context, &params, &error);
        if (restarted) take(&again, params.variance, &got);
        bool created = renderer_create(&fresh, context, &params, &error);
        if (restarted != created) fail_msg("%s: %s", words, error.text);
        if (!created) continue;
        take(&fresh, params.variance, &wanted);
        renderer_destroy(&fresh);
        expect_equal(words, &got, &wanted);
        image_free(&got.image);
        image_free(&wanted.image);
        before = params;
        compared++;
    }
    print_message("%s: %d of %d starts compared\n", path, compared, rounds);
    assert_true(compared > rounds / 2);
    renderer_destroy(&again);
    scene_destroy(&original);
}

static void test_restart(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    restart_often(&context, "scenes/crater.glsl", 16);
    restart_often(&context, "scenes/spheres.glsl", 6);
    restart_often(&context, "scenes/shafts.glsl", 12);
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_restart)};
    return cmocka_run_group_tests_name("restart", tests, support_folder, support_clean);
}
