#include "support.h"

#include "base/clock.h"
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "gl/program.h"
#include "gl/texture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static char folder[256];
char support_out[262144], support_err[65536];

void support_no_gl(const char *reason) {
    const char *required = getenv("REQUIRE_GL");
    if (required && *required && strcmp(required, "0") != 0) fail_msg("OpenGL is required: %s", reason);
    print_message("no OpenGL here: %s\n", reason);
    skip();
}

void support_open(Context *context) {
    Error error;
    if (!context_open(context, "auto", &error)) support_no_gl(error.text);
}

static uint64_t samples_divisor(void) {
    const char *fewer = getenv("FEWER_SAMPLES");
    uint64_t divisor = fewer ? strtoull(fewer, NULL, 10) : 1;
    return divisor > 1 ? divisor : 1;
}

uint64_t support_samples(uint64_t samples) {
    uint64_t fewer = samples / samples_divisor();
    return fewer > 0 ? fewer : 1;
}

int support_block(void) {
    int side = 1;
    while ((uint64_t)side * (uint64_t)side < samples_divisor()) side++;
    return side;
}

void support_table(const char *kind, const char *format, ...) {
    const char *path = getenv("MAGICHOUR_TABLE");
    FILE *file = path ? fopen(path, "a") : NULL;
    va_list list;
    if (!file) return;
    fprintf(file, "%s\t", kind);
    va_start(list, format);
    vfprintf(file, format, list);
    va_end(list);
    fputc('\n', file);
    fclose(file);
}

/* ---- Each test's time */

static const struct CMUnitTest *timed;
static double timed_start_s;

/* A test that is wrapped has the original for its initial state. */
static int start_timed(void **state) {
    timed = *state;
    timed_start_s = clock_seconds();
    *state = timed->initial_state;
    return timed->setup_func ? timed->setup_func(state) : 0;
}

static int end_timed(void **state) {
    print_message("[     TIME ] %s: %.2f s\n", timed->name, clock_seconds() - timed_start_s);
    return timed->teardown_func ? timed->teardown_func(state) : 0;
}

int support_run_tests(const char *name, const struct CMUnitTest *tests, size_t count, CMFixtureFunction setup,
                      CMFixtureFunction teardown) {
    struct CMUnitTest *wrapped = memory_get(count, sizeof *wrapped);
    for (size_t i = 0; i < count; i++)
        wrapped[i] =
            (struct CMUnitTest){tests[i].name, tests[i].test_func, start_timed, end_timed, (void *)&tests[i]};
    int failures = _cmocka_run_group_tests(name, wrapped, count, setup, teardown);
    free(wrapped);
    return failures;
}

/* ---- GLSL, files and the program */

bool support_attribute(const char *path, const char *name, Text *value) {
    Text file = {0};
    Error error;
    bool found = file_read(path, STATUS_FAILURE, &file, &error) && image_attribute(&file, name, value);
    text_free(&file);
    return found;
}

SourceStore *support_sources(void) {
    static SourceStore *sources;
    if (!sources) sources = source_store_create("glsl");
    return sources;
}

bool support_flatten(GlslSource *source, const char *library, const char *entry, const GlslSlot *slots,
                     Error *error) {
    SourceStore *store = source_store_create(library);
    /* The tests have shaders of their own. */
    source_folders_add(&store->folders, ".");
    bool ok = glsl_source_create(source, store, entry, slots, error);
    source_store_release(store);
    return ok;
}

static void compile(const Context *context, const char *glsl, Program *program) {
    Text text = {0};
    GlslSource source;
    Error error;
    text_print(&text,
               "#version 330 core\n%s\nout vec4 result;\n"
               "void main() { result = evaluate(floor(gl_FragCoord.xy)); }\n",
               glsl);
    const char *path = support_write("evaluate.glsl", text_string(&text));
    text_free(&text);
    if (!support_flatten(&source, "glsl", path, NULL, &error) ||
        !program_create(program, &context->gl, &source, &error)) {
        fail_msg("%s", error.text);
    }
    glsl_source_destroy(&source);
}

void support_evaluate(const Context *context, const char *glsl, const float *inputs, int width, int height,
                      float *results) {
    const GlApi *gl = &context->gl;
    Program program;
    GLuint framebuffer = 0, textures[2];
    Error error;
    compile(context, glsl, &program);
    textures[0] = texture_create(gl, width, height, GL_NEAREST, NULL);
    textures[1] = texture_create(gl, width, height, GL_NEAREST, inputs);
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[0], 0);
    gl->Viewport(0, 0, width, height);
    program_use(&program);
    if (program_declares(&program, "inputs")) program_set_texture(&program, "inputs", textures[1]);
    program_draw(&program, 0, 0, width, height);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl->ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, results);
    if (!gl_check(gl, "evaluate", &error)) fail_msg("%s", error.text);
    gl->DeleteFramebuffers(1, &framebuffer);
    gl->DeleteTextures(2, textures);
    program_destroy(&program);
}

int support_folder(void **state) {
    (void)state;
    const char *base = getenv("TMPDIR");
    snprintf(folder, sizeof folder, "%s/magichour_test_XXXXXX", base && *base ? base : "/tmp");
    return mkdtemp(folder) ? 0 : -1;
}

int support_clean(void **state) {
    (void)state;
    char command[600];
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    return system(command);
}

const char *support_path(const char *name) {
    /* A name keeps its buffer, so that a path stays good through a test. */
    static char paths[64][768];
    char path[768];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    for (int i = 0; i < 64; i++) {
        if (!paths[i][0]) strcpy(paths[i], path);
        if (strcmp(paths[i], path) == 0) return paths[i];
    }
    fail_msg("too many files in one test");
    return NULL;
}

const char *support_write(const char *name, const char *text) {
    Error error;
    const char *path = support_path(name);
    if (!file_replace(path, text, strlen(text), &error)) fail_msg("%s", error.text);
    return path;
}

static void read_stream(const char *name, char *buffer, size_t size) {
    FILE *file = fopen(support_path(name), "rb");
    size_t got = file ? fread(buffer, 1, size - 1, file) : 0;
    buffer[got] = 0;
    if (file) fclose(file);
}

/* The leak sanitizer now and then fails to stop the threads of a process that ends, and says so. That is no
 * finding, so the command is run once more without the search for leaks. */
static bool sanitizer_broke_down(void) {
    return strstr(support_err, "LeakSanitizer has encountered a fatal error") != NULL;
}

static int run_arguments(const char *environment, const char *format, va_list list) {
    char arguments[4096];
    Text command = {0};
    const char *program = getenv("MAGICHOUR");
    vsnprintf(arguments, sizeof arguments, format, list);
    text_print(&command, "%s '%s' %s >'%s' 2>'%s' </dev/null", environment,
               program ? program : "build/magichour", arguments, support_path("stdout"),
               support_path("stderr"));
    int status = 0;
    for (int tries = 0; tries < 2 && (tries == 0 || sanitizer_broke_down()); tries++) {
        Text again = {0};
        text_print(&again, "%s%s", tries ? "ASAN_OPTIONS=detect_leaks=0 " : "", text_string(&command));
        status = system(text_string(&again));
        text_free(&again);
        read_stream("stdout", support_out, sizeof support_out);
        read_stream("stderr", support_err, sizeof support_err);
    }
    text_free(&command);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int support_run(const char *environment, const char *format, ...) {
    va_list list;
    va_start(list, format);
    int status = run_arguments(environment, format, list);
    va_end(list);
    return status;
}

double support_figure(const char *name) {
    double value = -1;
    char key[64];
    snprintf(key, sizeof key, "\"%s\": ", name);
    const char *done = strstr(support_err, "\"done\": true");
    const char *at = done ? strstr(done, key) : NULL;
    if (at) sscanf(at + strlen(key), "%lf", &value);
    return value;
}

void support_expect(int status, const char *error_part, const char *format, ...) {
    va_list list;
    va_start(list, format);
    int got = run_arguments("", format, list);
    va_end(list);
    bool said = strstr(support_err, error_part) != NULL;
    bool prefixed = status == 0 || strncmp(support_err, "magichour: ", 11) == 0;
    if (got == status && said && prefixed) return;
    fail_msg("'%s': expected status %d and '%s', got %d and: %s", format, status, error_part, got,
             support_err);
}
