#include "error/part.h"

#include "base/memory.h"
#include "image/exr_attribute.h"
#include "image/format.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ATTRIBUTE "magichour.part"

static const struct {
    const char *name, *channels;
    int texture;
} layers[PART_LAYERS] = {
    [PART_SUM] = {"part.sum", "RGBA", FILM_TEXTURE_SUM},
    [PART_REST] = {"part.rest", "RGBA", FILM_TEXTURE_REST},
    [PART_SCATTER] = {"part.scatter", "RGBA", FILM_TEXTURE_SCATTER},
    [PART_CHANCE] = {"part.chance", "RGBA", FILM_TEXTURE_CHANCE},
    [PART_SQUARES] = {"part.squares", "RGBA", FILM_TEXTURE_SQUARES},
    [PART_LIGHT] = {"part.light", "RGBA", -1},
    [PART_LIGHT_REST] = {"part.light_rest", "RGBA", -1},
};

const char *part_layer(int layer) {
    return layers[layer].name;
}

unsigned part_layers_of(const Film *film) {
    return 1U << PART_SUM | 1U << PART_REST | (film->parts & FILM_SCATTER ? 1U << PART_SCATTER : 0U) |
           (film->parts & FILM_CHANCE ? 1U << PART_CHANCE | 1U << PART_SQUARES : 0U) |
           (film->light ? 1U << PART_LIGHT | 1U << PART_LIGHT_REST : 0U);
}

/* The second sum as two floats, which hold 48 bits of it. */
static void add_light(const FilmLight *light, Image *image) {
    size_t pixels = (size_t)light->width * (size_t)light->height;
    float *sum = image_add_layer(image, layers[PART_LIGHT].name, layers[PART_LIGHT].channels),
          *rest = image_add_layer(image, layers[PART_LIGHT_REST].name, layers[PART_LIGHT_REST].channels);
    for (size_t i = 0; i < 4 * pixels; i++) {
        sum[i] = (float)light->sum[i];
        rest[i] = (float)(light->sum[i] - (double)sum[i]);
    }
}

bool part_add_layers(const Film *film, Image *image, Error *error) {
    unsigned all = part_layers_of(film);
    for (int i = 0; i < PART_LAYERS; i++) {
        if (!(all >> i & 1) || layers[i].texture < 0) continue;
        float *data = image_add_layer(image, layers[i].name, layers[i].channels);
        if (!film_read_texture(film, layers[i].texture, data, error)) return false;
    }
    if (film->light) add_light(film->light, image);
    return true;
}

void part_describe(const Part *part, AttributeList *list) {
    Text pieces = {0};
    for (int i = 0; i < part->piece_count; i++) {
        const PartPiece *piece = &part->pieces[i];
        text_print(&pieces, "%s%d,%d,%d,%d:%" PRIu64 "+%" PRIu64, i ? " " : "", piece->area.x, piece->area.y,
                   piece->area.width, piece->area.height, piece->first, piece->count);
    }
    attribute_add(list, ATTRIBUTE, "%s", text_string(&pieces));
    attribute_add(list, ATTRIBUTE ".identity", "%s", part->identity);
    attribute_add(list, ATTRIBUTE ".layers", "%u", part->layers);
    attribute_add(list, ATTRIBUTE ".luck", "%d", part->luck);
    attribute_add(list, ATTRIBUTE ".light", "%.17g %.17g %.17g", part->light_first, part->light_paths,
                  part->light_scale);
    attribute_add(list, ATTRIBUTE ".search", "%.17g %.17g %.17g %.17g", part->search.rays, part->search.steps,
                  part->search.broken, part->search.cut);
    text_free(&pieces);
}

bool part_holds(const Part *part, int x, int y) {
    for (int i = 0; i < part->piece_count; i++)
        if (rectangle_holds(&part->pieces[i].area, x, y)) return true;
    return false;
}

const char *part_attribute(const Part *part, const char *name) {
    for (int i = 0; i < part->attributes.count; i++)
        if (strcmp(part->attributes.items[i].name, name) == 0) return part->attributes.items[i].value;
    return NULL;
}

/* Numbers of samples are below this: a film counts 2^24, and pictures of many parts have more. */
static const uint64_t most_samples = (uint64_t)1 << 44;

static bool is_sane(const PartPiece *piece) {
    const Rectangle *r = &piece->area;
    return r->x >= 0 && r->y >= 0 && r->width >= 1 && r->height >= 1 && r->width <= 65536 &&
           r->height <= 65536 && r->x <= 65536 && r->y <= 65536 && piece->first < most_samples &&
           piece->count < most_samples;
}

/* Reads the list of pieces. */
static bool parse_pieces(Part *part, const char *text) {
    while (text && *text) {
        PartPiece piece;
        int length = 0;
        if (sscanf(text, "%d,%d,%d,%d:%" SCNu64 "+%" SCNu64 "%n", &piece.area.x, &piece.area.y,
                   &piece.area.width, &piece.area.height, &piece.first, &piece.count, &length) != 6 ||
            !length || !is_sane(&piece))
            return false;
        part->pieces = memory_grow(part->pieces, (size_t)part->piece_count + 1, sizeof piece);
        part->pieces[part->piece_count++] = piece;
        text += length;
        text += *text == ' ';
    }
    return part->piece_count > 0;
}

/* Whether the layers are those of a film, and the numbers such as it has. */
static bool is_film(const Part *part) {
    unsigned sums = 1U << PART_SUM | 1U << PART_REST, chance = 1U << PART_CHANCE | 1U << PART_SQUARES,
             light = 1U << PART_LIGHT | 1U << PART_LIGHT_REST, all = part->layers;
    bool numbers = part->light_first >= 0 && part->light_first < 1e300 && part->light_paths >= 0 &&
                   part->light_paths < 1e300 && isfinite(part->light_scale);
    const double counts[4] = {part->search.rays, part->search.steps, part->search.broken, part->search.cut};
    for (int i = 0; i < 4; i++) numbers &= counts[i] >= 0 && counts[i] < 1e300;
    return numbers && !(all >> PART_LAYERS) && (all & sums) == sums &&
           ((all & chance) == 0 || (all & chance) == chance) &&
           ((all & light) == 0 || (all & light) == light);
}

static bool parse(Part *part) {
    const char *identity = part_attribute(part, ATTRIBUTE ".identity"),
               *bits = part_attribute(part, ATTRIBUTE ".layers"),
               *light = part_attribute(part, ATTRIBUTE ".light"),
               *luck = part_attribute(part, ATTRIBUTE ".luck"),
               *search = part_attribute(part, ATTRIBUTE ".search");
    if (!identity || !bits || !light || !luck || !search) return false;
    part->identity = memory_string(identity);
    return parse_pieces(part, part_attribute(part, ATTRIBUTE)) && sscanf(bits, "%u", &part->layers) == 1 &&
           sscanf(luck, "%d", &part->luck) == 1 &&
           sscanf(light, "%lf %lf %lf", &part->light_first, &part->light_paths, &part->light_scale) == 3 &&
           sscanf(search, "%lf %lf %lf %lf", &part->search.rays, &part->search.steps, &part->search.broken,
                  &part->search.cut) == 4 &&
           is_film(part);
}

bool part_read(Part *part, const char *path, Error *error) {
    Image image;
    Text bytes = {0};
    ImageReadParams params = {.layer = layers[PART_SUM].name, .bytes = &bytes};
    *part = (Part){.path = memory_string(path)};
    bool ok = image_read(&image, path, error);
    if (ok) image_free(&image);
    if (ok && !image_read_as(&image, path, &params, error))
        ok = error_set(
            error, STATUS_FAILURE,
            "%s: it holds no sums, so that it cannot be merged: render it with --first-sample (0 for "
            "the first part) or --crop, into an .exr",
            path);
    else if (ok)
        image_free(&image);
    ok = ok && exr_attributes(&bytes, &part->attributes) &&
         (parse(part) ||
          error_set(error, STATUS_FAILURE, "%s: its metadata do not say which samples it holds", path));
    text_free(&bytes);
    if (!ok) part_free(part);
    return ok;
}

void part_free(Part *part) {
    free(part->path);
    free(part->identity);
    free(part->pieces);
    attribute_list_free(&part->attributes);
    *part = (Part){0};
}

bool part_read_layer(const Part *part, int layer, Image *image, Error *error) {
    ImageReadParams params = {.layer = layers[layer].name};
    return image_read_as(image, part->path, &params, error);
}
