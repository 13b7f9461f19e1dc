/* Materials: a file in a folder named material/ gets a number when it is included, MATERIAL_MATTE for
 * material/matte.glsl, and one function for all of them calls the right one by its number. */
#pragma once

#include "scene/glsl_source.h"

/* Where the file at `path` is a material, numbers it in the text. Fails (STATUS_SCENE, without a place) where
 * its name makes no identifier. */
MUST_CHECK bool glsl_material_number(GlslSource *source, const char *path, Error *error);

/* Writes material_sample(), material_pdf() and material_value(), a call for each material so far, and
 * material_emitted() where one of them emits; and material_throws(). */
void glsl_materials_write(GlslSource *source);

/* Whether a material of the text may throw light in narrow lobes or single directions: each may that does not
 * declare `const bool NAME_THROWS = false`. */
bool glsl_materials_throw(const GlslSource *source);

/* Whether a material of the text emits: the file material/NAME.glsl defines NAME_emitted(). */
bool glsl_materials_emit(const GlslSource *source);
