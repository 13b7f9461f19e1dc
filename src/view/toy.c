#include "view/toy.h"

#include "gl/strips.h"

#include <math.h>
#include <string.h>
#include <time.h>

enum { CHANNELS = 4 };

bool toy_compile(Toy *toy, const Context *context, const SceneFile *file, Error *error) {
    const GlslSlot slots[] = {{"scene", file->path, NULL}, {NULL, NULL, NULL}};
    GlslSource source;
    Program program;
    if (!glsl_source_create(&source, file->sources, "pass/shadertoy.glsl", slots, error)) return false;
    bool ok = program_create(&program, &context->gl, &source, error);
    glsl_source_destroy(&source);
    if (!ok) return false;
    program_destroy(&toy->program);
    toy->program = program;
    toy->row = 0;
    /* A low guess for the first draw. */
    toy->pixels_per_second = 1e5;
    return true;
}

void toy_destroy(Toy *toy) {
    program_destroy(&toy->program);
    target_destroy(&toy->target);
    *toy = (Toy){0};
}

void toy_restart(Toy *toy) {
    if (toy->target.gl) target_clear(&toy->target);
    toy->frame = toy->row = 0;
    toy->time_s = 0;
}

bool toy_resize(Toy *toy, const Context *context, int width, int height, Error *error) {
    Target *target = &toy->target;
    if (target->gl && target->width == width && target->height == height) return true;
    target_destroy(target);
    if (!target_create(target, context, width, height, 1, error)) return false;
    toy_restart(toy);
    return true;
}

static void tell_date(const Program *program) {
    time_t now = time(NULL);
    struct tm local = {0};
    localtime_r(&now, &local);
    double date[4] = {local.tm_year + 1900, local.tm_mon, local.tm_mday,
                      local.tm_hour * 3600 + local.tm_min * 60 + local.tm_sec};
    program_set_vec4(program, "iDate", date);
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
        program_set_float(&toy->program, times[i], toy->time_s);
    }
    program_set_vec3(&toy->program, "iResolution", size);
}

static bool tell(const Toy *toy, Error *error) {
    static const char *const names[] = {"iChannel0"};
    const Program *program = &toy->program;
    program_use(program);
    tell_channels(toy);
    tell_date(program);
    target_begin(&toy->target, program, names);
    program_set_float(program, "iTime", toy->time_s);
    program_set_float(program, "iTimeDelta", toy->delta_s);
    program_set_float(program, "iFrameRate", toy->delta_s > 0 ? 1 / toy->delta_s : 60);
    program_set_float(program, "iSampleRate", 44100);
    program_set_int(program, "iFrame", toy->frame);
    program_set_vec4(program, "iMouse", toy->mouse);
    return program_check(program, error);
}

bool toy_draw(Toy *toy, double seconds, double time_s, const double mouse[4], bool (*stop)(void),
              Error *error) {
    Target *target = &toy->target;
    if (toy->row == 0) {
        toy->delta_s = fmax(time_s - toy->time_s, 0);
        toy->time_s = time_s;
        memcpy(toy->mouse, mouse, sizeof toy->mouse);
    }
    if (!tell(toy, error)) return false;
    strips_draw_for(&toy->program, target->width, target->height, &toy->row, &toy->pixels_per_second, seconds,
                    stop);
    if (toy->row == target->height) {
        target_swap(target);
        toy->row = 0;
        toy->frame++;
    }
    return gl_check(toy->program.gl, "drawing mainImage()", error);
}

GLuint toy_texture(const Toy *toy) {
    return toy->target.textures[toy->target.front][0];
}
