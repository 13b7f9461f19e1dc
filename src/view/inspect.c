#include "view/inspect.h"

#include "error/evidence.h"

#include <math.h>
#include <string.h>

static const unsigned rays = 16;

static bool follow(Inspect *inspect, const Context *context, const RenderParams *params,
                   const Renderer *renderer, Error *error) {
    const Camera *camera = &renderer->camera;
    bool ok = true;
    if (!inspect->aov.program.id) {
        ok = aov_create(&inspect->aov, AOV_ALBEDO | AOV_DEPTH, context, params, renderer, error);
    } else if (!scene_same(params->scene, &inspect->told) || inspect->width != camera->width ||
               inspect->height != camera->height) {
        ok = aov_restart(&inspect->aov, context, params, renderer, error);
    }
    Scene told = scene_share(params->scene);
    scene_destroy(&inspect->told);
    inspect->told = told;
    inspect->width = camera->width;
    inspect->height = camera->height;
    return ok;
}

static double luminance(const double rgb[3]) {
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

bool inspect_pixel(Inspect *inspect, const Context *context, const RenderParams *params,
                   const Renderer *renderer, int x, int y, PixelFigures *figures, Error *error) {
    const Film *film = &renderer->film;
    FilmPixel light;
    AovPixel hit;
    double deviation[3];
    *figures = (PixelFigures){.x = x, .y = y};
    if (x < 0 || y < 0 || x >= film->width || y >= film->height || !film->samples) return true;
    if (!follow(inspect, context, params, renderer, error) || !film_read_pixel(film, x, y, &light, error) ||
        !aov_read_pixel(&inspect->aov, rays, x, y, &hit, error)) {
        return false;
    }
    for (int c = 0; c < 3; c++) deviation[c] = sqrt(light.variance[c]);
    memcpy(figures->radiance, light.radiance, sizeof figures->radiance);
    memcpy(figures->albedo, hit.albedo, sizeof figures->albedo);
    bool known = evidence_is_there(&renderer->plan);
    figures->error_percent = known ? 100 * luminance(deviation) / luminance(light.radiance) : NAN;
    figures->samples = light.samples;
    figures->depth = hit.depth;
    figures->hits = hit.hits;
    figures->known = true;
    return true;
}

void inspect_destroy(Inspect *inspect) {
    aov_destroy(&inspect->aov);
    scene_destroy(&inspect->told);
    *inspect = (Inspect){0};
}
