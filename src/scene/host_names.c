#include "scene/host_names.h"

#include "source/glsl_scan.h"
#include "source/glsl_uniforms.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>

static bool declares(const SourceFile *file, const char *name) {
    GlslScan scan = glsl_scan(text_string(&file->text));
    GlslUniforms uniforms = glsl_uniforms(scan.code);
    bool found = glsl_uniforms_find(&uniforms, name) != NULL;
    glsl_uniforms_free(&uniforms);
    glsl_scan_free(&scan);
    return found;
}

bool host_names_find(SourceStore *store, const char *name, char *path, size_t size) {
    Text folder = {0};
    text_print(&folder, "%s/pass", store->folder);
    DIR *entries = opendir(text_string(&folder));
    bool found = false;
    for (struct dirent *entry; !found && entries && (entry = readdir(entries));) {
        const char *dot = strrchr(entry->d_name, '.');
        const SourceFile *file;
        Error ignored;
        if (!dot || strcmp(dot, ".glsl") != 0) continue;
        Text full = {0};
        text_print(&full, "%s/%s", text_string(&folder), entry->d_name);
        found = source_store_read(store, text_string(&full), &file, &ignored) && declares(file, name);
        if (found) snprintf(path, size, "pass/%s", entry->d_name);
        text_free(&full);
    }
    if (entries) closedir(entries);
    text_free(&folder);
    return found;
}
