#include "base/version.h"
#include "cmd/render_job.h"
#include "error/noise_figures.h"
#include "image/sun_pixels.h"
#include "render/describe.h"

#include <inttypes.h>
#include <math.h>

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
    sun_pixels_describe(noise->left_out, noise->width, noise->height, list);
}

void render_describe(const RenderJob *job, int argc, char **argv, AttributeList *list) {
    Text command = {0};
    text_print_command(&command, argc, argv);
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
    if (job->chance.paths > 0) {
        attribute_add(list, "magichour.chance_paths_percent", "%.3g", 100 * job->chance.paths);
        attribute_add(list, "magichour.chance_pixels_percent", "%.3g", 100 * job->chance.pixels);
        attribute_add(list, "magichour.chance_light_percent", "%.3g", 100 * job->chance.light);
    }
    describe_errors(job, list);
    attribute_add(list, "magichour.rejected", "%" PRIu64, job->count.rejected);
    if (job->search.rays > 0) {
        attribute_add(list, "magichour.searches",
                      "%.0f rays, %.2f steps each, %.0f in a field that is no distance, %.0f cut",
                      job->search.rays, job->search.steps / job->search.rays, job->search.broken,
                      job->search.cut);
    }
    attribute_add(list, "magichour.seconds", "%.6f", job->figures.seconds);
    describe_picture(list, &job->scene, &job->renderer, &job->context);
    text_free(&command);
}
