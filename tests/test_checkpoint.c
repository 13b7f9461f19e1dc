/* A render that is interrupted and goes on ends with the same bits. */
#include "support.h"

#include "base/archive.h"
#include "base/file.h"
#include "base/memory.h"
#include "error/adaptive.h"
#include "error/checkpoint.h"
#include "image/format.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static bool always(void) {
    return true;
}

/* One render: its renderer, and how its samples are taken. */
typedef struct Run {
    Context context;
    Scene scene;
    RenderParams params;
    Renderer renderer;
    Adaptive adaptive;
    /* Even samples if this is not 0, or else so many rounds toward an error that is out of reach. */
    uint64_t samples;
    int rounds;
} Run;

typedef struct Case {
    const char *scene, *sequence, *sun_disk;
    uint64_t samples;
    int rounds;
} Case;

static void run_begin(Run *run) {
    Error error;
    if (!renderer_create(&run->renderer, &run->context, &run->params, &error)) fail_msg("%s", error.text);
    run->adaptive = adaptive_create(&run->renderer, NOISE_RADIANCE, NULL);
}

static void run_end(Run *run) {
    adaptive_destroy(&run->adaptive);
    renderer_destroy(&run->renderer);
}

static bool run_step(Run *run) {
    Error error;
    Adaptive *adaptive = &run->adaptive;
    if (!adaptive->under_way) {
        bool enough =
            run->samples ? run->renderer.film.samples >= run->samples : adaptive->rounds >= run->rounds;
        if (enough) return false;
    }
    bool ok = run->samples ? adaptive_pass(adaptive, &run->renderer, run->samples, NULL, &error)
                           : adaptive_round(adaptive, &run->renderer, 0.1, NULL, &error);
    if (!ok) fail_msg("%s", error.text);
    return true;
}

/* Moves the state to a renderer that was made anew. */
static void run_move(Run *run) {
    Text bytes = {0};
    Error error;
    Archive save = {.out = &bytes};
    adaptive_archive(&run->adaptive, &save);
    assert_true(renderer_archive(&run->renderer, &save, &error));
    run_end(run);
    run_begin(run);
    Archive load = {.at = bytes.data, .end = bytes.data + bytes.size};
    adaptive_archive(&run->adaptive, &load);
    assert_true(renderer_archive(&run->renderer, &load, &error));
    assert_true(load.at == load.end && !load.torn);
    text_free(&bytes);
}

static Image read_picture(const Run *run) {
    Image image;
    FilmCount count;
    Error error;
    assert_true(film_read(&run->renderer.film, &image, &count, &error));
    return image;
}

/* After each group of samples the state goes to a new renderer, which knows nothing else. */
static void check_case(const Case *c) {
    enum { WIDTH = 48, HEIGHT = 32 };
    Run run = {.samples = c->samples, .rounds = c->rounds};
    Error error;
    support_open(&run.context);
    if (!scene_read(&run.scene, c->scene, "glsl", &error)) fail_msg("%s", error.text);
    run.params = (RenderParams){.scene = &run.scene,
                                .sequence = c->sequence,
                                .sun_disk = c->sun_disk,
                                .width = WIDTH,
                                .height = HEIGHT,
                                .samples = c->samples,
                                .variance = true};
    run_begin(&run);
    while (run_step(&run)) continue;
    Image whole = read_picture(&run);
    double noise = adaptive_error(&run.adaptive, NOISE_RADIANCE);
    int rounds = run.adaptive.rounds, moves = 0;
    run_end(&run);
    run_begin(&run);
    for (;;) {
        run.adaptive.pause = always;
        if (!run_step(&run)) break;
        run_move(&run);
        moves++;
    }
    Image moved = read_picture(&run);
    assert_true(moves >= rounds && moves > 1);
    assert_memory_equal(whole.rgba, moved.rgba, (size_t)WIDTH * HEIGHT * 4 * sizeof(float));
    double after = adaptive_error(&run.adaptive, NOISE_RADIANCE);
    assert_true(after == noise || (isinf(after) && isinf(noise)));
    assert_int_equal(run.adaptive.rounds, rounds);
    image_free(&whole);
    image_free(&moved);
    run_end(&run);
    scene_destroy(&run.scene);
    context_close(&run.context);
}

static void test_states(void **state) {
    (void)state;
    static const Case cases[] = {
        {"scenes/crater.glsl", NULL, NULL, 0, 6},
        {"scenes/crater.glsl", "random", "sampled", 100, 0},
        {"scenes/materials.glsl", NULL, "traced", 24, 0},
        {"scenes/materials.glsl", NULL, "traced", 0, 4},
        {"scenes/crater.glsl", "metropolis", NULL, 48, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) check_case(&cases[i]);
}

/* Starts the program and gives its process. */
static pid_t start(const char *arguments) {
    const char *program = getenv("MAGICHOUR");
    char command[4096];
    snprintf(command, sizeof command, "exec %s %s", program ? program : "build/magichour", arguments);
    pid_t child = fork();
    if (child == 0) {
        freopen("/dev/null", "w", stdout);
        freopen(support_path("said"), "w", stderr);
        execl("/bin/sh", "sh", "-c", command, (char *)NULL);
        _exit(127);
    }
    assert_true(child > 0);
    return child;
}

/* Waits for a file, for ten minutes at most. */
static void wait_for(const char *path) {
    for (int i = 0; i < 60000 && access(path, F_OK) != 0; i++) usleep(10000);
    assert_int_equal(access(path, F_OK), 0);
}

static void expect_same(const char *a, const char *b) {
    Text bytes[2] = {{0}};
    Error error;
    assert_true(file_read(a, STATUS_FAILURE, &bytes[0], &error) &&
                file_read(b, STATUS_FAILURE, &bytes[1], &error));
    assert_true(bytes[0].size == bytes[1].size && memcmp(bytes[0].data, bytes[1].data, bytes[0].size) == 0);
    text_free(&bytes[0]);
    text_free(&bytes[1]);
}

static char *paths_of(const char *format, const char *a, const char *b, const char *c) {
    char *line = memory_get(4096, 1);
    snprintf(line, 4096, format, a, b, c);
    return line;
}

static const char *const picture = "render scenes/crater.glsl --size 96x64 --error 0.4 --quiet";

/* Renders the picture that no interruption touches, once. */
static const char *whole_picture(void) {
    const char *whole = support_path("whole.pfm");
    if (access(whole, F_OK) != 0 && support_run("", "%s -o '%s'", picture, whole))
        fail_msg("%s", support_err);
    return whole;
}

static int signal_after(const char *checkpoint, const char *out, int number, unsigned microseconds) {
    char *line = paths_of("render scenes/crater.glsl --size 96x64 --error 0.4 --checkpoint '%s' "
                          "--checkpoint-every 0.01 -o '%s'%s",
                          checkpoint, out, "");
    int status;
    pid_t child = start(line);
    wait_for(checkpoint);
    usleep(microseconds);
    kill(child, number);
    assert_true(waitpid(child, &status, 0) == child);
    free(line);
    return status;
}

/* Killed, it goes on from the checkpoint; nothing else is left in the folder than the checkpoint and the one
 * before. */
static void test_killed(void **state) {
    (void)state;
    const char *whole = whole_picture(), *file = support_path("killed.state"),
               *out = support_path("killed.pfm");
    for (unsigned i = 0; i < 6; i++) {
        unlink(file);
        signal_after(file, out, i % 2 ? SIGTERM : SIGKILL, i * 30000);
        if (support_run("", "%s --resume '%s' -o '%s'", picture, file, out)) fail_msg("%s", support_err);
        expect_same(whole, out);
    }
}

/* Ctrl-C saves the picture and says how to go on; SIGUSR1 saves the picture so far, and nothing ends. */
static void test_signals(void **state) {
    (void)state;
    const char *file = support_path("signal.state"), *out = support_path("signal.pfm");
    Text said = {0};
    Error error;
    int status = signal_after(file, out, SIGINT, 50000);
    assert_true(WIFEXITED(status) && (WEXITSTATUS(status) == STATUS_INTERRUPTED || WEXITSTATUS(status) == 0));
    assert_int_equal(access(out, F_OK), 0);
    assert_true(file_read(support_path("said"), STATUS_FAILURE, &said, &error));
    if (WEXITSTATUS(status)) assert_non_null(strstr(text_string(&said), "to go on: "));
    text_free(&said);
    unlink(out);
    unlink(file);
    char *line = paths_of("render scenes/crater.glsl --size 96x64 --error 0.2 --checkpoint '%s' "
                          "--checkpoint-every 0.01 -o '%s'%s",
                          file, out, "");
    pid_t child = start(line);
    wait_for(file);
    kill(child, SIGUSR1);
    wait_for(out);
    assert_int_equal(waitpid(child, &status, WNOHANG), 0);
    assert_true(waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0);
    free(line);
}

/* Writes a copy of the checkpoint with one byte changed, or cut off there. */
static const char *damaged(const char *file, size_t at, bool cut) {
    Text bytes = {0};
    Error error;
    const char *path = support_path("damaged.state");
    assert_true(file_read(file, STATUS_FAILURE, &bytes, &error));
    at = at < bytes.size ? at : bytes.size - 1;
    if (!cut) bytes.data[at] ^= 1;
    assert_true(file_replace(path, bytes.data, cut ? at : bytes.size, &error));
    text_free(&bytes);
    return path;
}

/* What is refused, and with which words. */
static void test_refusals(void **state) {
    (void)state;
    const char *file = support_path("ok.state"), *scene = support_write("a.glsl", "");
    Text text = {0};
    Error error;
    assert_true(file_read("scenes/crater.glsl", STATUS_FAILURE, &text, &error));
    scene = support_write("a.glsl", text_string(&text));
    const char *out = support_path("out.pfm");
#define BASE "render '%s' --size 32x32 -o '%s' --quiet "
    if (support_run("", BASE "--spp 16 --checkpoint '%s'", scene, out, file)) fail_msg("%s", support_err);
    support_expect(0, "", BASE "--spp 48 --resume '%s'", scene, out, file);
    support_expect(1, "seed was 0, and is 1 now", BASE "--spp 16 --seed 1 --resume '%s'", scene, out, file);
    support_expect(1, "sun.elevation was 30, and is 31 now", BASE "--spp 16 --sun 31 --resume '%s'", scene,
                   out, file);
    support_expect(1, "light was ", BASE "--spp 16 --light mis --resume '%s'", scene, out, file);
    support_expect(1, "size was 32x32, and is 33x32 now",
                   "render '%s' --size 33x32 --spp 16 -o '%s' --resume '%s'", scene, out, file);
    support_expect(1, "measure was percent", BASE "--error 3levels --resume '%s'", scene, out, file);
    support_expect(1, "cannot be read", BASE "--spp 16 --resume '%s'", scene, out,
                   support_path("none.state"));
    support_expect(0, "", BASE "--spp 16 --checkpoint '%s' --resume '%s'", scene, out,
                   support_path("new.state"), support_path("new.state"));
    support_expect(1, "no checkpoint", BASE "--spp 16 --resume '%s'", scene, out, scene);
    support_expect(2, "both the checkpoint and a picture", BASE "--spp 16 --checkpoint '%s'", scene, out,
                   out);
    support_expect(2, "which file?", BASE "--spp 16 --checkpoint-every 3", scene, out);
    for (size_t at = 30; at < 40000; at = at * 3 / 2) {
        support_expect(1, "checkpoint", BASE "--spp 16 --resume '%s'", scene, out, damaged(file, at, false));
        support_expect(1, "checkpoint", BASE "--spp 16 --resume '%s'", scene, out, damaged(file, at, true));
    }
    /* The one before is whole: it was kept when the second was written. */
    const char *bad = damaged(file, 20000, false);
    char older[4096];
    snprintf(older, sizeof older, "%s.old", bad);
    text_free(&text);
    assert_true(file_read(file, STATUS_FAILURE, &text, &error) &&
                file_replace(older, text.data, text.size, &error));
    support_expect(1, ".old", BASE "--spp 16 --resume '%s'", scene, out, bad);
    support_expect(0, "", BASE "--spp 16 --resume '%s'", scene, out, older);
    /* Another text of the scene. */
    text_free(&text);
    assert_true(file_read(scene, STATUS_FAILURE, &text, &error));
    text_print(&text, "\n// another\n");
    assert_true(file_replace(scene, text.data, text.size, &error));
    support_expect(1, "the text of the scene", BASE "--spp 16 --resume '%s'", scene, out, file);
    text_free(&text);
}

/* Where pixels have different numbers of samples, --spp cannot go on, but --error can. */
static void test_uneven(void **state) {
    (void)state;
    const char *file = support_path("uneven.state"), *out = support_path("out.pfm");
#define UNEVEN "render scenes/crater.glsl --size 64x64 -o '%s' --quiet "
    if (support_run("", UNEVEN "--error 1.5 --checkpoint '%s'", out, file)) fail_msg("%s", support_err);
    support_expect(2, "--spp takes the same number of each", UNEVEN "--spp 4096 --resume '%s'", out, file);
    support_expect(0, "", UNEVEN "--error 1.2 --resume '%s'", out, file);
}

/* A checkpoint that cannot be written does not lose the picture. */
static void test_unwritten(void **state) {
    (void)state;
    const char *file = support_path("full.state"), *out = support_path("full.pfm"), *whole = whole_picture();
    unlink(out);
    /* 75 kB of a picture fit, and 290 kB of a checkpoint do not. */
    int status = support_run("ulimit -f 300;", "%s -o '%s' --checkpoint '%s' --checkpoint-every 0.01",
                             picture, out, file);
    assert_int_equal(status, STATUS_OUTPUT);
    assert_non_null(strstr(support_err, "full.state: cannot be written"));
    assert_non_null(strstr(support_err, "the render goes on"));
    expect_same(whole, out);
    assert_int_equal(access(file, F_OK), -1);
}

static void test_info(void **state) {
    (void)state;
    const char *file = support_path("info.state"), *out = support_path("info.exr");
    if (support_run("", "render scenes/crater.glsl --size 32x32 --spp 16 -o '%s' --quiet --checkpoint '%s'",
                    out, file))
        fail_msg("%s", support_err);
    support_expect(0, "", "info '%s'", file);
    assert_non_null(strstr(support_out, "a checkpoint"));
    assert_non_null(strstr(support_out, "samples 16"));
    support_expect(0, "", "info '%s'", out);
    assert_non_null(strstr(support_out, "EXR of 32x32"));
    assert_non_null(strstr(support_out, "magichour.seed: 0"));
    support_expect(1, "cut off", "info '%s'", damaged(file, 2000, true));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_states),    cmocka_unit_test(test_killed), cmocka_unit_test(test_signals),
        cmocka_unit_test(test_refusals),  cmocka_unit_test(test_uneven), cmocka_unit_test(test_info),
        cmocka_unit_test(test_unwritten),
    };
    return cmocka_run_group_tests_name("checkpoint", tests, support_folder, support_clean);
}
