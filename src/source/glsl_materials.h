/* Materials: a file in a folder named material/ gets a number when it is included, MATERIAL_MATTE for
 * material/matte.glsl, and one function for all of them calls the right one by its number. */
#pragma once

#include "base/error.h"
#include "base/text.h"

/* Names in order of inclusion: "matte". A zeroed list is empty. */
typedef struct GlslMaterials {
    char **names;
    int count;
} GlslMaterials;

void glsl_materials_free(GlslMaterials *materials);

/* Where the file at `path` is a material, adds it to the list and writes its number. Fails (STATUS_SCENE,
 * without a place) where its name makes no identifier. */
MUST_CHECK bool glsl_materials_add(GlslMaterials *materials, const char *path, Text *text, Error *error);

/* Appends material_sample(), material_pdf() and material_value(), a call for each material;
 * material_emits(); material_emitted() where one of them emits; and material_throws(). `text` is what they
 * are defined in. */
void glsl_materials_write(const GlslMaterials *materials, Text *text);

/* Whether a material of the text emits: it defines NAME_emitted(). */
bool glsl_materials_emit(const GlslMaterials *materials, const char *text);

/* Whether a material of the text may throw light in narrow lobes or single directions: each may that does not
 * declare `const bool NAME_THROWS = false`. */
bool glsl_materials_throw(const GlslMaterials *materials, const char *text);
