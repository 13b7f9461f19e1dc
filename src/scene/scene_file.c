#include "scene/scene_file.h"

#include <stdlib.h>

const SceneFile *scene_file_share(const SceneFile *file) {
    ((SceneFile *)file)->users++;
    return file;
}

void scene_file_release(const SceneFile *file) {
    SceneFile *own = (SceneFile *)file;
    if (!own || --own->users > 0) return;
    free(own->path);
    free(own);
}
