/* Tables that are filled in steps. Their content is the same to the bit as if it had been drawn at once,
 * whatever happens between the steps. */
#include "support.h"

#include "gl/resource.h"

#include <math.h>
#include <string.h>

enum { WIDTH = 24, MOST_WIDTH = 1000, HEIGHT = 60, SIDE = 8, MOST_TEXELS = MOST_WIDTH * HEIGHT };

/* What the tables are made from. */
typedef struct Numbers {
    double a, b;
    int width;
} Numbers;

static bool wanted(const void *frame) {
    (void)frame;
    return true;
}

static void small_size(const void *frame, int *width, int *height) {
    (void)frame;
    *width = *height = SIDE;
}

static void large_size(const void *frame, int *width, int *height) {
    *width = ((const Numbers *)frame)->width;
    *height = HEIGHT;
}

static void key_a(const void *frame, Text *key) {
    text_append(key, &((const Numbers *)frame)->a, sizeof(double));
}

static void key_b(const void *frame, Text *key) {
    text_append(key, &((const Numbers *)frame)->b, sizeof(double));
}

static void set(Uniforms *uniforms, double value) {
    uniforms_declared_in(uniforms, NULL);
    uniforms_float(uniforms, "value", value);
}

static void seed_uniforms(const Resource *resource, const void *frame, Uniforms *uniforms) {
    (void)resource;
    set(uniforms, ((const Numbers *)frame)->a);
}

static void first_uniforms(const Resource *resource, const void *frame, Uniforms *uniforms) {
    (void)resource, (void)frame;
    set(uniforms, 0.3);
}

static void between_uniforms(const Resource *resource, const void *frame, Uniforms *uniforms) {
    (void)resource;
    set(uniforms, ((const Numbers *)frame)->b);
}

static void second_uniforms(const Resource *resource, const void *frame, Uniforms *uniforms) {
    (void)resource, (void)frame;
    set(uniforms, 0.7);
}

/* Each reads the one before. The last three share a program, and two of them are filled in steps. */
static const ResourceKind seed = {.name = "the seed",
                                  .entry = "seed.glsl",
                                  .samplers = {"seed_texels"},
                                  .filter = GL_NEAREST,
                                  .wanted = wanted,
                                  .size = small_size,
                                  .key = key_a,
                                  .uniforms = seed_uniforms};
static const ResourceKind first = {.name = "the first table",
                                   .entry = "chain.glsl",
                                   .samplers = {"first_texels"},
                                   .filter = GL_NEAREST,
                                   .inputs = {&seed},
                                   .input_samplers = {{"before"}},
                                   .wanted = wanted,
                                   .in_steps = wanted,
                                   .size = large_size,
                                   .uniforms = first_uniforms};
static const ResourceKind between = {.name = "the table between",
                                     .entry = "chain.glsl",
                                     .samplers = {"between_texels"},
                                     .filter = GL_NEAREST,
                                     .inputs = {&first},
                                     .input_samplers = {{"before"}},
                                     .wanted = wanted,
                                     .size = small_size,
                                     .key = key_b,
                                     .uniforms = between_uniforms};
static const ResourceKind second = {.name = "the second table",
                                    .entry = "chain.glsl",
                                    .samplers = {"second_texels"},
                                    .filter = GL_NEAREST,
                                    .inputs = {&between},
                                    .input_samplers = {{"before"}},
                                    .wanted = wanted,
                                    .in_steps = wanted,
                                    .size = large_size,
                                    .uniforms = second_uniforms};
static const ResourceKind *const kinds[] = {&seed, &first, &between, &second, NULL};

static bool make_text(const void *data, const char *entry, GlslSource *source, Error *error) {
    (void)data;
    return support_flatten(source, "glsl", support_path(entry), NULL, error);
}

static void create(Resources *tables, Context *context, const Numbers *numbers) {
    ResourceTexts texts = {make_text, NULL};
    Error error;
    support_open(context);
    support_write("seed.glsl", "#version 330 core\nuniform float value;\nout vec4 texel;\n"
                               "void main() { texel = fract(value * gl_FragCoord.xyyx); }\n");
    support_write("chain.glsl",
                  "#version 330 core\nuniform sampler2D before;\nuniform float value;\nout vec4 texel;\n"
                  "void main() {\n"
                  "    ivec2 at = ivec2(gl_FragCoord.xy);\n"
                  "    vec4 v = texelFetch(before, at % textureSize(before, 0), 0);\n"
                  "    for (int i = 0; i < 20; i++) v = fract(1.7 * v + value + 0.01 * vec4(at, at.yx));\n"
                  "    texel = v;\n}\n");
    if (!resources_create(tables, context, kinds, numbers, &texts, &error)) fail_msg("%s", error.text);
}

/* One step, of two rows where `seconds` is 0. */
static double step(Resources *tables, const Numbers *numbers, double seconds, bool (*stop)(void)) {
    Uniforms uniforms = {0};
    Error error;
    double share = -1;
    if (!resources_prepare_for(tables, numbers, &uniforms, seconds, stop, &share, &error))
        fail_msg("%s", error.text);
    uniforms_free(&uniforms);
    return share;
}

static int fills(const Resources *tables, const ResourceKind *kind) {
    return resources_find(tables, kind)->fills;
}

/* The tables are those of a set that was filled at once for the same numbers. */
static void expect_content(const Resources *tables, Context *context, const Numbers *numbers) {
    static float got[4 * MOST_TEXELS], expected[4 * MOST_TEXELS];
    Resources other;
    Uniforms uniforms = {0};
    Error error;
    ResourceTexts texts = {make_text, NULL};
    assert_true(resources_create(&other, context, kinds, numbers, &texts, &error) &&
                resources_prepare(&other, numbers, &uniforms, &error));
    uniforms_free(&uniforms);
    for (int i = 0; kinds[i]; i++) {
        const Resource *a = resources_find(tables, kinds[i]), *b = resources_find(&other, kinds[i]);
        assert_true(a->width == b->width && a->height == b->height);
        assert_true(resource_read(a, 0, got, &error) && resource_read(b, 0, expected, &error));
        assert_memory_equal(got, expected, (size_t)a->width * (size_t)a->height * 4 * sizeof *got);
    }
    resources_destroy(&other);
}

static void test_steps(void **state) {
    (void)state;
    Numbers numbers = {0.61, 0.17, WIDTH};
    Context context;
    Resources tables;
    create(&tables, &context, &numbers);
    double before = -1;
    for (int row = 2; row < 2 * HEIGHT; row += 2) {
        double share = step(&tables, &numbers, 0, NULL);
        assert_true(share > before && share < 1);
        assert_int_equal(fills(&tables, &first), row >= HEIGHT);
        assert_int_equal(fills(&tables, &second), 0);
        before = share;
    }
    assert_true(step(&tables, &numbers, 0, NULL) == 1);
    expect_content(&tables, &context, &numbers);
    assert_true(step(&tables, &numbers, 0, NULL) == 1);
    for (int i = 0; kinds[i]; i++) assert_int_equal(fills(&tables, kinds[i]), 1);
    resources_destroy(&tables);
    context_close(&context);
}

/* What changes between steps begins anew, with all that reads it, and what does not goes on. */
static void test_changes(void **state) {
    (void)state;
    Numbers numbers = {0.61, 0.17, WIDTH};
    Context context;
    Resources tables;
    create(&tables, &context, &numbers);
    for (int row = 0; row < HEIGHT + 20; row += 2) step(&tables, &numbers, 0, NULL);
    assert_int_equal(resources_find(&tables, &second)->row, 20);
    numbers.b = 0.31;
    assert_true(step(&tables, &numbers, 0, NULL) < 1);
    assert_int_equal(resources_find(&tables, &second)->row, 2);
    assert_int_equal(fills(&tables, &first), 1);
    numbers.a = 0.23;
    for (int row = 0; row < HEIGHT / 2; row += 2) step(&tables, &numbers, 0, NULL);
    assert_int_equal(resources_find(&tables, &first)->row, HEIGHT / 2);
    numbers.b = 0.83;
    assert_true(fabs(step(&tables, &numbers, 0, NULL) - (HEIGHT / 2 + 2) / (2.0 * HEIGHT)) < 1e-9);
    assert_int_equal(resources_find(&tables, &first)->row, HEIGHT / 2 + 2);
    while (step(&tables, &numbers, 0.001, NULL) < 1) continue;
    expect_content(&tables, &context, &numbers);
    assert_int_equal(fills(&tables, &first), 2);
    assert_int_equal(fills(&tables, &second), 1);
    /* Back to what it was before a table was whole: the rows that were drawn since are not taken for it. */
    numbers.a = 0.5;
    for (int row = 0; row < HEIGHT / 2; row += 2) step(&tables, &numbers, 0, NULL);
    numbers.a = 0.23;
    assert_true(step(&tables, &numbers, 0, NULL) < 1);
    assert_int_equal(resources_find(&tables, &first)->row, 2);
    numbers.width = WIDTH - 5;
    numbers.a = 0.41;
    while (step(&tables, &numbers, 0, NULL) < 1) continue;
    expect_content(&tables, &context, &numbers);
    resources_destroy(&tables);
    context_close(&context);
}

static bool stop(void) {
    return true;
}

/* It is asked after each strip; the first one is a few rows. */
static void test_stop(void **state) {
    (void)state;
    Numbers numbers = {0.61, 0.17, MOST_WIDTH};
    Context context;
    Resources tables;
    int steps = 1;
    create(&tables, &context, &numbers);
    assert_true(step(&tables, &numbers, INFINITY, stop) < 0.25);
    while (step(&tables, &numbers, INFINITY, stop) < 1) steps++;
    assert_true(steps >= 3 && steps < HEIGHT);
    expect_content(&tables, &context, &numbers);
    resources_destroy(&tables);
    context_close(&context);
}

/* A size that this OpenGL does not have changes nothing. */
static void test_refusal(void **state) {
    (void)state;
    Numbers numbers = {0.61, 0.17, WIDTH};
    Context context;
    Resources tables;
    Uniforms uniforms = {0};
    Error error;
    double share;
    create(&tables, &context, &numbers);
    assert_true(step(&tables, &numbers, INFINITY, NULL) == 1);
    Numbers other = {0.2, 0.1, context.max_texture_size + 1};
    assert_false(resources_prepare_for(&tables, &other, &uniforms, 1, NULL, &share, &error));
    assert_int_equal(error.status, STATUS_USAGE);
    assert_non_null(strstr(error.text, "the first table: it needs textures of "));
    uniforms_free(&uniforms);
    assert_true(step(&tables, &numbers, 0, NULL) == 1);
    assert_int_equal(fills(&tables, &seed), 1);
    expect_content(&tables, &context, &numbers);
    resources_destroy(&tables);
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_steps),
        cmocka_unit_test(test_changes),
        cmocka_unit_test(test_stop),
        cmocka_unit_test(test_refusal),
    };
    return cmocka_run_group_tests_name("resource", tests, support_folder, support_clean);
}
