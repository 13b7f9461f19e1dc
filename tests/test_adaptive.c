/* What the renderer says about its own error: the estimate against errors that are known, and what adaptive
 * sampling spends. */
#include "support.h"

#include "base/memory.h"
#include "error/adaptive.h"
#include "error/noise_figures.h"
#include "image/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double uniform_number(uint64_t *state) {
    *state = *state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(*state >> 11) * 0x1p-53;
}

/* About normal, of variance 1. */
static double normal_number(uint64_t *state) {
    double sum = -6;
    for (int i = 0; i < 12; i++) sum += uniform_number(state);
    return sum;
}

/* A mean of 1 whose errors fall as samples^-(power / 2), level by level as exchangeable halves have it: what
 * a doubling takes off is independent of what is left. Gives the estimate over the true error. */
static double estimate_ratio(double power, uint64_t seed) {
    enum { SIDE = 96, LEVELS = 12 };
    Noise noise = noise_create(SIDE, SIDE, NULL);
    Image mean = image_create(SIDE, SIDE);
    double true_error = 0;
    static double errors[3 * SIDE * SIDE];
    /* From the last level to the first: the error before a doubling is the one after it and what the doubling
       will take off. */
    static double history[LEVELS][3 * SIDE * SIDE];
    memset(errors, 0, sizeof errors);
    for (int level = LEVELS - 1; level >= 0; level--) {
        double after = level == LEVELS - 1 ? 0 : pow(2, -power * (level + 1)), now = pow(2, -power * level);
        for (int i = 0; i < 3 * SIDE * SIDE; i++) {
            /* The left half is ten times as noisy as the right. */
            double scale = i / 3 % SIDE < SIDE / 2 ? 0.1 : 0.01;
            errors[i] += scale * sqrt(now - after) * normal_number(&seed);
            history[level][i] = errors[i];
        }
    }
    for (int level = 0; level < 6; level++) {
        for (int i = 0; i < noise.columns * noise.rows; i++) noise.tiles[i].samples = (uint64_t)4 << level;
        for (int i = 0; i < 3 * SIDE * SIDE; i++)
            mean.rgba[4 * (i / 3) + i % 3] = (float)(1 + history[level][i]);
        noise_measure(&noise, &(NoisePicture){.mean = &mean});
        if (level == 0) assert_true(isinf(noise_error(&noise, NOISE_RADIANCE)));
    }
    for (int i = 0; i < 3 * SIDE * SIDE; i++) true_error += history[5][i] * history[5][i];
    double ratio = noise_error(&noise, NOISE_RADIANCE) / (100 * sqrt(true_error / (3 * SIDE * SIDE)));
    image_free(&mean);
    noise_destroy(&noise);
    return ratio;
}

static void test_estimate(void **state) {
    (void)state;
    double independent = estimate_ratio(1, 1), sequence = estimate_ratio(1.3, 2);
    print_message("estimated over true error: %.3f independent, %.3f falling as n^-1.3\n", independent,
                  sequence);
    assert_true(independent > 1.0 && independent < 1.1);
    assert_true(sequence > 1.0 && sequence < 1.25);
}

/* Draws a grey picture of 0.2, or its next doubling. Its pixels err by 0.01 at 16 samples, those of the first
 * tile by `first` times as much. `sun` pixels are as bright as the sun and err as much. */
static void draw(Image *mean, int level, int sun, double first, uint64_t *seed) {
    for (int i = 0; i < mean->width * mean->height; i++) {
        bool in_first = i / mean->width < NOISE_TILE && i % mean->width < NOISE_TILE;
        double half = 0.01 * pow(2, -0.5 * fmax(level - 1, 0)) * normal_number(seed) * (in_first ? first : 1);
        double before = (double)mean->rgba[4 * i] - 0.2, error = level ? 0.5 * (before + half) : half;
        for (int c = 0; c < 3; c++)
            mean->rgba[4 * i + c] = (float)(i < sun ? 1e4 * (1 + level % 2) : 0.2 + error);
    }
}

static void measure(Noise *noise, const Image *mean, int level) {
    for (int i = 0; i < noise->columns * noise->rows; i++) noise->tiles[i].samples = (uint64_t)16 << level;
    noise_measure(noise, &(NoisePicture){.mean = mean});
}

/* The pixels of the sun's own image are left out of the error and of the mean alike. If they are all pixels,
 * none is left out. */
static void test_left_out(void **state) {
    (void)state;
    enum { SIDE = 64, SUN = 5 };
    Noise noise = noise_create(SIDE, SIDE, NULL), plain = noise_create(SIDE, SIDE, NULL);
    Image mean = image_create(SIDE, SIDE);
    unsigned char mask[SIDE * SIDE] = {0};
    float variance[3 * SIDE * SIDE];
    uint64_t seed = 5;
    memset(mask, 1, SUN);
    noise_leave_out(&noise, mask);
    assert_true(noise.counted == SIDE * SIDE - SUN && noise.tiles[0].counted == 256 - SUN);
    for (int level = 0; level < 4; level++) {
        draw(&mean, level, SUN, 1, &seed);
        measure(&noise, &mean, level);
        measure(&plain, &mean, level);
    }
    double error = noise_error(&noise, NOISE_RADIANCE);
    print_message("%.3f %% without the sun, %.3f %% with it\n", error, noise_error(&plain, NOISE_RADIANCE));
    assert_true(error > 1.3 && error < 2.5 && fabs(noise.mean - 0.2) < 1e-3);
    assert_true(noise_error(&plain, NOISE_RADIANCE) > 100);
    for (int i = 0; i < 3 * SIDE * SIDE; i++) variance[i] = i < 3 * SUN ? 1e6F : 2;
    noise_calibrate(&noise, variance);
    assert_true(variance[0] == 1e6F && variance[3 * SUN] < 1e-4F);
    memset(mask, 1, sizeof mask);
    noise_leave_out(&noise, mask);
    assert_true(noise.counted == SIDE * SIDE - SUN);
    image_free(&mean);
    noise_destroy(&noise);
    noise_destroy(&plain);
}

/* In levels, the picture's figure and its worst tile's agree with what `compare` measures against the truth.
 */
static void test_levels(void **state) {
    (void)state;
    enum { SIDE = 64 };
    ToneTable tone = tone_table(TONE_AUTHOR, 1);
    Noise noise = noise_create(SIDE, SIDE, &tone);
    Image mean = image_create(SIDE, SIDE), truth = image_create(SIDE, SIDE);
    unsigned char compared[SIDE * SIDE];
    uint64_t seed = 8;
    double rms, worst;
    memset(compared, 1, sizeof compared);
    for (int i = 0; i < 4 * SIDE * SIDE; i++) truth.rgba[i] = 0.2F;
    for (int level = 0; level < 4; level++) {
        draw(&mean, level, 0, 5, &seed);
        measure(&noise, &mean, level);
        noise_levels(&noise, &rms, &worst);
        assert_true(isinf(rms) == (level == 0));
    }
    Levels levels = levels_compare(&mean, &truth, compared, TONE_AUTHOR, 0);
    print_message("RMS %.3f levels of %.3f, worst tile %.3f of %.3f\n", rms, levels.rms, worst,
                  levels.worst_tile);
    assert_true(rms > 0.95 * levels.rms && rms < 1.25 * levels.rms);
    assert_true(worst > 0.9 * levels.worst_tile && worst < 1.3 * levels.worst_tile);
    assert_true(noise_error(&noise, NOISE_LEVELS) == fmax(rms, worst / 2));
    /* Shown otherwise, it is not known until the picture was measured twice. */
    noise_show(&noise, 2);
    for (int level = 4; level < 6; level++) {
        assert_true(isinf(noise_error(&noise, NOISE_LEVELS)));
        draw(&mean, level, 0, 5, &seed);
        measure(&noise, &mean, level);
    }
    assert_true(noise_error(&noise, NOISE_LEVELS) < INFINITY);
    image_free(&mean);
    image_free(&truth);
    noise_destroy(&noise);
}

typedef struct Bench {
    Context context;
    Scene scene;
    Renderer renderer;
} Bench;

static void bench_open(Bench *bench, const char *sequence, int size, unsigned seed) {
    Error error;
    support_open(&bench->context);
    RenderParams params = {
        .scene = &bench->scene, .sequence = sequence, .width = size, .height = size, .seed = seed};
    if (!scene_read(&bench->scene, "scenes/crater.glsl", "glsl", &error) ||
        !renderer_create(&bench->renderer, &bench->context, &params, &error)) {
        fail_msg("%s", error.text);
    }
}

static void bench_close(Bench *bench) {
    renderer_destroy(&bench->renderer);
    scene_destroy(&bench->scene);
    context_close(&bench->context);
}

static Image read_film(const Renderer *renderer) {
    Image image;
    FilmCount count;
    Error error;
    assert_true(film_read(&renderer->film, &image, &count, &error));
    return image;
}

/* The same scene with so many samples everywhere. */
static Image even_picture(Bench *bench, uint64_t samples) {
    Error error;
    film_reset(&bench->renderer.film);
    while (bench->renderer.film.samples < samples)
        assert_true(renderer_pass(&bench->renderer, samples - bench->renderer.film.samples, NULL, &error));
    return read_film(&bench->renderer);
}

static double relrmse(const Image *a, const Image *b) {
    Comparison result;
    Error error;
    assert_true(compare_images(a, b, NULL, &result, &error));
    return result.rel_rmse_percent;
}

/* A picture to 1.2 %: it is, it says so, with fewer paths than an even one, and each tile is what an even
 * picture of its number of samples has there. */
static void test_adaptive(void **state) {
    (void)state;
    enum { SIZE = 128, REFERENCE = 2048 };
    Bench bench;
    Error error;
    bench_open(&bench, "sobol", SIZE, 3);
    Adaptive adaptive = adaptive_create(&bench.renderer, NOISE_RADIANCE, NULL);
    assert_true(isinf(adaptive_error(&adaptive, NOISE_RADIANCE)));
    while (!(adaptive_error(&adaptive, NOISE_RADIANCE) <= 1.2)) {
        assert_true(adaptive.rounds < 20 && adaptive_round(&adaptive, &bench.renderer, 1.2, NULL, &error));
    }
    Image picture = read_film(&bench.renderer);
    uint64_t paths = 0;
    float *samples = memory_get(SIZE * SIZE, sizeof *samples);
    assert_true(film_read_samples(&bench.renderer.film, samples, &error));
    for (int i = 0; i < SIZE * SIZE; i++) {
        const NoiseTile *tile =
            &adaptive.noise.tiles[i / SIZE / NOISE_TILE * adaptive.noise.columns + i % SIZE / NOISE_TILE];
        assert_true(samples[i] == (float)tile->samples);
        paths += (uint64_t)samples[i];
    }
    free(samples);
    assert_true(paths == adaptive.paths && adaptive.least == 8 && adaptive.most > 16);
    for (uint64_t n = adaptive.least; n <= adaptive.most; n *= 2) {
        Image even = even_picture(&bench, n);
        for (int i = 0; i < SIZE * SIZE; i++) {
            const NoiseTile *tile =
                &adaptive.noise.tiles[i / SIZE / NOISE_TILE * adaptive.noise.columns + i % SIZE / NOISE_TILE];
            for (int c = 0; tile->samples == n && c < 3; c++)
                assert_true(fabsf(picture.rgba[4 * i + c] - even.rgba[4 * i + c]) <=
                            1e-5f * even.rgba[4 * i + c]);
        }
        image_free(&even);
    }
    bench.renderer.seed = 77;
    program_use(&bench.renderer.program);
    program_set_uint(&bench.renderer.program, "seed", 77);
    Image reference = even_picture(&bench, REFERENCE), even = even_picture(&bench, paths / (SIZE * SIZE));
    double error_percent = relrmse(&picture, &reference), even_percent = relrmse(&even, &reference);
    print_message("%.1f samples (%d to %d): %.3f %% estimated, %.3f %% true; as many everywhere: %.3f %%\n",
                  (double)paths / (SIZE * SIZE), (int)adaptive.least, (int)adaptive.most,
                  adaptive_error(&adaptive, NOISE_RADIANCE), error_percent, even_percent);
    assert_true(error_percent < 1.2 && error_percent > 0.6);
    assert_true(error_percent < 0.85 * even_percent);
    image_free(&picture);
    image_free(&reference);
    image_free(&even);
    adaptive_destroy(&adaptive);
    bench_close(&bench);
}

static bool yes(void) {
    return true;
}

/* Stopped or out of time, nothing is lost and the books are right. */
static void test_stopped(void **state) {
    (void)state;
    enum { SIZE = 64 };
    Bench bench;
    Error error;
    bench_open(&bench, "sobol", SIZE, 0);
    Adaptive adaptive = adaptive_create(&bench.renderer, NOISE_RADIANCE, NULL);
    for (int i = 0; i < 4; i++) {
        /* 4 and 8 samples tell too little. */
        assert_true(isinf(adaptive_error(&adaptive, NOISE_RADIANCE)) == (i < 3));
        assert_true(adaptive_round(&adaptive, &bench.renderer, 0.5, NULL, &error));
    }
    double before = adaptive_error(&adaptive, NOISE_RADIANCE);
    uint64_t paths = adaptive.paths;
    /* Whether a draw is one piece, in which nobody asks, or many. */
    for (int i = 0; i < 2; i++) {
        pace_set(&bench.renderer.pace, SIZE, SIZE, i ? 1 : 1e-12);
        assert_true(adaptive_round(&adaptive, &bench.renderer, 0.1, yes, &error));
        assert_true(adaptive.paths == paths && adaptive_error(&adaptive, NOISE_RADIANCE) == before);
    }
    adaptive.deadline = 0;
    assert_true(adaptive_round(&adaptive, &bench.renderer, 0.1, NULL, &error));
    assert_true(adaptive.paths == paths);
    Image picture = read_film(&bench.renderer);
    for (int i = 0; i < SIZE * SIZE; i++) assert_true(picture.rgba[4 * i + 3] == 1);
    image_free(&picture);
    adaptive_destroy(&adaptive);
    bench_close(&bench);
}

/* Where no tile is worth a doubling, or none may have one, the rounds say that they lead nowhere. */
static void test_ends(void **state) {
    (void)state;
    Bench bench;
    Error error;
    bench_open(&bench, "sobol", 32, 0);
    Adaptive adaptive = adaptive_create(&bench.renderer, NOISE_RADIANCE, NULL);
    for (int i = 0; i < 5; i++) assert_true(adaptive_round(&adaptive, &bench.renderer, 0.5, NULL, &error));
    assert_int_equal(adaptive_end(&adaptive), ADAPTIVE_GOES_ON);
    uint64_t paths = adaptive.paths;
    for (int i = 0; i < 3; i++) {
        assert_int_equal(adaptive_end(&adaptive), ADAPTIVE_GOES_ON);
        /* A target that is reached already plans nothing. */
        assert_true(adaptive_round(&adaptive, &bench.renderer, 1e4, NULL, &error));
    }
    assert_int_equal(adaptive_end(&adaptive), ADAPTIVE_AIMLESS);
    assert_true(adaptive.paths > paths);
    for (int i = 0; i < adaptive.noise.columns * adaptive.noise.rows; i++)
        adaptive.noise.tiles[i].samples = (uint64_t)1 << 23;
    paths = adaptive.paths;
    /* A round that is stopped adds nothing either, but that is no end. */
    assert_true(adaptive_round(&adaptive, &bench.renderer, 0.5, yes, &error));
    assert_int_not_equal(adaptive_end(&adaptive), ADAPTIVE_FULL);
    assert_true(adaptive_round(&adaptive, &bench.renderer, 0.5, NULL, &error));
    assert_int_equal(adaptive_end(&adaptive), ADAPTIVE_FULL);
    assert_true(adaptive.paths == paths);
    adaptive_destroy(&adaptive);
    bench_close(&bench);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_estimate), cmocka_unit_test(test_left_out), cmocka_unit_test(test_levels),
        cmocka_unit_test(test_adaptive), cmocka_unit_test(test_stopped),  cmocka_unit_test(test_ends),
    };
    return cmocka_run_group_tests_name("adaptive", tests, support_folder, support_clean);
}
