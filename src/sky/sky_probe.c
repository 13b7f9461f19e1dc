#include "sky/sky_probe.h"

#include "base/clock.h"
#include "base/memory.h"
#include "gl/texture.h"
#include "sky/further.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Each draw looks up at most SIDE x SIDE directions. */
enum { SIDE = 256 };

/* What the texts of the sky's programs are made from. */
typedef struct Texts {
    SourceStore *sources;
    SlotList slots;
} Texts;

static bool make_text(const void *data, const char *entry, GlslSource *source, Error *error) {
    const Texts *texts = data;
    return glsl_source_create(source, texts->sources, entry, texts->slots.slots, error);
}

static bool create_programs(SkyProbe *probe, const Context *context, SourceStore *sources,
                            const Atmosphere *atmosphere, Error *error) {
    static const ResourceKind *const kinds[] = {FURTHER_TABLES, &sky_table, NULL};
    Frame frame = {.state.atmosphere = *atmosphere, .sky = &probe->choice, .further = &probe->further};
    Texts texts = {.sources = sources};
    ResourceTexts maker = {make_text, &texts};
    GlslSource source = {0};
    sky_slots(&texts.slots, &probe->choice, atmosphere);
    bool ok = resources_create(&probe->tables, context, kinds, &frame, &maker, error) &&
              make_text(&texts, "pass/sky_probe.glsl", &source, error) &&
              program_create(&probe->program, probe->gl, &source, error);
    glsl_source_destroy(&source);
    slot_list_free(&texts.slots);
    return ok;
}

bool sky_probe_create(SkyProbe *probe, const Context *context, SourceStore *sources,
                      const MethodChoice *choice, const Atmosphere *atmosphere, Error *error) {
    const GlApi *gl = &context->gl;
    *probe = (SkyProbe){.gl = gl, .choice = *choice};
    if (!method_choose(&probe->further, METHOD_FURTHER, NULL, error) ||
        !create_programs(probe, context, sources, atmosphere, error))
        goto fail;
    probe->texture[0] = texture_create(gl, SIDE, SIDE, GL_NEAREST, NULL);
    probe->texture[1] = texture_create(gl, SIDE, SIDE, GL_NEAREST, NULL);
    gl->GenFramebuffers(1, &probe->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, probe->framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, probe->texture[1], 0);
    if (gl_check(gl, "sky probe", error)) return true;
fail:
    sky_probe_destroy(probe);
    return false;
}

void sky_probe_destroy(SkyProbe *probe) {
    const GlApi *gl = probe->gl;
    if (!gl) return;
    if (probe->framebuffer) gl->DeleteFramebuffers(1, &probe->framebuffer);
    gl->DeleteTextures(2, probe->texture);
    program_destroy(&probe->program);
    resources_destroy(&probe->tables);
    *probe = (SkyProbe){0};
}

/* Fills the tables that are out of date. `uniforms`, which is empty, gets those of the frame and of the
 * tables. */
static bool fill(SkyProbe *probe, const Frame *frame, Uniforms *uniforms, Error *error) {
    double share = 0, seconds = probe->watch ? SKY_WATCH_SECONDS : INFINITY;
    do {
        uniforms_free(uniforms);
        sky_uniforms(frame, uniforms);
        if (!resources_prepare_for(&probe->tables, frame, uniforms, seconds, NULL, &share, error) ||
            !sky_watch_ask(probe->watch, share, error))
            return false;
    } while (share < 1);
    return true;
}

/* Makes the sky's tables ready for this state and the probe's program the one in use. */
static bool use(SkyProbe *probe, const SkyState *state, Error *error) {
    Frame frame = {.state = *state, .sky = &probe->choice, .further = &probe->further};
    Uniforms uniforms = {0};
    bool ok = fill(probe, &frame, &uniforms, error);
    if (ok) {
        program_use(&probe->program);
        program_set(&probe->program, &uniforms);
        resources_give(&probe->tables, &probe->program);
        program_set_texture(&probe->program, "probe_directions", probe->texture[0]);
        ok = program_check(&probe->program, error);
    }
    uniforms_free(&uniforms);
    return ok;
}

/* Looks up at most SIDE x SIDE directions. Textures take whole rows, so the directions pass through `rows`,
 * which has room for as many. */
static bool ask_some(SkyProbe *probe, const float *directions, size_t count, float *radiances, float *rows,
                     Error *error) {
    const GlApi *gl = probe->gl;
    int height = (int)((count + SIDE - 1) / SIDE);
    memset(rows, 0, (size_t)height * SIDE * 4 * sizeof *rows);
    memcpy(rows, directions, count * 4 * sizeof *rows);
    gl->BindFramebuffer(GL_FRAMEBUFFER, probe->framebuffer);
    gl->Viewport(0, 0, SIDE, SIDE);
    texture_resize(gl, probe->texture[0], SIDE, height, rows);
    program_draw(&probe->program, 0, 0, SIDE, height);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl->ReadPixels(0, 0, SIDE, height, GL_RGBA, GL_FLOAT, rows);
    memcpy(radiances, rows, count * 4 * sizeof *rows);
    return gl_check(gl, "asking the sky", error);
}

bool sky_probe_ask(SkyProbe *probe, const SkyState *state, const float *directions, size_t count,
                   float *radiances, Error *error) {
    if (!use(probe, state, error)) return false;
    size_t most = (size_t)SIDE * SIDE, full_rows = (count + SIDE - 1) / SIDE;
    float *rows = memory_get((full_rows < SIDE ? full_rows : SIDE) * SIDE * 4, sizeof *rows);
    bool ok = true;
    for (size_t done = 0; ok && done < count; done += most) {
        size_t some = count - done < most ? count - done : most;
        ok = ask_some(probe, directions + 4 * done, some, radiances + 4 * done, rows, error);
    }
    free(rows);
    return ok;
}

bool sky_probe_time(SkyProbe *probe, const SkyState *state, const float *directions, size_t count,
                    double seconds, double *lookup_seconds, Error *error) {
    const GlApi *gl = probe->gl;
    size_t most = (size_t)SIDE * SIDE, asked = count < most ? count : most;
    int height = (int)((asked + SIDE - 1) / SIDE);
    float *radiances = memory_get(asked, 4 * sizeof *radiances);
    bool ok = sky_probe_ask(probe, state, directions, asked, radiances, error);
    double first = clock_seconds(), best = INFINITY;
    for (int i = 0; ok && (i < 1 || clock_seconds() - first < seconds); i++) {
        double start = clock_seconds();
        program_draw(&probe->program, 0, 0, SIDE, height);
        gl->Finish();
        best = fmin(best, clock_seconds() - start);
        ok = gl_check(gl, "asking the sky", error);
    }
    free(radiances);
    *lookup_seconds = best / ((double)SIDE * height);
    return ok;
}
