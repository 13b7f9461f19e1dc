/* The names of the host's uniforms, as the library's pass/ folder declares them. */
#pragma once

#include "source/source_store.h"

/* Whether a file of pass/ declares a uniform of that name; `path` gets that file's name, "pass/trace.glsl". A
 * library without that folder declares none. */
bool host_names_find(SourceStore *store, const char *name, char *path, size_t size);
