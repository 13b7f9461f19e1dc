#include "scene/uniform_check.h"

#include "scene/host_names.h"
#include "source/glsl_scan.h"
#include "source/glsl_uniforms.h"

#include <ctype.h>
#include <string.h>

/* What the library declares is set by the host. */
static bool in_library(const SceneFile *file, const char *path) {
    size_t length = strlen(file->sources->folder);
    return length > 0 && strncmp(path, file->sources->folder, length) == 0 && path[length] == '/';
}

static bool is_parameter(const SceneFile *file, const char *name) {
    for (int i = 0; i < file->parameter_count; i++) {
        if (strcmp(file->parameters[i].name, name) == 0) return true;
    }
    return false;
}

/* Shadertoy's inputs are given to the scenes that mention them (scene/scene_facts.h). */
static bool is_input(const char *name) {
    return name[0] == 'i' && isupper((unsigned char)name[1]);
}

static bool is_set(const SceneFile *file, const GlslSource *source, const GlslUniform *uniform) {
    char path[256];
    return uniform->has_value || in_library(file, glsl_source_file(source, uniform->file)) ||
           is_parameter(file, uniform->name) || is_input(uniform->name) ||
           host_names_find(file->sources, uniform->name, path, sizeof path);
}

/* What gives a uniform of this type a value. */
static const char *remedy(const char *type) {
    static const char *const remedies[][2] = {
        {"float",
         "`//@ slider 1 min 0 max 2` behind it on its line makes it a parameter; otherwise make it a const"},
        {"bool", "`//@ checkbox on` behind it on its line makes it a parameter; otherwise make it a const"},
        {"vec3", "`//@ color 1 1 1` behind it on its line makes it a parameter; otherwise make it a const"},
    };
    for (size_t i = 0; i < sizeof remedies / sizeof *remedies; i++) {
        if (strcmp(remedies[i][0], type) == 0) return remedies[i][1];
    }
    return strncmp(type, "sampler", 7) == 0 ? "a scene has no pictures of its own"
                                            : "only float, bool and vec3 can be parameters; make it a const";
}

bool uniform_check(const SceneFile *file, const GlslSource *source, Error *error) {
    GlslScan scan = glsl_scan(text_string(&source->text));
    GlslUniforms uniforms = glsl_uniforms(scan.code);
    bool ok = true;
    for (int i = 0; ok && i < uniforms.count; i++) {
        const GlslUniform *uniform = &uniforms.items[i];
        if (is_set(file, source, uniform)) continue;
        const char *path = glsl_source_file(source, uniform->file);
        bool included = strcmp(path, file->path) != 0;
        ok = error_set(error, STATUS_SCENE, "%s:%d: nothing sets the uniform '%s': %s%s%s", path,
                       uniform->line, uniform->name, remedy(uniform->type),
                       included ? " (annotations are read in " : "", included ? file->path : "");
        if (included) strncat(error->text, ")", sizeof error->text - strlen(error->text) - 1);
    }
    glsl_uniforms_free(&uniforms);
    glsl_scan_free(&scan);
    return ok;
}
