#include "scene/scene_file.h"

#include "base/memory.h"
#include "scene/sun_clock.h"

#include <stdlib.h>
#include <string.h>

SceneFile *scene_file_create(const char *path, const char *library) {
    SceneFile *file = memory_get(1, sizeof *file);
    *file = (SceneFile){.path = memory_string(path),
                        .sources = source_store_create(library),
                        .title = memory_string(""),
                        .look = memory_string(""),
                        .width = 512,
                        .height = 512,
                        .values = {.camera = {.eye = {0, 2, -4}, .fov_deg = 90},
                                   .sun = sun_at(30, 0, 0.2666),
                                   .clock = sun_clock_none(),
                                   .atmosphere = atmosphere_preset(0)->atmosphere},
                        .users = 1};
    source_store_choose(file->sources, path);
    return file;
}

const SceneFile *scene_file_share(const SceneFile *file) {
    ((SceneFile *)file)->users++;
    return file;
}

void scene_file_release(const SceneFile *file) {
    SceneFile *own = (SceneFile *)file;
    if (!own || --own->users > 0) return;
    for (int i = 0; i < own->parameter_count; i++) {
        free(own->parameters[i].unit);
        free(own->parameters[i].label);
    }
    scene_facts_free(&own->facts);
    source_store_release(own->sources);
    free(own->title);
    free(own->look);
    free(own->path);
    free(own->common);
    free(own->buffer);
    free(own);
}
