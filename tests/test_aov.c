/* The layers beside a picture: in files, against what is seen analytically, and how far they are right about
 * the picture's error. */
#include "support.h"

#include "base/memory.h"
#include "image/codec.h"
#include "render/aov.h"

#include <math.h>
#include <openexr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A file's channels as OpenEXR reads them. */
typedef struct Channels {
    int count, width, height;
    char names[24][32];
    float *data[24]; /* owned */
} Channels;

static void check(exr_result_t result, const char *path) {
    if (result) fail_msg("%s: %s", path, exr_get_error_code_as_string(result));
}

static void read_chunk(exr_context_t file, const char *path, int y, Channels *channels) {
    exr_chunk_info_t chunk;
    exr_decode_pipeline_t pipeline = EXR_DECODE_PIPELINE_INITIALIZER;
    check(exr_read_scanline_chunk_info(file, 0, y, &chunk), path);
    check(exr_decoding_initialize(file, 0, &chunk, &pipeline), path);
    for (int i = 0; i < pipeline.channel_count; i++) {
        exr_coding_channel_info_t *channel = &pipeline.channels[i];
        assert_int_equal(channel->data_type, EXR_PIXEL_FLOAT);
        channel->user_pixel_stride = sizeof(float);
        channel->user_line_stride = channels->width * (int)sizeof(float);
        channel->decode_to_ptr = (uint8_t *)(channels->data[i] + (size_t)y * (size_t)channels->width);
    }
    check(exr_decoding_choose_default_routines(file, 0, &pipeline), path);
    check(exr_decoding_run(file, 0, &pipeline), path);
    exr_decoding_destroy(file, &pipeline);
}

static Channels channels_read(const char *path) {
    exr_context_t file = NULL;
    const exr_attr_chlist_t *list = NULL;
    exr_attr_box2i_t window;
    int32_t lines = 0, parts = 0;
    check(exr_start_read(&file, path, NULL), path);
    check(exr_get_count(file, &parts), path);
    assert_int_equal(parts, 1);
    check(exr_get_channels(file, 0, &list), path);
    check(exr_get_data_window(file, 0, &window), path);
    check(exr_get_scanlines_per_chunk(file, 0, &lines), path);
    Channels channels = {.count = list->num_channels, .width = window.max.x + 1, .height = window.max.y + 1};
    assert_true(channels.count <= 24);
    for (int i = 0; i < channels.count; i++) {
        snprintf(channels.names[i], sizeof channels.names[i], "%s", list->entries[i].name.str);
        channels.data[i] = memory_get((size_t)channels.width * (size_t)channels.height, sizeof(float));
    }
    for (int y = 0; y < channels.height; y += lines) read_chunk(file, path, y, &channels);
    exr_finish(&file);
    return channels;
}

static void channels_free(Channels *channels) {
    for (int i = 0; i < channels->count; i++) free(channels->data[i]);
}

/* "A B G R Z": the names in the file's order. */
static void assert_names(const Channels *channels, const char *expected) {
    Text names = {0};
    for (int i = 0; i < channels->count; i++) text_print(&names, "%s%s", i ? " " : "", channels->names[i]);
    assert_string_equal(text_string(&names), expected);
    text_free(&names);
}

static const float *channel(const Channels *channels, const char *name) {
    for (int i = 0; i < channels->count; i++) {
        if (strcmp(channels->names[i], name) == 0) return channels->data[i];
    }
    fail_msg("no channel %s", name);
    return NULL;
}

static const char all[] = "albedo,normal,depth,samples,variance";

/* Renders to a new file, skips without OpenGL. */
static Channels render(const char *aov, const char *arguments) {
    const char *path = support_path("aov.exr");
    int status = support_run("", "render %s --aov %s --quiet -o '%s'", arguments, aov, path);
    if (status == STATUS_NO_GL) support_no_gl(support_err);
    if (status != 0) fail_msg("render %s: %s", arguments, support_err);
    return channels_read(path);
}

static void fill(float *data, int count, int key) {
    static const float awkward[] = {0.0F, -0.0F, 1e-42F, 3.4e38F, INFINITY, NAN, -1.0F};
    for (int i = 0; i < count; i++) data[i] = i % 5 ? (float)(i * 7 + key) : awkward[(i + key) % 7];
}

static void assert_channel(const Channels *channels, const char *name, const float *data, int stride,
                           int offset) {
    const float *got = channel(channels, name);
    for (int i = 0; i < channels->width * channels->height; i++) {
        if (memcmp(&got[i], &data[stride * i + offset], sizeof *got) != 0)
            fail_msg("%s, pixel %d: %g", name, i, (double)got[i]);
    }
}

/* Layers of one channel and of more, several chunks: the file's channels are sorted and hold the layers to
 * the bit; our own decoder sees the picture alone, and the other formats hold nothing else. */
static void test_files(void **state) {
    (void)state;
    enum { WIDTH = 33, HEIGHT = 40, PIXELS = WIDTH * HEIGHT };
    static const ImageWriteParams plain = {0};
    Error error;
    Image image = image_create(WIDTH, HEIGHT), read;
    Text bare = {0}, layered = {0};
    fill(image.rgba, 4 * PIXELS, 1);
    assert_true(png_encode(&image, &plain, &bare, &error));
    float *variance = image_add_layer(&image, "variance", "RGB"), *depth = image_add_layer(&image, "", "Z"),
          *normal = image_add_layer(&image, "normal", "XYZ"),
          *counts = image_add_layer(&image, "samples", "Y");
    fill(variance, 3 * PIXELS, 2);
    fill(depth, PIXELS, 3);
    fill(normal, 3 * PIXELS, 4);
    fill(counts, PIXELS, 5);
    const char *path = support_path("layers.exr");
    assert_true(image_write(&image, path, &plain, &error));
    Channels channels = channels_read(path);
    assert_names(&channels,
                 "A B G R Z normal.X normal.Y normal.Z samples.Y variance.B variance.G variance.R");
    assert_channel(&channels, "R", image.rgba, 4, 0);
    assert_channel(&channels, "A", image.rgba, 4, 3);
    assert_channel(&channels, "Z", depth, 1, 0);
    assert_channel(&channels, "samples.Y", counts, 1, 0);
    for (int c = 0; c < 3; c++) {
        char name[16];
        snprintf(name, sizeof name, "variance.%c", "RGB"[c]);
        assert_channel(&channels, name, variance, 3, c);
        snprintf(name, sizeof name, "normal.%c", "XYZ"[c]);
        assert_channel(&channels, name, normal, 3, c);
    }
    assert_true(image_read(&read, path, &error));
    assert_memory_equal(read.rgba, image.rgba, sizeof(float) * 4 * PIXELS);
    assert_int_equal(read.layer_count, 0);
    assert_true(png_encode(&image, &plain, &layered, &error));
    assert_int_equal(bare.size, layered.size);
    assert_memory_equal(bare.data, layered.data, bare.size);
    text_free(&bare);
    text_free(&layered);
    channels_free(&channels);
    image_free(&image);
    image_free(&read);
}

/* The transmittance is that of the mist before the first surface, or of all of it; 1 without mist. */
static void test_transmittance(void **state) {
    (void)state;
    static const struct {
        const char *mist, *radius;
        double wanted;
    } cases[] = {
        {"//@ mist extinction 0.2 sphere 0 0 0 3", "5.0", 0.54881164},
        {"//@ mist extinction 0.2 sphere 0 0 0 3", "1.0", 0.81873075},
        {"//@ mist extinction 0.2 falloff 1e5 sphere 0 0 0 3\nfloat scene_mist(vec3 p) { return 0.0; }",
         "5.0", 1},
        {"", "5.0", 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1024], arguments[256];
        snprintf(text, sizeof text,
                 "//@ camera eye 0 0 0 target 0 0 1 fov 60\n//@ sky uniform:1\n%s\n#include "
                 "\"material/matte.glsl\"\n"
                 "#include \"shape/sphere.glsl\"\nvoid scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                 "    hit_sphere(ray, vec3(0.0), %s, 0, hit);\n}\n"
                 "Material scene_material(Hit hit) { return matte(vec3(0.5)); }\n",
                 cases[i].mist, cases[i].radius);
        snprintf(arguments, sizeof arguments, "'%s' --size 8x8 --spp 4", support_write("mist.glsl", text));
        Channels channels = render("transmittance,depth", arguments);
        const float *kept = channel(&channels, "transmittance.Y");
        for (int k = 0; k < 64; k++) {
            if (fabs((double)kept[k] - cases[i].wanted) > 2e-6)
                fail_msg("case %zu, pixel %d: %.7f, wanted %.7f", i, k, (double)kept[k], cases[i].wanted);
        }
        channels_free(&channels);
    }
}

static void test_lists(void **state) {
    (void)state;
    const char *out = support_path("out.exr"), *png = support_path("out.png");
    static const char crater[] = "render scenes/crater.glsl --size 8x8 --spp 1 --sky uniform";
    support_expect(2,
                   "--aov: unknown 'alpha' (known: albedo, normal, depth, samples, variance, transmittance)",
                   "%s --aov albedo,alpha -o '%s'", crater, out);
    support_expect(2, "--aov: unknown '' (known: ", "%s --aov '' -o '%s'", crater, out);
    support_expect(2, "--aov: unknown '' (known: ", "%s --aov depth, -o '%s'", crater, out);
    support_expect(2, "--aov: unknown 'Depth': did you mean depth? (known: ", "%s --aov Depth -o '%s'",
                   crater, out);
    support_expect(2, "--aov: 'depth' comes twice", "%s --aov depth,normal,depth -o '%s'", crater, out);
    support_expect(2, "--aov: only .exr holds layers", "%s --aov depth -o '%s'", crater, png);
    support_expect(2, "sky has no option '--aov'", "sky --aov depth -o '%s'", out);
    assert_int_not_equal(access(out, F_OK), 0);
    support_expect(0, "", "%s --aov depth --quiet -o '%s' -o '%s'", crater, png, out);
    Channels channels = channels_read(out);
    assert_names(&channels, "A B G R Z");
    channels_free(&channels);
    channels = render("variance,albedo", "scenes/crater.glsl --size 8x8 --spp 1 --sky uniform");
    assert_names(&channels, "A B G R albedo.B albedo.G albedo.R variance.B variance.G variance.R");
    assert_non_null(strstr(
        support_err, "warning: --aov variance is not known from 16 samples or fewer, or where it is too "
                     "large for a float: there it is NaN"));
    assert_true(isnan(channel(&channels, "variance.R")[0]));
    channels_free(&channels);
    assert_int_equal(support_run("", "render --help"), 0);
    assert_non_null(strstr(support_out, "--aov LIST"));
}

/* The crater's plane, away from the crater, by a camera at (50, 2, 0) that looks along +z and half as far
 * down. */
typedef struct Seen {
    bool hit;
    double depth, x, z;
} Seen;

static Seen look(double column, double row, int size) {
    double at_x = 2 * column / size - 1, at_y = 1 - 2 * row / size, half = tan(30 * 3.14159265358979 / 180);
    double forward[2] = {-1 / sqrt(5), 2 / sqrt(5)}; /* y, z; right is -x */
    double y = forward[0] + at_y * half * forward[1], z = forward[1] - at_y * half * forward[0];
    double depth = -2 / y;
    return (Seen){y < 0, depth, 50 - at_x * half * depth, z * depth};
}

static const char plane[] =
    "scenes/crater.glsl --size 64x64 --sky uniform --set ball=0 --set camera.eye=50,2,0 --set "
    "camera.target=50,0,4 --set camera.fov=60";

static bool same_square(const Seen corners[4]) {
    for (int i = 1; i < 4; i++) {
        if (floor(corners[i].x) != floor(corners[0].x) || floor(corners[i].z) != floor(corners[0].z))
            return false;
    }
    return true;
}

/* Pixels within a square of the checker have its albedo, all of the plane the normal (0,1,0), the depth lies
 * between its corners' and is their mean where the plane is near; the sky has none of it. Under a sky of 1
 * the plane's radiance is its albedo, also where both are means over squares: the rays are the picture's. */
static void test_plane(void **state) {
    (void)state;
    enum { SIZE = 64 };
    char arguments[512];
    int inside = 0, missed = 0;
    snprintf(arguments, sizeof arguments, "%s --spp 64", plane);
    Channels channels = render(all, arguments);
    const float *red = channel(&channels, "albedo.R"), *blue = channel(&channels, "albedo.B"),
                *depth = channel(&channels, "Z"), *up = channel(&channels, "normal.Y"),
                *x = channel(&channels, "normal.X"), *z = channel(&channels, "normal.Z"),
                *picture = channel(&channels, "R");
    for (int i = 0; i < SIZE * SIZE; i++) {
        Seen corners[4];
        for (int k = 0; k < 4; k++) corners[k] = look(i % SIZE + k % 2, (int)(i / SIZE) + k / 2, SIZE);
        Seen middle = look(i % SIZE + 0.5, (int)(i / SIZE) + 0.5, SIZE);
        if (!corners[2].hit) { /* the lower edge is above the horizon */
            assert_true(red[i] == 0 && up[i] == 0 && x[i] == 0 && z[i] == 0 && depth[i] == 1e10f);
            missed++;
        } else if (corners[0].hit) {
            assert_true(x[i] == 0 && up[i] == 1 && z[i] == 0);
            assert_true(fabsf(picture[i] - red[i]) < 1e-5f);
            assert_true((double)depth[i] > corners[2].depth && (double)depth[i] < corners[0].depth);
            if (middle.depth < 10) assert_true(fabs((double)depth[i] / middle.depth - 1) < 3e-3);
            if (!same_square(corners)) continue;
            float albedo = (int)(floor(middle.x) + floor(middle.z)) % 2 ? 0.1f : 0.8f;
            assert_true(fabsf(red[i] - albedo) < 1e-6f && blue[i] == red[i]);
            inside++;
        }
    }
    print_message("%d pixels within a square, %d above the horizon\n", inside, missed);
    assert_true(inside > 1000 && missed == 4 * SIZE);
    channels_free(&channels);
}

/* The mean normal of a sphere of radius 1 at distance 4 over a pixel, and its mean depth, by a grid of rays;
 * the share of rays that hit. Camera at (0,0,-4), looking along +z, right is -x. */
static double look_at_ball(int column, int row, int size, double half, double normal[3], double *depth) {
    enum { GRID = 32 };
    double hits = 0;
    memset(normal, 0, 3 * sizeof *normal);
    *depth = 0;
    for (int i = 0; i < GRID * GRID; i++) {
        double x = half * (1 - 2 * (column + (i % GRID + 0.5) / GRID) / size);
        double y = half * (1 - 2 * (row + ((int)(i / GRID) + 0.5) / GRID) / size);
        double square = x * x + y * y + 1, root = 16 - 15 * square;
        if (root < 0) continue;
        double t = (4 - sqrt(root)) / square;
        normal[0] += t * x / (GRID * GRID);
        normal[1] += t * y / (GRID * GRID);
        normal[2] += (t - 4) / (GRID * GRID);
        *depth += t;
        hits++;
    }
    if (hits > 0) *depth /= hits;
    return hits / (GRID * GRID);
}

/* The ball's normals and depths, its edge included: there the normal is the mean of what is there and
 * nothing. */
static void test_ball(void **state) {
    (void)state;
    enum { SIZE = 32 };
    const char *scene = support_write(
        "ball.glsl",
        "//@ camera eye 0 0 -4 target 0 0 0 fov 40\n#include \"material/mirror.glsl\"\n"
        "#include \"shape/sphere.glsl\"\n"
        "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_sphere(ray, vec3(0.0), 1.0, 0, hit); }\n"
        "Material scene_material(Hit hit) { return mirror(vec3(0.5, 2.0, -1.0)); }\n");
    char arguments[512];
    int edge = 0;
    snprintf(arguments, sizeof arguments, "'%s' --sky uniform --size %dx%d --spp 256", scene, SIZE, SIZE);
    Channels channels = render(all, arguments);
    for (int i = 0; i < SIZE * SIZE; i++) {
        double normal[3], depth;
        double share =
            look_at_ball(i % SIZE, i / SIZE, SIZE, tan(20 * 3.14159265358979 / 180), normal, &depth);
        double tolerance = share > 0 && share < 1 ? 0.03 : 2e-3;
        static const char *const names[] = {"normal.X", "normal.Y", "normal.Z"}, *const tints[] = {
                                                                                     "albedo.R", "albedo.G",
                                                                                     "albedo.B"};
        static const double tint[] = {0.5, 1, 0}; /* kept in [0,1] */
        for (int c = 0; c < 3; c++) {
            assert_true(fabs((double)channel(&channels, names[c])[i] - normal[c]) < tolerance);
            assert_true(fabs((double)channel(&channels, tints[c])[i] - share * tint[c]) <
                        (tolerance > 0.01 ? 0.03 : 1e-6));
        }
        if (share == 0) assert_true(channel(&channels, "Z")[i] == 1e10f);
        if (share > 0.2) assert_true(fabs((double)channel(&channels, "Z")[i] - depth) < tolerance);
        edge += share > 0 && share < 1;
    }
    assert_true(edge > 40);
    channels_free(&channels);
}

/* --aov changes no bit of the picture, with either kind of program. */
static void test_same_picture(void **state) {
    (void)state;
    static const char *const cases[] = {"--light cosine --spp 40", "--light control --spp 20",
                                        "--sequence random --spp 33 --sun-disk --set camera.target=0,4,0"};
    Error error;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char arguments[256];
        Image with, without;
        snprintf(arguments, sizeof arguments, "scenes/crater.glsl --size 96x80 %s", cases[i]);
        Channels channels = render(all, arguments);
        channels_free(&channels);
        assert_true(image_read(&with, support_path("aov.exr"), &error));
        support_expect(0, "", "render %s --quiet -o '%s'", arguments, support_path("plain.exr"));
        assert_true(image_read(&without, support_path("plain.exr"), &error));
        assert_memory_equal(with.rgba, without.rgba, sizeof(float) * 4 * 96 * 80);
        image_free(&with);
        image_free(&without);
    }
}

/* As many as were asked for, but where a sample is not finite. */
static void test_samples(void **state) {
    (void)state;
    const char *scene = support_write(
        "nan.glsl",
        "#include \"material/emitter.glsl\"\n#include \"material/matte.glsl\"\n#include "
        "\"shape/plane.glsl\"\n"
        "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0, 1, 0), 0.0, 0, hit); }\n"
        "Material scene_material(Hit hit) {\n"
        "    float zero = hit.position.x * 0.0;\n"
        "    if (hit.position.x > 0.0) return emitter(vec3(zero / zero));\n"
        "    return matte(vec3(0.5)); }\n");
    char arguments[512];
    Channels channels = render("samples", "scenes/crater.glsl --size 24x24 --spp 41 --sky uniform");
    for (int i = 0; i < 24 * 24; i++) assert_true(channel(&channels, "samples.Y")[i] == 41);
    channels_free(&channels);
    snprintf(arguments, sizeof arguments, "'%s' --sky uniform --size 16x16 --spp 24", scene);
    channels = render(all, arguments);
    const float *samples = channel(&channels, "samples.Y"), *albedo = channel(&channels, "albedo.R");
    int lost = 15 * 16, kept = 15 * 16 + 15; /* the left is +x */
    assert_true(samples[lost] == 0 && albedo[lost] == 0 && isnan(channel(&channels, "variance.R")[lost]));
    assert_true(samples[kept] == 24 && albedo[kept] == 0.5f && channel(&channels, "normal.Y")[lost] == 1);
    assert_true(channel(&channels, "variance.R")[kept] >= 0);
    channels_free(&channels);
}

/* A renderer of the crater with all layers; skips without OpenGL. */
typedef struct Bench {
    Context context;
    Scene scene;
    Renderer renderer;
    Aov aov;
} Bench;

static void bench_open(Bench *bench, const char *sequence, int size) {
    Error error;
    unsigned kinds = 0;
    support_open(&bench->context);
    assert_true(scene_read(&bench->scene, "scenes/crater.glsl", "glsl", &error) &&
                aov_parse(all, &kinds, &error));
    RenderParams params = {
        .scene = &bench->scene, .sequence = sequence, .width = size, .height = size, .variance = true};
    if (!renderer_create(&bench->renderer, &bench->context, &params, &error) ||
        !aov_create(&bench->aov, kinds, &bench->context, &params, &bench->renderer, &error)) {
        fail_msg("%s", error.text);
    }
}

static void bench_close(Bench *bench) {
    aov_destroy(&bench->aov);
    renderer_destroy(&bench->renderer);
    scene_destroy(&bench->scene);
    context_close(&bench->context);
}

static Image bench_read(const Bench *bench) {
    Image image;
    FilmCount count;
    Error error;
    if (!film_read(&bench->renderer.film, &image, &count, &error) ||
        !aov_read(&bench->aov, &bench->renderer.film, &image, &error)) {
        fail_msg("%s", error.text);
    }
    return image;
}

static const float *layer(const Image *image, const char *name) {
    for (int i = 0; i < image->layer_count; i++) {
        if (strcmp(image->layers[i].name, name) == 0) return image->layers[i].data;
    }
    fail_msg("no layer %s", name);
    return NULL;
}

/* The estimate's mean over the variance that 32 seeds' means have. */
static double variance_ratio(const char *sequence, uint64_t samples) {
    enum { SIZE = 32, VALUES = 3 * SIZE * SIZE, SEEDS = 32 };
    static double sum[VALUES], squares[VALUES];
    Bench bench;
    Error error;
    double estimated = 0, spread = 0;
    memset(sum, 0, sizeof sum);
    memset(squares, 0, sizeof squares);
    bench_open(&bench, sequence, SIZE);
    for (unsigned seed = 0; seed < SEEDS; seed++) {
        Renderer *renderer = &bench.renderer;
        film_reset(&renderer->film);
        program_use(&renderer->program);
        program_set_uint(&renderer->program, "seed", seed);
        while (renderer->film.samples < samples)
            assert_true(renderer_pass(renderer, samples - renderer->film.samples, NULL, &error));
        Image image = bench_read(&bench);
        const float *variance = layer(&image, "variance");
        for (int i = 0; i < VALUES; i++) {
            double value = (double)image.rgba[i / 3 * 4 + i % 3];
            sum[i] += value;
            squares[i] += value * value;
            assert_true(variance[i] >= 0);
            estimated += (double)variance[i] / SEEDS;
        }
        image_free(&image);
    }
    for (int i = 0; i < VALUES; i++) spread += (squares[i] - sum[i] * sum[i] / SEEDS) / (SEEDS - 1);
    bench_close(&bench);
    print_message("%s, %d samples: estimated variance %.3f of the spread of %d seeds\n", sequence,
                  (int)samples, estimated / spread, SEEDS);
    return estimated / spread;
}

/* Right for independent samples, in whole groups and with a short one last; above for those that fill each
 * other's gaps. */
static void test_variance(void **state) {
    (void)state;
    assert_true(fabs(variance_ratio("random", 256) - 1) < 0.1);
    assert_true(fabs(variance_ratio("random", 36) - 1) < 0.1);
    assert_true(variance_ratio("sobol", 256) > 1);
}

static bool yes(void) {
    return true;
}

/* Stopped in its first group, a picture has all of its first hits and no variance; else a stop adds nothing,
 * and enough samples are enough. */
static void test_stopped(void **state) {
    (void)state;
    enum { SIZE = 16, PIXELS = SIZE * SIZE };
    Bench bench;
    Error error;
    bench_open(&bench, "sobol", SIZE);
    Renderer *renderer = &bench.renderer;
    pace_set(&renderer->pace, SIZE, SIZE, 1);
    pace_set(&bench.aov.pace, SIZE, SIZE, 1);
    assert_true(renderer_pass(renderer, 64, yes, &error) &&
                aov_pass(&bench.aov, renderer, renderer->film.samples, yes, &error));
    assert_int_equal(bench.aov.samples, 0);
    assert_true(aov_complete(&bench.aov, &error));
    assert_int_equal(bench.aov.samples, 1);
    Image image = bench_read(&bench);
    const float *normal = layer(&image, "normal"), *depth = layer(&image, ""),
                *albedo = layer(&image, "albedo");
    for (int i = 0; i < PIXELS; i++) {
        double length =
            hypot(hypot((double)normal[3 * i], (double)normal[3 * i + 1]), (double)normal[3 * i + 2]);
        bool hit = depth[i] < 1e10f;
        assert_true(fabs(length - hit) < 1e-5 && (albedo[3 * i] > 0) == hit);
        assert_true(layer(&image, "samples")[i] == (i < SIZE ? 16 : 0));
        for (int c = 0; c < 3; c++) assert_true(isnan(layer(&image, "variance")[3 * i + c]));
    }
    assert_true(depth[PIXELS - 1] < 10);
    image_free(&image);
    assert_true(renderer_pass(renderer, 64, NULL, &error) &&
                aov_pass(&bench.aov, renderer, renderer->film.samples, yes, &error));
    assert_int_equal(bench.aov.samples, 1);
    while (renderer->film.samples < AOV_MOST_SAMPLES + 40) {
        assert_true(renderer_pass(renderer, 1000, NULL, &error) &&
                    aov_pass(&bench.aov, renderer, renderer->film.samples, NULL, &error));
        uint64_t taken = renderer->film.samples;
        assert_int_equal(bench.aov.samples, taken < AOV_MOST_SAMPLES ? taken : AOV_MOST_SAMPLES);
    }
    bench_close(&bench);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_files),   cmocka_unit_test(test_transmittance),
        cmocka_unit_test(test_lists),   cmocka_unit_test(test_plane),
        cmocka_unit_test(test_ball),    cmocka_unit_test(test_same_picture),
        cmocka_unit_test(test_samples), cmocka_unit_test(test_variance),
        cmocka_unit_test(test_stopped),
    };
    return cmocka_run_group_tests_name("aov", tests, support_folder, support_clean);
}
