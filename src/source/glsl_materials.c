#include "source/glsl_materials.h"

#include "base/memory.h"
#include "source/glsl_scan.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The name in ".../material/NAME.glsl", to be freed; NULL for any other path. */
static char *material_name(const char *path) {
    static const char folder[] = "material";
    size_t length = sizeof folder - 1;
    const char *slash = strrchr(path, '/');
    if (!slash || (size_t)(slash - path) < length || strncmp(slash - length, folder, length) != 0)
        return NULL;
    const char *before = slash - length;
    if (before != path && before[-1] != '/') return NULL;
    return memory_string_part(slash + 1, strcspn(slash + 1, "."));
}

static bool is_identifier(const char *name) {
    if (!isalpha((unsigned char)*name)) return false;
    for (; *name; name++) {
        if (!isalnum((unsigned char)*name) && *name != '_') return false;
    }
    return true;
}

bool glsl_materials_add(GlslMaterials *materials, const char *path, Text *text, Error *error) {
    char *name = material_name(path);
    if (!name) return true;
    if (!is_identifier(name)) {
        error_set(
            error, STATUS_SCENE,
            "'%s' is no name for a material's file: it has to be letters, digits and _, and to begin with "
            "a letter",
            name);
        free(name);
        return false;
    }
    text_print(text, "const int MATERIAL_");
    for (const char *c = name; *c; c++) text_print(text, "%c", toupper((unsigned char)*c));
    text_print(text, " = %d;\n", materials->count);
    materials->names = memory_grow(materials->names, (size_t)materials->count + 1, sizeof *materials->names);
    materials->names[materials->count++] = name;
    return true;
}

/* One function for all materials: a call of the right one by the material's kind. */
static void generate_dispatch(const GlslMaterials *materials, Text *text, const char *type, const char *verb,
                              const char *parameters, const char *arguments, const char *nothing) {
    text_print(text, "%s material_%s(Material material, vec3 normal, vec3 incoming, %s) {\n", type, verb,
               parameters);
    for (int i = 0; i < materials->count; i++) {
        if (i + 1 < materials->count) text_print(text, "    if (material.kind == %d)\n    ", i);
        text_print(text, "    return %s_%s(material, normal, incoming, %s);\n", materials->names[i], verb,
                   arguments);
    }
    if (!materials->count) text_print(text, "    return %s;\n", nothing);
    text_print(text, "}\n");
}

static bool emits(const GlslMaterials *materials, const GlslScan *scan, int material) {
    Text function = {0};
    text_print(&function, "%s_emitted", materials->names[material]);
    bool defined = glsl_scan_defines(scan, text_string(&function));
    text_free(&function);
    return defined;
}

bool glsl_materials_emit(const GlslMaterials *materials, const char *text) {
    GlslScan scan = glsl_scan(text);
    bool found = false;
    for (int i = 0; i < materials->count; i++) found = found || emits(materials, &scan, i);
    glsl_scan_free(&scan);
    return found;
}

/* Only some materials emit, and only they need a function for it. */
static void generate_emitted(const GlslMaterials *materials, Text *text) {
    Text calls = {0}, kinds = {0};
    GlslScan scan = glsl_scan(text_string(text));
    for (int i = 0; i < materials->count; i++) {
        if (!emits(materials, &scan, i)) continue;
        text_print(&calls, "    if (material.kind == %d) return %s_emitted(material, normal, incoming);\n", i,
                   materials->names[i]);
        text_print(&kinds, " || material.kind == %d", i);
    }
    text_print(text, "bool material_emits(Material material) {\n    return false%s;\n}\n",
               text_string(&kinds));
    if (calls.size) {
        text_print(text,
                   "vec3 material_emitted(Material material, vec3 normal, vec3 incoming) {\n%s"
                   "    return vec3(0.0);\n}\n",
                   text_string(&calls));
    }
    glsl_scan_free(&scan);
    text_free(&calls);
    text_free(&kinds);
}

bool glsl_materials_throw(const GlslMaterials *materials, const char *text) {
    GlslScan scan = glsl_scan(text);
    bool found = false;
    for (int i = 0; i < materials->count && !found; i++) {
        Text constant = {0};
        text_print(&constant, "%s_THROWS", materials->names[i]);
        for (size_t k = 0; k < constant.size; k++)
            constant.data[k] = (char)toupper((unsigned char)constant.data[k]);
        found = !glsl_scan_declares(&scan, "bool", text_string(&constant));
        text_free(&constant);
    }
    glsl_scan_free(&scan);
    return found;
}

/* Materials with narrow lobes tell how much light they throw. The others throw none, or their bounces have no
 * density and throw all. */
static void generate_throws(const GlslMaterials *materials, Text *text) {
    GlslScan scan = glsl_scan(text_string(text));
    text_print(text, "float material_throws(Material material) {\n");
    for (int i = 0; i < materials->count; i++) {
        Text function = {0};
        text_print(&function, "%s_throws", materials->names[i]);
        if (glsl_scan_defines(&scan, text_string(&function)))
            text_print(text, "    if (material.kind == %d) return %s(material);\n", i,
                       text_string(&function));
        text_free(&function);
    }
    text_print(text, "    return 0.0;\n}\n");
    glsl_scan_free(&scan);
}

void glsl_materials_write(const GlslMaterials *materials, Text *text) {
    generate_dispatch(materials, text, "Bounce", "sample", "vec2 u, vec2 v", "u, v",
                      "Bounce(normal, vec3(0.0), 0.0, false)");
    generate_dispatch(materials, text, "float", "pdf", "vec3 outgoing", "outgoing", "0.0");
    generate_dispatch(materials, text, "vec3", "value", "vec3 outgoing", "outgoing", "vec3(0.0)");
    generate_emitted(materials, text);
    generate_throws(materials, text);
}

void glsl_materials_free(GlslMaterials *materials) {
    for (int i = 0; i < materials->count; i++) free(materials->names[i]);
    free(materials->names);
    *materials = (GlslMaterials){0};
}
