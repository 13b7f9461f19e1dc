#include "chart/reference.h"

#include "base/clock.h"
#include "base/memory.h"
#include "base/number.h"
#include "image/compare.h"
#include "image/exr_attribute.h"
#include "image/format.h"
#include "image/sun_pixels.h"
#include "render/chance.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* This is far from the seeds of users, who count from 0. */
enum { FIRST_SEED = 0x5eed0000 };

/* The share of the time for the difference between the exact sky and the table. */
static const double correction_share = 0.25;

/* The light method and the sequence of the first part. The other parts use them too; otherwise the same
 * random numbers would make different paths. */
typedef struct Paths {
    char light[48], sequence[48];
} Paths;

/* A picture that is added to a half, multiplied by `weight`. */
typedef struct Part {
    /* NULL for the choice of auto. */
    const char *sky;
    unsigned seed;
    /* How long to render. 0 means: take `samples` samples. */
    double seconds;
    /* Set to the number of samples that were taken. */
    uint64_t samples;
    double weight;
} Part;

typedef struct Maker {
    const Context *context;
    const RenderParams *params;
    const Monitor *monitor;
    Paths paths;
    unsigned char *sun;
    /* In seconds. */
    double done, whole;
} Maker;

/* Adds the pixels of the sun's own image, which any part may have found. */
static bool mark_sun(Maker *maker, const Renderer *renderer, Error *error) {
    const Film *film = &renderer->film;
    ChanceMap map;
    if (!chance_map_read(&map, film, error)) return false;
    if (!maker->sun) maker->sun = memory_get((size_t)film->width * (size_t)film->height, 1);
    sun_image_pixels(&renderer->sun_image, film->width, maker->sun);
    chance_image_pixels(&map, maker->sun);
    chance_map_free(&map);
    return true;
}

static bool render_part(Maker *maker, Part *part, Image *half, Error *error) {
    RenderParams params = *maker->params;
    Renderer renderer;
    Image image = {0};
    FilmCount count;
    params.sky = part->sky;
    params.light = *maker->paths.light ? maker->paths.light : NULL;
    params.sequence = *maker->paths.sequence ? maker->paths.sequence : NULL;
    params.seed = part->seed;
    params.samples = 0;
    if (!renderer_create(&renderer, maker->context, &params, error)) return false;
    snprintf(maker->paths.light, sizeof maker->paths.light, "%s", renderer.plan.light.text);
    snprintf(maker->paths.sequence, sizeof maker->paths.sequence, "%s", renderer.plan.sequence.text);
    uint64_t most = part->samples ? part->samples : UINT32_MAX;
    double start = clock_seconds();
    bool ok = true;
    while (ok && renderer.film.samples < most && !monitor_stopped(maker->monitor)) {
        double spent = clock_seconds() - start;
        if (!part->samples && spent >= part->seconds) break;
        monitor_report(maker->monitor, fmin((maker->done + spent) / maker->whole, 1), "reference");
        ok = renderer_pass(&renderer, most - renderer.film.samples, maker->monitor->stop, error);
    }
    maker->done += clock_seconds() - start;
    part->samples = renderer.film.samples;
    ok = ok && mark_sun(maker, &renderer, error) && film_read(&renderer.film, &image, &count, error);
    size_t values = ok ? 4 * (size_t)image.width * (size_t)image.height : 0;
    if (ok && !half->rgba) *half = image_create(image.width, image.height);
    for (size_t i = 0; i < values; i++) half->rgba[i] += (float)part->weight * image.rgba[i];
    image_free(&image);
    renderer_destroy(&renderer);
    return ok;
}

/* Says whether a table can be made of the scene's sky. */
static bool integrates(const RenderParams *params) {
    MethodChoice choice;
    Error ignored;
    const char *sky = params->sky ? params->sky : params->scene->file->sky;
    return method_choose(&choice, METHOD_SKY, *sky ? sky : NULL, &ignored) && choice.method->integrates;
}

static bool render_half(Maker *maker, unsigned seed, double seconds, Image *half, Error *error) {
    if (!integrates(maker->params)) {
        Part whole = {.seed = seed, .seconds = seconds, .weight = 1};
        return render_part(maker, &whole, half, error);
    }
    Part table = {.sky = "table:gauss:8", .seed = seed, .weight = 1};
    Part exact = {.sky = REFERENCE_SKY, .seed = seed + 1, .weight = 1};
    table.seconds = (1 - correction_share) * seconds;
    exact.seconds = correction_share * seconds;
    if (!render_part(maker, &table, half, error) || !render_part(maker, &exact, half, error)) return false;
    Part same = {.sky = table.sky, .seed = exact.seed, .samples = exact.samples, .weight = -1};
    return monitor_stopped(maker->monitor) || render_part(maker, &same, half, error);
}

/* Compares without the pixels of the sun's own image, unless these are all. */
static bool compare(const Reference *reference, const Image *a, const Image *b, Comparison *between,
                    Error *error) {
    size_t pixels = (size_t)b->width * (size_t)b->height, sun = 0;
    for (size_t i = 0; i < pixels; i++) sun += reference->sun[i];
    CompareOptions options = {.sun = sun < pixels ? reference->sun : NULL,
                              .tone = TONE_AUTHOR,
                              .exposure_ev = reference->exposure_ev};
    return compare_images(a, b, &options, between, error);
}

static bool make(Reference *reference, Maker *maker, double seconds, Error *error) {
    Image other = {0};
    Comparison between;
    reference->exposure_ev = maker->params->scene->values.exposure_ev;
    maker->whole = seconds;
    bool ok = render_half(maker, FIRST_SEED, seconds / 2, &reference->image, error) &&
              render_half(maker, FIRST_SEED + 2, seconds / 2, &other, error);
    if (ok && monitor_stopped(maker->monitor)) {
        image_free(&reference->image);
    } else if (ok) {
        reference->sun = maker->sun;
        maker->sun = NULL;
        ok = compare(reference, &reference->image, &other, &between, error);
        /* The error of the mean of two halves is half of their difference. */
        reference->noise[NOISE_RADIANCE] = between.rel_rmse_percent / 2;
        reference->noise[NOISE_LEVELS] = between.levels.rms / 2;
        size_t values = 4 * (size_t)other.width * (size_t)other.height;
        for (size_t i = 0; i < values; i++)
            reference->image.rgba[i] = 0.5F * (reference->image.rgba[i] + other.rgba[i]);
    }
    image_free(&other);
    free(maker->sun);
    return ok;
}

/* The names of the metadata that hold a reference's noise. */
static const char *const noise_names[NOISE_MEASURES] = {"magichour.error_percent", "magichour.error_levels"};

static bool read_number(const Text *file, const char *name, double *number) {
    Text text = {0};
    bool ok = exr_attribute(file, name, &text) && number_parse(text_string(&text), number);
    text_free(&text);
    return ok;
}

static bool read_sun(Reference *reference, const Text *file) {
    const Image *image = &reference->image;
    Text text = {0};
    Error ignored;
    reference->sun = memory_get((size_t)image->width * (size_t)image->height, 1);
    bool ok = !exr_attribute(file, SUN_PIXELS_ATTRIBUTE, &text) ||
              sun_pixels_parse(text_string(&text), reference->sun, image->width, image->height, &ignored);
    text_free(&text);
    return ok;
}

static bool read_kept(Reference *reference, const char *path, const char *identity) {
    Text there = {0}, file = {0};
    Error ignored;
    bool fits = image_read_as(&reference->image, path, &(ImageReadParams){.bytes = &file}, &ignored) &&
                exr_attribute(&file, "magichour.chart", &there) &&
                strcmp(text_string(&there), identity) == 0 &&
                read_number(&file, noise_names[NOISE_RADIANCE], &reference->noise[NOISE_RADIANCE]) &&
                read_number(&file, noise_names[NOISE_LEVELS], &reference->noise[NOISE_LEVELS]) &&
                read_sun(reference, &file);
    text_free(&file);
    text_free(&there);
    return fits;
}

static bool keep(const Reference *reference, const char *path, const char *identity, Error *error) {
    AttributeList list = {0};
    attribute_add(&list, "magichour.chart", "%s", identity);
    attribute_add(&list, "magichour.exposure", "%.9g", reference->exposure_ev);
    for (int i = 0; i < NOISE_MEASURES; i++)
        attribute_add(&list, noise_names[i], "%.6g", reference->noise[i]);
    sun_pixels_describe(reference->sun, reference->image.width, reference->image.height, &list);
    bool ok = image_write(&reference->image, path, &(ImageWriteParams){.attributes = &list}, error);
    attribute_list_free(&list);
    return ok;
}

bool reference_get(Reference *reference, const char *path, const char *identity, const Context *context,
                   const RenderParams *params, double seconds, const Monitor *monitor, Error *error) {
    Maker maker = {.context = context, .params = params, .monitor = monitor};
    *reference = (Reference){.exposure_ev = params->scene->values.exposure_ev};
    if (read_kept(reference, path, identity)) {
        reference->kept = true;
        return true;
    }
    reference_free(reference);
    if (make(reference, &maker, seconds, error) &&
        (!reference->image.rgba || keep(reference, path, identity, error)))
        return true;
    reference_free(reference);
    return false;
}

void reference_free(Reference *reference) {
    image_free(&reference->image);
    free(reference->sun);
    *reference = (Reference){0};
}

bool reference_error(const Reference *reference, const Image *image, NoiseMeasure measure, double *value,
                     Error *error) {
    Comparison between;
    if (!compare(reference, image, &reference->image, &between, error)) return false;
    if (between.nonfinite)
        return error_set(error, STATUS_FAILURE, "%ld pixels are not finite", between.nonfinite);
    double measured = measure == NOISE_LEVELS ? between.levels.rms : between.rel_rmse_percent;
    double noise = reference->noise[measure];
    *value = sqrt(fmax(measured * measured - noise * noise, 0));
    return true;
}
