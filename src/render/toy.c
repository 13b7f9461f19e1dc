#include "render/toy.h"

#include "base/lines.h"
#include "base/memory.h"
#include "gl/strips.h"
#include "render/inputs.h"
#include "scene/toy_source.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

enum { CHANNELS = 4, OUTPUTS = 2, CUT = 1 };

static bool compile(Program *program, Text *notes, const Context *context, const ToyParams *params,
                    Error *error) {
    GlslSource source;
    if (!toy_source_create(&source, notes, params, error)) return false;
    bool ok = program_create(program, &context->gl, &source, error);
    glsl_source_destroy(&source);
    return ok;
}

/* If the text with zeros in it is refused, the fault is looked for in the text as it was written. */
static bool compile_any(Program *program, Text *notes, const Context *context, ToyParams params,
                        Error *error) {
    Text found = {0};
    bool ok = compile(program, &found, context, &params, error);
    if (!ok && error->status == STATUS_SCENE) {
        text_free(&found);
        params.without_zero = true;
        ok = compile(program, &found, context, &params, error);
        text_print(
            &found,
            "%s:1: variables that are not set are not 0 here: its macros hide where they are declared\n",
            params.buffer ? params.file->buffer : params.file->path);
    }
    if (ok) text_print(notes, "%s", text_string(&found));
    text_free(&found);
    return ok;
}

/* Puts a new program in place of the old one. */
static void put(Toy *toy, Program program) {
    program_destroy(&toy->program);
    toy->program = program;
    toy->row = 0;
    /* A low guess for the first draw. */
    toy->pixels_per_second = 1e5;
}

static void put_buffer(Toy *toy, const Program *program) {
    if (program) {
        if (!toy->buffer) toy->buffer = memory_get(1, sizeof *toy->buffer);
        put(toy->buffer, *program);
    } else if (toy->buffer) {
        toy_destroy(toy->buffer);
        free(toy->buffer);
        toy->buffer = NULL;
    }
}

bool toy_compile(Toy *toy, const Context *context, const SceneFile *file, Error *error) {
    Program program, buffer;
    Text notes = {0};
    bool ok = compile_any(&program, &notes, context, (ToyParams){.file = file}, error);
    if (ok && file->buffer) {
        ok = compile_any(&buffer, &notes, context, (ToyParams){.file = file, .buffer = true}, error);
        if (!ok) program_destroy(&program);
    }
    if (!ok) {
        text_free(&notes);
        return false;
    }
    put(toy, program);
    put_buffer(toy, file->buffer ? &buffer : NULL);
    text_free(&toy->notes);
    toy->notes = notes;
    return true;
}

void toy_destroy(Toy *toy) {
    put_buffer(toy, NULL);
    program_destroy(&toy->program);
    target_destroy(&toy->target);
    text_free(&toy->notes);
    *toy = (Toy){0};
}

void toy_restart(Toy *toy) {
    if (toy->buffer) toy_restart(toy->buffer);
    if (toy->target.gl) target_clear(&toy->target);
    toy->frame = toy->row = 0;
}

bool toy_resize(Toy *toy, const Context *context, int width, int height, Error *error) {
    Target *target = &toy->target;
    if (toy->buffer && !toy_resize(toy->buffer, context, width, height, error)) return false;
    if (target->gl && target->width == width && target->height == height) return true;
    target_destroy(target);
    if (!target_create(target, context, width, height, (1 << OUTPUTS) - 1, error)) return false;
    toy_restart(toy);
    return true;
}

/* Pictures that are to be the same again have a date that follows iTime. */
static void tell_date(const Toy *toy) {
    double date[4] = {2000, 0, 1, toy->moment.time_s};
    if (toy->moment.by_clock) {
        struct timespec now = {0};
        struct tm local = {0};
        clock_gettime(CLOCK_REALTIME, &now);
        localtime_r(&now.tv_sec, &local);
        date[0] = local.tm_year + 1900, date[1] = local.tm_mon, date[2] = local.tm_mday;
        date[3] = local.tm_hour * 3600 + local.tm_min * 60 + local.tm_sec + 1e-9 * (double)now.tv_nsec;
    }
    program_set_vec4(&toy->program, "iDate", date);
}

/* The first channel is the frame before. The others are black. */
static void tell_channels(const Toy *toy) {
    static const char *const names[CHANNELS] = {"iChannel0", "iChannel1", "iChannel2", "iChannel3"};
    static const char *const sizes[CHANNELS] = {"iChannelResolution[0]", "iChannelResolution[1]",
                                                "iChannelResolution[2]", "iChannelResolution[3]"};
    static const char *const times[CHANNELS] = {"iChannelTime[0]", "iChannelTime[1]", "iChannelTime[2]",
                                                "iChannelTime[3]"};
    static const double none[3] = {1, 1, 1};
    double size[3] = {toy->target.width, toy->target.height, 1};
    for (int i = 0; i < CHANNELS; i++) {
        if (i) program_set_texture(&toy->program, names[i], 0);
        program_set_vec3(&toy->program, sizes[i], i ? none : size);
        program_set_float(&toy->program, times[i], toy->moment.time_s);
    }
    program_set_vec3(&toy->program, "iResolution", size);
}

static bool tell(const Toy *toy, const Scene *scene, Error *error) {
    static const char *const names[OUTPUTS] = {"iChannel0", NULL};
    const Program *program = &toy->program;
    const ToyMoment *moment = &toy->moment;
    Uniforms parameters = {0};
    program_use(program);
    tell_channels(toy);
    tell_date(toy);
    target_begin(&toy->target, program, names);
    if (toy->buffer) program_set_texture(program, "iChannel0", toy_texture(toy->buffer));
    program_set_float(program, "iTime", moment->time_s);
    program_set_float(program, "iTimeDelta", moment->delta_s);
    program_set_float(program, "iFrameRate", moment->delta_s > 0 ? 1 / moment->delta_s : 60);
    program_set_float(program, "iSampleRate", 44100);
    program_set_int(program, "iFrame", toy->frame);
    program_set_vec4(program, "iMouse", moment->mouse);
    program_set_vec3(program, "shadertoy_shift", moment->shift);
    program_set_int(program, "shadertoy_turns", 3);
    inputs_parameters(scene, &parameters);
    program_set(program, &parameters);
    uniforms_free(&parameters);
    return program_check(program, error);
}

static bool draw(Toy *toy, const Scene *scene, double seconds, bool (*stop)(void), Error *error) {
    Target *target = &toy->target;
    if (!tell(toy, scene, error)) return false;
    strips_draw_for(&toy->program, target->width, target->height, &toy->row, &toy->pixels_per_second, seconds,
                    stop);
    if (toy->row == target->height) {
        target_swap(target);
        toy->row = 0;
        toy->frame++;
    }
    return gl_check(toy->program.gl, "drawing mainImage()", error);
}

/* Both draw the same frame at the same moment. */
bool toy_draw(Toy *toy, const Scene *scene, const ToyMoment *moment, double seconds, bool (*stop)(void),
              Error *error) {
    Toy *buffer = toy->buffer;
    if (buffer && buffer->frame <= toy->frame) {
        if (buffer->row == 0) buffer->moment = *moment;
        return draw(buffer, scene, seconds, stop, error);
    }
    if (toy->row == 0) toy->moment = buffer ? buffer->moment : *moment;
    return draw(toy, scene, seconds, stop, error);
}

void toy_say_notes(const Toy *toy, FILE *out) {
    Lines lines = lines_of(text_string(&toy->notes));
    for (const char *line; (line = lines_next(&lines));) fprintf(out, "magichour: warning: %s\n", line);
    lines_free(&lines);
}

GLuint toy_texture(const Toy *toy) {
    return toy->target.textures[toy->target.front][0];
}

bool toy_cut_share(const Toy *toy, double *share, Error *error) {
    size_t pixels = (size_t)toy->target.width * (size_t)toy->target.height, cut = 0;
    float *texels = memory_get(4 * pixels, sizeof *texels);
    double before = 0;
    bool ok = target_read(&toy->target, CUT, texels, error) &&
              (!toy->buffer || toy_cut_share(toy->buffer, &before, error));
    for (size_t i = 0; ok && i < pixels; i++) cut += texels[4 * i] > 0.5f;
    *share = fmax((double)cut / (double)pixels, before);
    free(texels);
    return ok;
}
