#include "chart/chart_paths.h"
#include "base/memory.h"
#include "chart/chart.h"
#include "chart/identity.h"
#include "choice/method.h"
#include "sky/sun.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

/* Shares of the time. */
static const double reference_share = 0.3, timing_share = 0.3;

/* A curve ends below this many times the reference's own noise. There, the noise makes up 8 % of the error,
 * and is subtracted. */
static const double least_over_reference = 2.5;

static void add(Paths *paths, const Drawn *curve) {
    if (paths->count < MOST_CURVES) paths->curves[paths->count++] = *curve;
}

/* Says whether the sky that the scene gets by default is one that integrates along the ray. */
static bool sky_integrates(const RenderParams *picture) {
    MethodChoice choice;
    Error ignored;
    return !picture->scene->file->sky[0] ||
           (method_choose(&choice, METHOD_SKY, picture->scene->file->sky, &ignored) &&
            choice.method->integrates);
}

/* Whether the picture may be drawn by Markov chains: light paths from the sun do not go with them. */
static bool may_walk_chains(const RenderParams *picture) {
    MethodChoice sun;
    Error ignored;
    return method_is_auto(picture->sun_disk) ||
           (method_choose(&sun, METHOD_SUN, picture->sun_disk, &ignored) && !sun.method->traces_light);
}

/* Says whether the picture's sunlight is traced from the sun. */
static bool traces_light(const RenderParams *picture) {
    MethodChoice choice;
    Error ignored;
    return sun_choose(&choice, picture->sun_disk, picture->scene, &ignored) && choice.method->traces_light;
}

/* Adds a light method with the sky that auto takes: once with adaptive and once with even sampling. If `all`
 * is set, even sampling is added for the other sequences too. */
static void add_light(Paths *paths, const char *light, const char *disk, int color, bool all) {
    static const struct {
        const char *sequence;
        PlotMarker marker;
    } others[] = {{"additive", PLOT_SQUARE}, {"random", PLOT_TRIANGLE}, {"metropolis", PLOT_DIAMOND}};
    int count = !all ? 0 : may_walk_chains(&paths->params->picture) ? 3 : 2;
    Drawn drawn = {.combination = {NULL, light, "sobol", true, disk},
                   .panels = PANEL_LIGHTS,
                   .color = color,
                   .marker = PLOT_DIAMOND,
                   .line = PLOT_SOLID};
    add(paths, &drawn);
    drawn.combination.adaptive = false;
    drawn.marker = PLOT_DOT;
    drawn.line = PLOT_DASHED;
    add(paths, &drawn);
    for (int i = 0; i < count; i++) {
        drawn.combination.sequence = others[i].sequence;
        drawn.marker = others[i].marker;
        drawn.line = PLOT_DOTTED;
        add(paths, &drawn);
    }
}

/* The first curve is what `render` does by default. `--light paper` is left out, because it converges to a
 * different picture. */
static void choose_curves(Paths *paths) {
    static const char *const skies[] = {NULL,       "gauss:4",    "gauss:6",    "gauss:8",
                                        "gauss:12", "paper:16x4", "paper:64x16"};
    const RenderParams *picture = &paths->params->picture;
    bool integrates = sky_integrates(picture);
    bool control = integrates && scene_hint_count(picture->scene, HINT_BOUND);
    add(paths, &(Drawn){.combination = {.adaptive = true}});
    if (control) add_light(paths, "control", NULL, 0, true);
    add_light(paths, "mis", NULL, 1, false);
    add_light(paths, "cosine", NULL, 2, !control);
    if (scene_hint_count(picture->scene, HINT_PORTAL)) add_light(paths, "portal", NULL, 3, false);
    if (traces_light(picture)) add_light(paths, "cosine", "sampled", 5, false);
    for (int i = 0; integrates && i < 7; i++) {
        add(paths, &(Drawn){.combination = {.sky = skies[i], .light = "cosine", .sequence = "sobol"},
                            .panels = PANEL_SKIES,
                            .color = i,
                            .marker = i == 0  ? PLOT_SQUARE
                                      : i < 5 ? PLOT_DOT
                                              : PLOT_DIAMOND});
    }
}

static RenderParams with(const RenderParams *picture, const Combination *combination) {
    RenderParams params = *picture;
    params.sky = combination->sky;
    params.light = combination->light;
    params.sequence = combination->sequence;
    if (combination->disk) params.sun_disk = combination->disk;
    params.samples = 0;
    return params;
}

static bool open_ledger(Paths *paths, Error *error) {
    const ChartParams *params = paths->params;
    Text identity = {0};
    uint64_t hash = 0;
    bool ok = true;
    for (int i = 0; ok && i < paths->count; i++) {
        RenderParams mine = with(&params->picture, &paths->curves[i].combination);
        ok = identity_add_shader(&mine, &hash, error);
    }
    text_print(&identity, "%s", params->identity);
    identity_of_picture(&params->picture, &identity);
    text_print(&identity, "# shaders %016" PRIx64 "\n", hash);
    char *path = chart_path(params, paths_in_levels(paths) ? CHART_PATHS_LEVELS ".csv" : "paths.csv");
    ok = ok && ledger_open(&paths->ledger, path, text_string(&identity), CURVE_WORDS, CURVE_COLUMNS,
                           params->said, error);
    free(path);
    text_free(&identity);
    return ok;
}

static bool get_reference(Paths *paths, Error *error) {
    const ChartParams *params = paths->params;
    Text identity = {0};
    uint64_t hash = 0;
    RenderParams mine = with(&params->picture, &(Combination){0});
    if (sky_integrates(&params->picture)) mine.sky = REFERENCE_SKY;
    if (!identity_add_shader(&mine, &hash, error)) return false;
    identity_of_picture(&params->picture, &identity);
    text_print(&identity, "# shader %016" PRIx64, hash);
    char *path = chart_path(params, "reference.exr");
    Monitor monitor = monitor_part(&params->monitor, 0, reference_share);
    bool ok = reference_get(&paths->reference, path, text_string(&identity), params->context,
                            &params->picture, reference_share * params->seconds, &monitor, error);
    free(path);
    text_free(&identity);
    return ok;
}

/* Says whether an earlier curve has the same combination. This happens because auto's choice is one of the
 * others. */
static bool is_doubled(const Paths *paths, int at) {
    for (int i = 0; i < at; i++) {
        if (paths->curves[i].curve.open &&
            ledger_same(&paths->ledger, &paths->curves[i].curve.row, &paths->curves[at].curve.row))
            return true;
    }
    return false;
}

static bool open_curves(Paths *paths, Error *error) {
    const ChartParams *params = paths->params;
    for (int i = 0; i < paths->count && !monitor_stopped(&params->monitor); i++) {
        Drawn *drawn = &paths->curves[i];
        monitor_report(&params->monitor, reference_share, "compiling");
        if (!curve_open(&drawn->curve, &drawn->combination, params->context, &params->picture,
                        params->target.measure, &paths->ledger, error))
            return false;
        if (is_doubled(paths, i)) curve_close(&drawn->curve);
    }
    return true;
}

/* Times the curves in alternation, each at least once. A curve that has used its share of the time is
 * skipped. */
static bool time_curves(Paths *paths, const CurveLimits *limits, Error *error) {
    const ChartParams *params = paths->params;
    double share = timing_share * params->seconds / paths->count;
    bool timed = true;
    for (int round = 0; timed && !monitor_stopped(&params->monitor); round++) {
        timed = false;
        for (int i = 0; i < paths->count && !monitor_stopped(&params->monitor); i++) {
            Curve *curve = &paths->curves[i].curve;
            if (!curve->open || (round && curve->spent > share)) continue;
            monitor_report(&params->monitor, reference_share + timing_share * fmin(curve->spent / share, 1),
                           "timing in turns");
            if (!curve_time(curve, &paths->reference, limits, &params->monitor, error)) return false;
            timed = true;
        }
    }
    return true;
}

static bool measure(Paths *paths, Error *error) {
    const ChartParams *params = paths->params;
    double before = reference_share + timing_share, each = (1 - before) / paths->count;
    if (!open_curves(paths, error)) return false;
    /* All points of a curve together take twice the time of the last one. */
    CurveLimits limits = {each * params->seconds / 2, least_over_reference * paths_noise(paths)};
    if (!time_curves(paths, &limits, error)) return false;
    for (int i = 0; i < paths->count && !monitor_stopped(&params->monitor); i++) {
        Curve *curve = &paths->curves[i].curve;
        Monitor monitor = monitor_part(&params->monitor, before + each * i, before + each * (i + 1));
        if (curve->open && !curve_measure(curve, &paths->reference, &limits, &monitor, &paths->ledger, error))
            return false;
        curve_close(curve);
    }
    for (int i = 0; i < paths->count; i++) {
        Drawn *drawn = &paths->curves[i];
        drawn->count = curve_points(&paths->ledger, &drawn->curve.row, drawn->points);
    }
    return true;
}

bool chart_paths(const ChartParams *params, Error *error) {
    Paths *paths = memory_get(1, sizeof *paths);
    paths->params = params;
    choose_curves(paths);
    bool ok = open_ledger(paths, error) && get_reference(paths, error);
    if (ok && !monitor_stopped(&params->monitor)) {
        text_print(params->said, "reference: %s %.3g%s by its two halves%s\n",
                   paths_in_levels(paths) ? "RMS" : "relRMSE", paths_noise(paths),
                   paths_in_levels(paths) ? " levels" : " %",
                   paths->reference.kept ? ", kept from before" : "");
        ok = measure(paths, error);
    }
    if (ok && !monitor_stopped(&params->monitor)) ok = paths_draw(paths, error);
    for (int i = 0; i < paths->count; i++) curve_close(&paths->curves[i].curve);
    reference_free(&paths->reference);
    ledger_close(&paths->ledger);
    free(paths);
    return ok;
}
