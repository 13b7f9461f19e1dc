#include "render/renderer.h"

#include "base/clock.h"
#include "gl/strips.h"

#include <math.h>

void renderer_begin_group(Renderer *renderer, unsigned group) {
    const Program *program = &renderer->program;
    program_use(program);
    program_set_uint(program, "group_samples", group);
    if (program_declares(program, "iFrame"))
        program_set_int(
            program, "iFrame",
            (int)((renderer->first_sample + renderer->film.samples) / renderer->plan.group_samples));
    if (renderer->image.gl) program_set_texture(program, "sun_image_sums", renderer->image.texture);
    film_begin(&renderer->film, program);
}

/* Returns false if it was stopped. */
static bool draw_group(Renderer *renderer, const Rectangle *regions, int count, unsigned group,
                       bool (*stop)(void)) {
    image_pass_draw(&renderer->image, &renderer->film, regions, count, group);
    renderer_begin_group(renderer, group);
    Strips strips = {.program = &renderer->program,
                     .picture = {0, 0, renderer->film.width, renderer->film.height},
                     .regions = regions,
                     .count = count,
                     .samples = group,
                     .stop = stop};
    return strips_draw(&strips, &renderer->pace);
}

/* Traces light paths from the sun, or proposes paths to chains, for about `seconds`. Returns how many. */
static uint64_t splat(Renderer *renderer, uint64_t paths, double seconds) {
    return renderer->chains.gl ? chain_pass_draw(&renderer->chains, &renderer->film, paths, seconds)
                               : photon_pass_draw(&renderer->light, &renderer->film, paths, seconds);
}

/* Splats light for about `seconds`, until there are `paths` of its paths more or `stop` returns true. Returns
 * whether there are. It is not stopped before there is any light: chains have to find their start first. */
static bool trace_light(Renderer *renderer, uint64_t paths, double seconds, bool (*stop)(void)) {
    double end = clock_seconds() + seconds;
    while (paths) {
        uint64_t done = splat(renderer, paths, end - clock_seconds());
        paths = paths > done ? paths - done : 0;
        bool any = renderer->film.light_paths > 0;
        if (clock_seconds() > end || (any && stop && stop())) break;
    }
    return !paths;
}

/* The light paths that are missing if each pixel has so many samples. */
static uint64_t light_due(const Renderer *renderer, double samples) {
    return renderer->chains.gl ? chain_pass_due(&renderer->chains, &renderer->film, samples)
                               : photon_pass_due(&renderer->light, &renderer->film, samples);
}

/* Splats the light that belongs to so many samples of each pixel. */
static bool catch_up(Renderer *renderer, double samples, double seconds, bool (*stop)(void)) {
    return trace_light(renderer, light_due(renderer, samples), seconds, stop);
}

bool renderer_is_behind(const Renderer *renderer) {
    return light_due(renderer, (double)renderer->film.samples) > 0;
}

bool renderer_catch_up(Renderer *renderer, bool (*stop)(void), Error *error) {
    catch_up(renderer, (double)renderer->film.samples, INFINITY, stop);
    return gl_check(renderer->gl, "tracing light paths", error);
}

bool renderer_pass(Renderer *renderer, uint64_t samples, bool (*stop)(void), Error *error) {
    Film *film = &renderer->film;
    unsigned group =
        samples < renderer->plan.group_samples ? (unsigned)samples : renderer->plan.group_samples;
    /* Of a first group that is stopped the finished rows are kept, and the others must be empty. */
    if (!film->samples && stop) film_clear_next(film);
    bool stopped = !draw_group(renderer, &renderer->area, 1, group, stop);
    renderer->partial = stopped && film->samples == 0;
    if (!stopped || film->samples == 0) film_commit(film, group);
    /* Without any light path, the share of the light that they count would be missing. */
    if (!stopped || !(film->light_paths > 0)) catch_up(renderer, (double)film->samples, INFINITY, stop);
    return gl_check(renderer->gl, "drawing a pass", error);
}

bool renderer_refine(Renderer *renderer, const Rectangle *regions, int count, unsigned samples,
                     bool (*stop)(void), bool *stopped, Error *error) {
    *stopped = !draw_group(renderer, regions, count, samples, stop);
    if (!*stopped) film_commit(&renderer->film, 0);
    return gl_check(renderer->gl, "refining regions", error);
}

bool renderer_light(Renderer *renderer, uint64_t paths, bool (*stop)(void), Error *error) {
    trace_light(renderer, paths, INFINITY, stop);
    return gl_check(renderer->gl, "tracing light paths", error);
}

bool renderer_advance(Renderer *renderer, uint64_t samples, double seconds, bool (*stop)(void),
                      Error *error) {
    Film *film = &renderer->film;
    Rectangle all = {0, 0, film->width, film->height};
    double end = clock_seconds() + seconds;
    if (renderer->row == 0) {
        unsigned last = renderer->group;
        renderer->group =
            samples < renderer->plan.group_samples ? (unsigned)samples : renderer->plan.group_samples;
        renderer->pixels_per_second *= (double)last / renderer->group;
    }
    if (renderer->row == 0) image_pass_draw(&renderer->image, film, &all, 1, renderer->group);
    if (renderer->row < film->height) {
        renderer_begin_group(renderer, renderer->group);
        strips_draw_for(&renderer->program, film->width, film->height, &renderer->row,
                        &renderer->pixels_per_second, seconds, stop);
    }
    double wanted = (double)film->samples + renderer->group;
    if (renderer->row == film->height && catch_up(renderer, wanted, end - clock_seconds(), stop)) {
        film_commit(film, renderer->group);
        renderer->row = 0;
    }
    return gl_check(renderer->gl, "drawing a pass", error);
}

bool renderer_archive(Renderer *renderer, Archive *archive, Error *error) {
    return film_archive(&renderer->film, archive, error) &&
           chain_pass_archive(&renderer->chains, archive, error);
}
