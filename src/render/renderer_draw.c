#include "render/renderer_draw.h"

#include "gl/strips.h"

void renderer_begin_group(Renderer *renderer, unsigned group) {
    const Program *program = &renderer->program;
    program_use(program);
    program_set_uint(program, "group_samples", group);
    if (program_declares(program, "iFrame"))
        program_set_int(program, "iFrame", (int)(renderer->film.samples / renderer->plan.group_samples));
    if (renderer->image.gl) program_set_texture(program, "sun_image_sums", renderer->image.texture);
    film_begin(&renderer->film, program);
}

/* Returns false if it was stopped. */
static bool draw_group(Renderer *renderer, const Rectangle *regions, int count, unsigned group,
                       bool (*stop)(void)) {
    image_pass_draw(&renderer->image, &renderer->film, regions, count, group);
    renderer_begin_group(renderer, group);
    return strips_draw(&renderer->program, regions, count, &renderer->pixels_per_second, stop);
}

/* Traces the light paths that belong to the film's samples. */
static void catch_up(Renderer *renderer, bool (*stop)(void)) {
    uint64_t due = photon_pass_due(&renderer->light, (double)renderer->film.samples);
    while (due) {
        uint64_t done = photon_pass_draw(&renderer->light, &renderer->film, due);
        due = due > done ? due - done : 0;
        renderer->gl->Finish();
        if (stop && stop()) return;
    }
}

bool renderer_pass(Renderer *renderer, uint64_t samples, bool (*stop)(void), Error *error) {
    Film *film = &renderer->film;
    Rectangle all = {0, 0, film->width, film->height};
    unsigned group =
        samples < renderer->plan.group_samples ? (unsigned)samples : renderer->plan.group_samples;
    /* Of a first group that is stopped the finished rows are kept, and the others must be empty. */
    if (!film->samples && stop) film_clear_next(film);
    bool stopped = !draw_group(renderer, &all, 1, group, stop);
    if (!stopped || film->samples == 0) film_commit(film, group);
    if (!stopped) catch_up(renderer, stop);
    return gl_check(renderer->gl, "drawing a pass", error);
}

bool renderer_refine(Renderer *renderer, const Rectangle *regions, int count, unsigned samples,
                     bool (*stop)(void), bool *stopped, Error *error) {
    *stopped = !draw_group(renderer, regions, count, samples, stop);
    if (!*stopped) film_commit(&renderer->film, 0);
    return gl_check(renderer->gl, "refining regions", error);
}

bool renderer_advance(Renderer *renderer, uint64_t samples, double seconds, bool (*stop)(void),
                      Error *error) {
    Film *film = &renderer->film;
    Rectangle all = {0, 0, film->width, film->height};
    if (renderer->row == 0) {
        unsigned last = renderer->group;
        renderer->group =
            samples < renderer->plan.group_samples ? (unsigned)samples : renderer->plan.group_samples;
        renderer->pixels_per_second *= (double)last / renderer->group;
    }
    if (renderer->row == 0) image_pass_draw(&renderer->image, film, &all, 1, renderer->group);
    renderer_begin_group(renderer, renderer->group);
    strips_draw_for(&renderer->program, film->width, film->height, &renderer->row,
                    &renderer->pixels_per_second, seconds, stop);
    if (renderer->row == film->height) {
        film_commit(film, renderer->group);
        renderer->row = 0;
    }
    return gl_check(renderer->gl, "drawing a pass", error);
}
