#include "view/pane.h"

#include "base/clock.h"
#include "base/text.h"
#include "render/check.h"
#include "view/say.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COARSEST = 8, MOST_PREVIEW_SAMPLES = 16, CHECK_SAMPLES = 64 };

static bool same_methods(const MethodNames *a, const MethodNames *b) {
    return strcmp(a->sky, b->sky) == 0 && strcmp(a->light, b->light) == 0 &&
           strcmp(a->sequence, b->sequence) == 0 && strcmp(a->further, b->further) == 0 &&
           strcmp(a->sun_disk, b->sun_disk) == 0;
}

static bool same_picture(const Pane *pane, const PaneParams *params) {
    /* The renderer does not use the exposure. */
    Scene scene = *params->scene;
    scene.values.exposure_ev = pane->scene.values.exposure_ev;
    return scene_same(&scene, &pane->scene) && same_methods(&pane->methods, params->methods) &&
           pane->width == params->width && pane->height == params->height;
}

/* The choice is the same for every sun. One that followed the sun would compile programs while the sun is
 * dragged. */
static const char *sky_of(const PaneParams *params) {
    const Atmosphere *a = &params->scene->values.atmosphere;
    if (*params->methods->sky || params->scene->file->sky[0]) return method_name(params->methods->sky);
    return a->observer_height_m > a->top_radius_m - a->planet_radius_m ? "gauss:8" : "table";
}

/* The quality of the further orders does not follow the sun, as auto's would: tables of another quality take
 * longer to fill than a hand waits. */
static const char *further_of(const PaneParams *params) {
    const char *name = method_name(params->methods->further);
    return name ? name : method_family(METHOD_FURTHER)->fallback;
}

static RenderParams render_params(const PaneParams *params, int coarseness, bool preview) {
    return (RenderParams){.scene = params->scene,
                          .sky = sky_of(params),
                          .further = further_of(params),
                          .light = method_name(params->methods->light),
                          .sequence = method_name(params->methods->sequence),
                          .sun_disk = method_name(params->methods->sun_disk),
                          .width = (params->width + coarseness - 1) / coarseness,
                          .height = (params->height + coarseness - 1) / coarseness,
                          .seed = params->seed,
                          .max_hits = params->max_hits,
                          .variance = true,
                          .in_steps = true,
                          .use = preview ? PICTURE_PREVIEW : PICTURE_AT_REST};
}

/* The number of paths that a preview may have. With a sample or two a pixel, a path takes about twice its
 * time at rest. */
static double affordable_paths(const Pane *pane, const PaneParams *params) {
    double rate = pane->preview_rate > 0 ? pane->preview_rate : pane->paths_per_second / 2;
    return rate > 0 ? rate * params->budget_s : (double)params->width * params->height / 16;
}

/* The finest preview that the budget allows, with a margin that keeps it from changing back and forth. */
static int choose_coarseness(const Pane *pane, const PaneParams *params) {
    double pixels = (double)params->width * params->height, paths = affordable_paths(pane, params);
    int finest = 1;
    while (finest < COARSEST && pixels / (finest * finest) > paths) finest *= 2;
    int last = pane->coarseness;
    bool may_stay = last > finest && pixels / (finest * finest) > 0.7 * paths;
    return may_stay && last == 2 * finest ? last : finest;
}

static unsigned choose_samples(const Pane *pane, const PaneParams *params, int coarseness) {
    double pixels = (double)params->width * params->height / (coarseness * coarseness);
    return (unsigned)fmin(fmax(floor(affordable_paths(pane, params) / pixels), 1), MOST_PREVIEW_SAMPLES);
}

bool pane_is_ready(const Pane *pane) {
    return pane->renderer.prepared == 1;
}

/* The preview and the picture at rest have a film each, and the films change places. */
static void exchange_films(Pane *pane) {
    Film film = pane->renderer.film;
    pane->renderer.film = pane->kept;
    pane->kept = film;
}

static void forget_figures(Pane *pane) {
    pane->seconds = 0;
    pane->paths = 0;
    estimate_reset(&pane->estimate);
    pane->curve.count = 0;
}

static void remember(Pane *pane, const PaneParams *params, int coarseness) {
    Scene scene = scene_share(params->scene);
    if (scene.file != pane->scene.file) {
        pane->checked = false;
        pane->wrong[0] = 0;
    }
    scene_destroy(&pane->scene);
    pane->scene = scene;
    pane->methods = *params->methods;
    pane->width = params->width;
    pane->height = params->height;
    pane->coarseness = coarseness;
    pane->begun = clock_seconds();
    forget_figures(pane);
}

/* Whether the picture that is shown has to make room for another film. A preview follows one of its size at
 * once, and if it has to wait for tables, the renderer keeps the one of before. */
static bool must_exchange(const Pane *pane, const PaneParams *params, const RenderParams *wanted,
                          bool preview) {
    const Film *film = &pane->renderer.film;
    bool same_film = film->width == wanted->width && film->height == wanted->height &&
                     same_methods(&pane->methods, params->methods);
    return film->samples && !(preview && same_film);
}

/* Whether a preview can go on in the film of the last one, which is shown because the picture at rest has not
 * come to its first samples. The film of the picture at rest is then kept for the next rest. */
static bool may_go_back(const Pane *pane, const RenderParams *wanted, bool preview) {
    const Film *kept = &pane->kept;
    return preview && !pane->renderer.film.samples && kept->samples && kept->width == wanted->width &&
           kept->height == wanted->height;
}

static bool start(Pane *pane, const PaneParams *params, bool preview, int coarseness, Error *error) {
    RenderParams wanted = render_params(params, coarseness, preview);
    if (!pane->renderer.gl) return renderer_create(&pane->renderer, params->context, &wanted, error);
    bool exchanged = must_exchange(pane, params, &wanted, preview),
         back = may_go_back(pane, &wanted, preview);
    if (exchanged || back) exchange_films(pane);
    /* What this film held is older than what is shown. */
    if (exchanged) pane->renderer.film.samples = 0;
    if (renderer_restart(&pane->renderer, params->context, &wanted, error)) return true;
    if (exchanged || back) exchange_films(pane);
    return false;
}

bool pane_update(Pane *pane, const PaneParams *params, Error *error) {
    bool same = pane->renderer.gl && same_picture(pane, params), previews = pane->preview_samples > 0;
    bool preview = !params->whole && (!same || (previews && params->moving));
    pane->changed = false;
    if (same && preview == previews) return true;
    int coarseness = preview ? choose_coarseness(pane, params) : 1;
    if (!start(pane, params, preview, coarseness, error)) return false;
    pane->preview_samples = preview ? choose_samples(pane, params, coarseness) : 0;
    remember(pane, params, coarseness);
    pane->changed = !same;
    return true;
}

bool pane_compile(const PaneParams *params, Renderer *next, Error *error) {
    RenderParams wanted = render_params(params, 1, false);
    return renderer_create(next, params->context, &wanted, error);
}

void pane_take(Pane *pane, const PaneParams *params, const Renderer *next) {
    if (pane->renderer.film.samples) exchange_films(pane);
    renderer_destroy(&pane->renderer);
    pane->renderer = *next;
    pane->preview_samples = 0;
    remember(pane, params, 1);
    pane->changed = true;
}

void pane_hurry(Pane *pane) {
    /* No picture has this size. */
    pane->width = 0;
}

void pane_destroy(Pane *pane) {
    renderer_destroy(&pane->renderer);
    film_destroy(&pane->kept);
    estimate_destroy(&pane->estimate);
    scene_destroy(&pane->scene);
    *pane = (Pane){0};
}

bool pane_rests(const Pane *pane, const PaneParams *params) {
    return pane_is_ready(pane) && !pane->preview_samples && pane->renderer.film.samples >= params->samples &&
           pane->estimate.stage == ESTIMATE_DONE;
}

/* A program's first draw includes compiling it, so it is left out of the measured speed. */
static void measure(Pane *pane, double rate) {
    bool first = pane->measured != pane->renderer.program.id;
    double *known = pane->preview_samples ? &pane->preview_rate : &pane->paths_per_second;
    pane->measured = pane->renderer.program.id;
    if (!first) *known = *known > 0 ? 0.7 * *known + 0.3 * rate : rate;
}

/* Draws samples, or rows of them. */
static bool draw_samples(Pane *pane, const PaneParams *params, Error *error) {
    Renderer *renderer = &pane->renderer;
    const Film *film = &renderer->film;
    uint64_t samples = pane->preview_samples ? pane->preview_samples : params->samples - film->samples;
    /* A preview is shown when all of it is drawn. */
    double budget = pane->preview_samples ? INFINITY : params->budget_s, begin = clock_seconds();
    int first_row = renderer->row;
    uint64_t before = film->samples;
    if (!renderer_advance(renderer, samples, budget, params->stop, error)) return false;
    double taken = fmax(clock_seconds() - begin, 1e-6);
    int rows = film->samples > before ? film->height - first_row : renderer->row - first_row;
    uint64_t paths = (uint64_t)rows * (uint64_t)film->width * renderer->group;
    if (paths) measure(pane, (double)paths / taken);
    pane->paths += paths;
    pane->seconds += taken;
    if (!pane->preview_samples && film->samples > before)
        estimate_begin(&pane->estimate, renderer, params->scene->values.exposure_ev);
    return true;
}

/* Looks for values that no surface can have, once for each file, when the picture has been at rest for a
 * while: the check compiles a program. */
static bool check_values(Pane *pane, const PaneParams *params, const RenderParams *wanted, Error *error) {
    Check check;
    Text lines = {0};
    if (pane->checked || pane->preview_samples || pane->renderer.film.samples < CHECK_SAMPLES) return true;
    pane->checked = true;
    /* In the midst of an edit a file may be gone. Reading it anew says so, and what is shown may stay. */
    if (!check_scene(&check, params->context, wanted, &pane->renderer, error))
        return error->status == STATUS_SCENE;
    check_print(&check, NULL, &lines);
    snprintf(pane->wrong, sizeof pane->wrong, "%s", text_string(&lines));
    text_free(&lines);
    say_check(&check, params->scene->file->path);
    return true;
}

bool pane_draw(Pane *pane, const PaneParams *params, Error *error) {
    Renderer *renderer = &pane->renderer;
    Estimate *estimate = &pane->estimate;
    RenderParams wanted = render_params(params, pane->coarseness, pane->preview_samples > 0);
    if (pane_rests(pane, params)) return true;
    /* Events do not cut this short, or a hand that drags the sun would bring it to a stop. */
    if (!renderer_prepare(renderer, &wanted, 2 * params->budget_s, NULL, error)) return false;
    if (!pane_is_ready(pane)) return true;
    bool draws = estimate->stage == ESTIMATE_DONE;
    uint64_t before = renderer->film.samples;
    if (!(draws ? draw_samples(pane, params, error) : estimate_step(estimate, renderer, error))) return false;
    /* The curve has a point for each error that was found, and none for the time in between. */
    bool found = estimate->stage == ESTIMATE_DONE && (!draws || renderer->film.samples > before);
    if (found) curve_extend(&pane->curve, pane->seconds, estimate->error_percent);
    return check_values(pane, params, &wanted, error);
}

void pane_figures(const Pane *pane, SideFigures *figures) {
    const Renderer *renderer = &pane->renderer;
    figures->prepared = renderer->gl ? renderer->prepared : 1;
    figures->waited_s = pane_is_ready(pane) ? 0 : clock_seconds() - pane->begun;
    if (!renderer->gl) return;
    const char *disk = renderer->plan.sun.text;
    bool has_disk = renderer->plan.sun.method->has_disk;
    snprintf(figures->methods, sizeof figures->methods, "%s, %s, %s%s%s", renderer->plan.sky.text,
             renderer->plan.light.text, renderer->plan.sequence.text, has_disk ? ", disk " : "",
             has_disk ? disk : "");
    figures->samples = pane_is_ready(pane) ? renderer->film.samples : 0;
    figures->error_percent = pane->estimate.error_percent;
    figures->error_levels = pane->estimate.error_levels;
    figures->worst_levels = pane->estimate.worst_levels;
    figures->chance_percent = pane->estimate.chance_percent;
    bool preview = pane->preview_samples && pane->preview_rate > 0;
    figures->paths_per_second = preview ? pane->preview_rate : pane->paths_per_second;
    figures->seconds = pane->seconds;
    figures->coarseness = pane->preview_samples ? pane->coarseness : 1;
    figures->curve = pane->curve;
    memcpy(figures->wrong, pane->wrong, sizeof figures->wrong);
}
