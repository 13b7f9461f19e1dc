/* The state of a picture's error and of its adaptive samples, saved and loaded. */
#include "base/memory.h"
#include "error/adaptive.h"

static void archive_tile(NoiseTile *tile, Archive *archive) {
    ARCHIVE(archive, tile->counted);
    ARCHIVE(archive, tile->samples);
    ARCHIVE(archive, tile->measured);
    ARCHIVE(archive, tile->times);
    ARCHIVE(archive, tile->change);
    ARCHIVE(archive, tile->light);
}

static void archive_light(NoiseLight *light, size_t values, Archive *archive) {
    bool any = light->before != NULL;
    ARCHIVE(archive, light->paths);
    ARCHIVE(archive, light->measured);
    ARCHIVE(archive, light->times);
    archive_bool(archive, &any);
    if (any && !light->before) light->before = memory_get(values, sizeof *light->before);
    if (any) archive_bytes(archive, light->before, values * sizeof *light->before);
}

static void archive_noise(Noise *noise, Archive *archive) {
    size_t pixels = (size_t)noise->width * (size_t)noise->height;
    for (int i = 0; i < noise_tile_count(noise); i++) archive_tile(&noise->tiles[i], archive);
    archive_bytes(archive, noise->before, 3 * pixels * sizeof *noise->before);
    archive_light(&noise->light, 3 * pixels, archive);
    archive_bytes(archive, noise->left_out, pixels);
    ARCHIVE(archive, noise->counted);
    ARCHIVE(archive, noise->figures);
    ARCHIVE(archive, noise->mean);
    ARCHIVE(archive, noise->largest);
}

void adaptive_archive(Adaptive *adaptive, Archive *archive) {
    size_t tiles = (size_t)noise_tile_count(&adaptive->noise);
    archive_noise(&adaptive->noise, archive);
    ARCHIVE(archive, adaptive->evidence);
    archive_bool(archive, &adaptive->claimed);
    archive_bytes(archive, adaptive->wanted, tiles * sizeof *adaptive->wanted);
    ARCHIVE(archive, adaptive->wanted_light);
    ARCHIVE(archive, adaptive->paths);
    ARCHIVE(archive, adaptive->least);
    ARCHIVE(archive, adaptive->most);
    ARCHIVE(archive, adaptive->rounds);
    archive_bool(archive, &adaptive->under_way);
    ARCHIVE(archive, adaptive->even);
    archive_bool(archive, &adaptive->chosen);
    ARCHIVE(archive, adaptive->paths_before);
    ARCHIVE(archive, adaptive->light_before);
    ARCHIVE(archive, adaptive->aimless);
    archive_bool(archive, &adaptive->idle);
    ARCHIVE(archive, adaptive->rejected);
    ARCHIVE(archive, adaptive->planned);
    ARCHIVE(archive, adaptive->beyond);
}
