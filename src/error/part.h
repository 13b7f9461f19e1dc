/* A part of a picture: some of its samples, or some of its pixels, in an EXR file. Parts of the same picture
 * become one by merge.h.
 *
 * Beside what any picture has, the file has the film's own sums (gl/film.h) as layers "part.sum" and
 * "part.rest", and if the film has them "part.scatter", "part.chance", "part.squares", and the second sum as
 * "part.light" and "part.light_rest", whose sum it is. Metadata say which samples they are. */
#pragma once

#include "image/attribute.h"
#include "render/renderer.h"

/* These samples of these pixels. */
typedef struct PartPiece {
    Rectangle area;
    uint64_t first, count;
} PartPiece;

enum {
    PART_SUM,
    PART_REST,
    PART_SCATTER,
    PART_CHANCE,
    PART_SQUARES,
    PART_LIGHT,
    PART_LIGHT_REST,
    PART_LAYERS
};

/* A part as it is read from a file, or put together. */
typedef struct Part {
    char *path;
    AttributeList attributes;
    PartPiece *pieces;
    int piece_count;
    /* The picture's lines (render/identity.h). */
    char *identity;
    /* The numbers of the second sum's light paths, and its scale. */
    double light_first, light_paths, light_scale;
    FilmSearch search;
    /* Bits of the layers that it has. */
    unsigned layers;
    /* Whether some of its light is found by few paths only, so that its noise is not known from a few
     * (evidence_suffices()). */
    int luck;
} Part;

/* The name of a layer, such as "part.sum". */
const char *part_layer(int layer);

/* Adds the layers of the film to a picture that was read from it. */
MUST_CHECK bool part_add_layers(const Film *film, Image *image, Error *error);

/* Adds the metadata of a part. */
void part_describe(const Part *part, AttributeList *list);

/* The bits of the layers that a film's part has. */
unsigned part_layers_of(const Film *film);

/* Reads all but the layers. A file that is no part is STATUS_FAILURE. To be freed. */
MUST_CHECK bool part_read(Part *part, const char *path, Error *error);
void part_free(Part *part);

/* Whether the part has samples of a pixel. */
bool part_holds(const Part *part, int x, int y);

/* The text of a part's metadata, or NULL. */
const char *part_attribute(const Part *part, const char *name);

/* Reads a layer: 4 floats a pixel of the whole picture, to be freed as an image. */
MUST_CHECK bool part_read_layer(const Part *part, int layer, Image *image, Error *error);
