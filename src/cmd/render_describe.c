#include "base/memory.h"
#include "base/version.h"
#include "cmd/render_job.h"
#include "cmd/render_write.h"
#include "error/noise_figures.h"
#include "error/part.h"
#include "image/sun_pixels.h"
#include "render/describe.h"
#include "render/identity.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

/* What the errors leave out of the rendered area. */
static void describe_sun(const Noise *noise, AttributeList *list) {
    size_t pixels = (size_t)noise->width * (size_t)noise->height;
    unsigned char *sun = memory_get(pixels, 1);
    for (size_t i = 0; i < pixels; i++) {
        int x = (int)(i % (size_t)noise->width), y = (int)(i / (size_t)noise->width);
        sun[i] = noise->left_out[i] && rectangle_holds(&noise->area, x, y);
    }
    sun_pixels_describe(sun, noise->width, noise->height, list);
    free(sun);
}

static void describe_errors(const RenderJob *job, AttributeList *list) {
    const ProgressFigures *figures = &job->figures;
    const Noise *noise = &job->adaptive.noise;
    if (figures->error[NOISE_RADIANCE] < INFINITY) {
        attribute_add(list, "magichour.error_percent", "%.4g", figures->error[NOISE_RADIANCE]);
        attribute_add(list, "magichour.noise_percent", "%.4g", figures->noise[NOISE_RADIANCE]);
    }
    if (figures->error[NOISE_LEVELS] < INFINITY) {
        attribute_add(list, "magichour.error_levels", "%.4g", figures->error[NOISE_LEVELS]);
        attribute_add(list, "magichour.noise_levels", "%.4g", figures->noise[NOISE_LEVELS]);
    }
    if (figures->promise)
        attribute_add(list, "magichour.promised", "%s", job->promise.given ? "true" : job->promise.reason);
    describe_sun(noise, list);
}

bool render_identity(const RenderJob *job, Text *lines, Error *error) {
    const Options *options = job->options;
    if (!identity_print(&job->params, &job->renderer, options->aov, lines, error)) return false;
    if (job->adaptive.measure == NOISE_LEVELS)
        text_print(lines, "measure levels, exposure %.17g, tone %d\n", job->scene.values.exposure_ev,
                   (int)render_tone(options));
    else
        text_print(lines, "measure percent\n");
    return true;
}

/* Which of the picture's samples these are, if they are a part. */
static void describe_part(const RenderJob *job, AttributeList *list) {
    const Renderer *renderer = &job->renderer;
    PartPiece piece = {renderer->area, renderer->first_sample, job->adaptive.most};
    Text identity = {0};
    Error error;
    if (!render_is_part(job->options) || !render_identity(job, &identity, &error)) return;
    Part part = {.pieces = &piece,
                 .piece_count = 1,
                 .identity = identity.data,
                 .light_first = (double)renderer->light.first,
                 .light_paths = renderer->film.light_paths,
                 .light_scale = renderer->film.light_scale,
                 .search = job->search,
                 .layers = part_layers_of(&renderer->film),
                 .luck = evidence_needs_luck(&renderer->plan)};
    part_describe(&part, list);
    text_free(&identity);
}

bool render_is_part(const Options *options) {
    return options->has_first_sample || options->crop.width;
}

void render_describe(const RenderJob *job, AttributeList *list) {
    Text command = {0};
    text_print_command(&command, job->argc, job->argv);
    attribute_add(list, "magichour.version", "%s", MAGICHOUR_VERSION);
    attribute_add(list, "magichour.command", "%s", text_string(&command));
    if (job->options->aov) attribute_add(list, "magichour.aov", "%s", job->options->aov);
    attribute_add(list, "magichour.depth", "%d", job->options->depth);
    attribute_add(list, "magichour.samples", "%.6g", job->figures.samples);
    attribute_add(list, "magichour.samples_range", "%" PRIu64 " to %" PRIu64, job->adaptive.least,
                  job->adaptive.most);
    if (job->figures.sun_by_chance) attribute_add(list, "magichour.sun_by_chance", "true");
    if (job->figures.light_paths > 0)
        attribute_add(list, "magichour.light_paths", "%.0f", job->figures.light_paths);
    describe_chance(&job->chance, list);
    describe_errors(job, list);
    attribute_add(list, "magichour.rejected", "%" PRIu64, job->count.rejected);
    describe_search(&job->search, list);
    attribute_add(list, "magichour.seconds", "%.6f", job->figures.seconds);
    describe_picture(list, &job->scene, &job->renderer, &job->context);
    describe_part(job, list);
    text_free(&command);
}
