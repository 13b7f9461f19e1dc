#include "render/spheres.h"

#include "base/memory.h"
#include "scene/sphere_file.h"
#include "scene/sphere_tree.h"

#include <math.h>
#include <stdlib.h>

/* Texels in a row of the texture that scene_sphere() fills. */
enum { DRAWN_COLUMNS = 1024 };

static const double farthest_m = 1e7;

const char *spheres_slot(const Scene *scene) {
    return scene->file->spheres[0] ? "pass/spheres.glsl" : "pass/spheres_none.glsl";
}

static bool never(const void *frame) {
    (void)frame;
    return false;
}

static const Scene *scene_of(const void *frame) {
    return ((const Frame *)frame)->scene;
}

/* drawn_spheres: what scene_sphere() makes. */

static void drawn_size(const void *frame, int *width, int *height) {
    int count = scene_sphere_count(scene_of(frame));
    *width = DRAWN_COLUMNS;
    *height = count ? (count + DRAWN_COLUMNS - 1) / DRAWN_COLUMNS : 1;
}

/* Appends the scene's parameters, its time and its mouse. */
static void drawn_key(const void *frame, Text *key) {
    const SceneValues *values = &scene_of(frame)->values;
    text_append(key, values->parameters, sizeof values->parameters);
    text_append(key, &values->time_s, sizeof values->time_s);
    text_append(key, values->mouse, sizeof values->mouse);
}

static void drawn_uniforms(const Resource *drawn, const void *frame, Uniforms *uniforms) {
    (void)drawn;
    uniforms_declared_in(uniforms, "pass/fill_spheres.glsl");
    uniforms_int(uniforms, "fill_count", scene_sphere_count(scene_of(frame)));
    uniforms_int(uniforms, "fill_columns", DRAWN_COLUMNS);
}

const ResourceKind drawn_spheres = {.name = "what scene_sphere() makes",
                                    .entry = "pass/fill_spheres.glsl",
                                    .samplers = {"drawn_spheres"},
                                    .filter = GL_NEAREST,
                                    .wanted = never,
                                    .size = drawn_size,
                                    .key = drawn_key,
                                    .uniforms = drawn_uniforms};

/* Puts the tree into a texture. */

static bool upload(Resource *table, const Scene *scene, const float *numbers, int count, Error *error) {
    SphereTree tree = sphere_tree_create(numbers, count);
    int rows = tree.rows ? tree.rows : 1, columns = tree.rows ? SPHERE_TREE_COLUMNS : 1;
    bool fits = columns <= table->max_texture_size && rows <= table->max_texture_size;
    if (fits) {
        resource_upload(table, 0, columns, rows, tree.rows ? tree.texels : NULL);
        table->entries = tree.entries;
    } else {
        error_set(error, STATUS_SCENE,
                  "%s:%d: too many spheres: they need a texture of %dx%d, this OpenGL's limit is %d",
                  scene->file->path, scene->file->spheres_line, columns, rows, table->max_texture_size);
    }
    sphere_tree_destroy(&tree);
    return fits;
}

static void table_uniforms(const Resource *table, const void *frame, Uniforms *uniforms) {
    (void)frame;
    uniforms_declared_in(uniforms, "pass/spheres.glsl");
    uniforms_int(uniforms, "spheres_count", table ? table->entries : 0);
}

static bool check(const Scene *scene, const float *numbers, int count, Error *error) {
    for (int i = 0; i < 4 * count; i++) {
        if (fabs((double)numbers[i]) <= farthest_m) continue;
        return error_set(error, STATUS_SCENE, "%s:%d: scene_sphere(%d) is not finite or past %g m",
                         scene->file->path, scene->file->spheres_line, i / 4, farthest_m);
    }
    return true;
}

static bool wants_made(const void *frame) {
    const Scene *scene = scene_of(frame);
    return scene && scene->file->spheres[0] && scene_sphere_count(scene) >= 0;
}

static bool compute_made(Resource *table, const void *frame, Error *error) {
    const Scene *scene = scene_of(frame);
    const Resource *drawn = table->inputs[0];
    int count = scene_sphere_count(scene);
    float *numbers = memory_get((size_t)drawn->width * (size_t)drawn->height, 4 * sizeof *numbers);
    bool ok = resource_read(drawn, 0, numbers, error) && check(scene, numbers, count, error) &&
              upload(table, scene, numbers, count, error);
    free(numbers);
    return ok;
}

const ResourceKind scene_spheres = {.name = "the table of spheres",
                                    .samplers = {"spheres_table"},
                                    .filter = GL_NEAREST,
                                    .inputs = {&drawn_spheres},
                                    .wanted = wants_made,
                                    .compute = compute_made,
                                    .uniforms = table_uniforms};

static bool wants_read(const void *frame) {
    const Scene *scene = scene_of(frame);
    return scene && scene->file->spheres[0] && scene_sphere_count(scene) < 0;
}

static bool compute_read(Resource *table, const void *frame, Error *error) {
    const Scene *scene = scene_of(frame);
    float *numbers = NULL;
    int count;
    bool ok = sphere_file_parse(scene_sphere_file(scene), SCENE_MOST_SPHERES, &numbers, &count, error) &&
              upload(table, scene, numbers, count, error);
    free(numbers);
    return ok;
}

const ResourceKind file_spheres = {.name = "the table of spheres",
                                   .samplers = {"spheres_table"},
                                   .filter = GL_NEAREST,
                                   .wanted = wants_read,
                                   .compute = compute_read,
                                   .uniforms = table_uniforms};
