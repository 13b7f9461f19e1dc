#include "cmd/render_write.h"

#include "cmd/nan_map.h"
#include "cmd/outputs.h"
#include "error/noise_figures.h"
#include "error/part.h"
#include "image/format.h"

#include <math.h>
#include <string.h>

Tone render_tone(const Options *options) {
    return options->tone && strcmp(options->tone, "none") == 0 ? TONE_NONE : TONE_AUTHOR;
}

/* Scales the layer of variances, if there is one. */
static void calibrate(RenderJob *job) {
    const Film *film = &job->renderer.film;
    float *variance = aov_variance(&job->aov, &job->image);
    if (!variance) return;
    noise_calibrate(&job->adaptive.noise, variance);
    for (size_t i = 0; i < 3 * (size_t)film->width * (size_t)film->height; i++)
        job->variance_unknown |= isnan(variance[i]);
}

bool render_read(RenderJob *job, Error *error) {
    const Film *film = &job->renderer.film;
    if (!film_read(film, &job->image, &job->count, error) || !film_read_search(film, &job->search, error) ||
        !chance_read_shares(&job->chance, film, &job->image, error) ||
        !aov_read(&job->aov, film, &job->image, error)) {
        return false;
    }
    calibrate(job);
    job->image.data = job->renderer.crop;
    return !render_is_part(job->options) || part_add_layers(film, &job->image, error);
}

bool render_write(const RenderJob *job, Error *error) {
    const Options *options = job->options;
    AttributeList attributes = {0};
    render_describe(job, &attributes);
    ImageWriteParams params = {.exposure_ev = job->scene.values.exposure_ev,
                               .tone = render_tone(options),
                               .attributes = &attributes};
    bool ok = outputs_write(options, &job->image, &params, error) && nan_map_write(job, &attributes, error);
    attribute_list_free(&attributes);
    return ok;
}
