/* A scene with up to four files beside it, parts of the input that lines "===" separate: annotations,
 * includes and the files' layer as they are, spheres, and what is changed in files that paint by themselves.
 */
#include "fuzz/input.h"

#include "scene/scene.h"
#include "scene/sphere_file.h"
#include "scene/toy_source.h"
#include "source/glsl_uniforms.h"

#include <stdlib.h>

static void read_spheres(const Scene *scene) {
    const SourceFile *file = scene_sphere_file(scene);
    float *spheres;
    int count;
    Error error;
    if (file && sphere_file_parse(file, SCENE_MOST_SPHERES, &spheres, &count, &error)) free(spheres);
}

static void read_toy(const Scene *scene) {
    GlslSource source;
    Text notes = {0};
    Error error;
    if (toy_source_create(&source, &notes, &(ToyParams){.file = scene->file}, &error))
        glsl_source_destroy(&source);
    text_free(&notes);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const char *const names[] = {"scene.glsl", "a.glsl", "sub/b.glsl", "material/mirror.glsl",
                                        "balls.csv"};
    const char *path = NULL;
    input_folder("sub");
    input_folder("material");
    for (int i = 0; i < 5; i++) {
        const uint8_t *part;
        size_t length = input_part(&data, &size, &part);
        const char *written = input_file(names[i], part, length);
        if (!path) path = written;
    }
    Scene scene;
    Error error;
    if (!scene_read(&scene, path, "glsl", &error)) return 0;
    read_spheres(&scene);
    if (scene.file->facts.is_toy) read_toy(&scene);
    (void)!scene_check(&scene, &error);
    scene_destroy(&scene);
    return 0;
}
