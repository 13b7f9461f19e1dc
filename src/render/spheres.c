#include "render/spheres.h"

#include "base/memory.h"
#include "base/text.h"
#include "gl/texture.h"
#include "render/inputs.h"
#include "render/renderer.h"
#include "scene/sphere_file.h"
#include "scene/sphere_tree.h"

#include <math.h>
#include <stdlib.h>

/* FILL_COLUMNS stands in pass/fill_spheres.glsl, too. */
enum { TABLE_UNIT = 10, FILL_COLUMNS = 1024 };

static const double farthest_m = 1e7;

static bool create_fill(Spheres *spheres, const char *library, const Scene *scene, Error *error) {
    Text inputs = {0};
    GlslSource source;
    if (!glsl_source_create(&source, library, scene->file->path, NULL, error)) return false;
    inputs_declare(inputs_wanted(&source), &inputs);
    glsl_source_destroy(&source);
    const GlslSlot slots[] = {
        {"inputs", NULL, text_string(&inputs)}, {"scene", scene->file->path, NULL}, {NULL, NULL, NULL}};
    bool ok = glsl_source_create(&source, library, "pass/fill_spheres.glsl", slots, error);
    if (ok) ok = program_create(&spheres->fill, spheres->gl, &source, error);
    glsl_source_destroy(&source);
    text_free(&inputs);
    return ok;
}

/* Draws scene_sphere(0 .. rows * FILL_COLUMNS - 1), of radius 0 from `count` on. */
static bool draw(const Spheres *spheres, const Scene *scene, int count, int rows, float *numbers,
                 Error *error) {
    const GlApi *gl = spheres->gl;
    GLuint framebuffer = 0, texture = texture_create(gl, FILL_COLUMNS, rows, GL_NEAREST, NULL);
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    gl->Viewport(0, 0, FILL_COLUMNS, rows);
    program_use(&spheres->fill);
    inputs_set(&spheres->fill, scene, FILL_COLUMNS, rows);
    renderer_set_parameters(&spheres->fill, scene);
    program_set_int(&spheres->fill, "fill_count", count);
    program_draw(&spheres->fill, 0, 0, FILL_COLUMNS, rows);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->ReadPixels(0, 0, FILL_COLUMNS, rows, GL_RGBA, GL_FLOAT, numbers);
    gl->DeleteFramebuffers(1, &framebuffer);
    gl->DeleteTextures(1, &texture);
    return gl_check(gl, "drawing scene_sphere()", error);
}

static bool check(const Scene *scene, const float *numbers, int count, Error *error) {
    for (int i = 0; i < 4 * count; i++) {
        if (fabs((double)numbers[i]) <= farthest_m) continue;
        return error_set(error, STATUS_SCENE, "%s:%d: scene_sphere(%d) is not finite or past %g m",
                         scene->file->path, scene->file->spheres_line, i / 4, farthest_m);
    }
    return true;
}

static bool get(const Spheres *spheres, const Scene *scene, float **numbers, int *count, Error *error) {
    *count = scene_sphere_count(scene);
    if (*count < 0) {
        char *path = scene_sphere_path(scene);
        bool read = sphere_file_read(path, SCENE_MOST_SPHERES, numbers, count, error);
        free(path);
        return read;
    }
    int rows = (*count + FILL_COLUMNS - 1) / FILL_COLUMNS;
    *numbers = memory_get((size_t)rows * FILL_COLUMNS, 4 * sizeof **numbers);
    return !rows ||
           (draw(spheres, scene, *count, rows, *numbers, error) && check(scene, *numbers, *count, error));
}

static bool upload(Spheres *spheres, const Scene *scene, const SphereTree *tree, Error *error) {
    int rows = tree->rows ? tree->rows : 1, columns = tree->rows ? SPHERE_TREE_COLUMNS : 1;
    if (columns > spheres->max_texture_size || rows > spheres->max_texture_size) {
        return error_set(error, STATUS_SCENE,
                         "%s:%d: too many spheres: they need a texture of %dx%d, this OpenGL's "
                         "limit is %d",
                         scene->file->path, scene->file->spheres_line, columns, rows,
                         spheres->max_texture_size);
    }
    texture_resize(spheres->gl, spheres->table, columns, rows, tree->rows ? tree->texels : NULL);
    spheres->entries = tree->entries;
    return gl_check(spheres->gl, "the table of spheres", error);
}

bool spheres_fill(Spheres *spheres, const Scene *scene, Error *error) {
    float *numbers = NULL;
    int count;
    bool ok = get(spheres, scene, &numbers, &count, error);
    if (ok) {
        SphereTree tree = sphere_tree_create(numbers, count);
        ok = upload(spheres, scene, &tree, error);
        sphere_tree_destroy(&tree);
    }
    free(numbers);
    return ok;
}

bool spheres_create(Spheres *spheres, const Context *context, const char *library, const Scene *scene,
                    Error *error) {
    *spheres = (Spheres){0};
    if (!scene->file->spheres[0]) return true;
    *spheres = (Spheres){.gl = &context->gl, .max_texture_size = context->max_texture_size};
    spheres->table = texture_create(spheres->gl, 1, 1, GL_NEAREST, NULL);
    if ((scene_sphere_count(scene) < 0 || create_fill(spheres, library, scene, error)) &&
        spheres_fill(spheres, scene, error))
        return true;
    spheres_destroy(spheres);
    return false;
}

void spheres_destroy(Spheres *spheres) {
    if (!spheres->gl) return;
    spheres->gl->DeleteTextures(1, &spheres->table);
    program_destroy(&spheres->fill);
    *spheres = (Spheres){0};
}

const char *spheres_slot(const Scene *scene) {
    return scene->file->spheres[0] ? "pass/spheres.glsl" : "pass/spheres_none.glsl";
}

void spheres_bind(const Spheres *spheres) {
    if (!spheres->gl) return;
    spheres->gl->ActiveTexture(GL_TEXTURE0 + TABLE_UNIT);
    spheres->gl->BindTexture(GL_TEXTURE_2D, spheres->table);
    spheres->gl->ActiveTexture(GL_TEXTURE0);
}

void spheres_use(const Spheres *spheres, const Program *program) {
    if (!spheres->gl) return;
    spheres_bind(spheres);
    program_set_int(program, "spheres_table", TABLE_UNIT);
    program_set_int(program, "spheres_count", spheres->entries);
}
