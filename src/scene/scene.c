#include "scene/scene.h"

#include "base/number.h"
#include "base/text.h"
#include "base/vec3.h"
#include "scene/annotation.h"
#include "scene/annotation_hints.h"
#include "scene/hint_glsl.h"
#include "scene/spectrum.h"
#include "scene/sun_clock.h"
#include "scene/toy_tabs.h"
#include "scene/uniform_check.h"

#include <math.h>
#include <string.h>

Scene scene_default(const char *path, const char *library) {
    const SceneFile *file = scene_file_create(path, library);
    return (Scene){file, file->values};
}

/* What the scene's GLSL says, from the same texts that its programs will be made of. */
static bool find_facts(SceneFile *file, Error *error) {
    GlslSource source;
    if (!glsl_source_create(&source, file->sources, file->path, NULL, error)) return false;
    file->facts = scene_facts(&source);
    /* A text without scene_intersect() is no scene, and is told so where it is used as one. */
    bool ok =
        hint_glsl_find(file, &source, error) && (file->facts.missing || uniform_check(file, &source, error));
    glsl_source_destroy(&source);
    return ok;
}

/* The file of spheres, where that is what the annotation names. */
static bool read_sphere_file(SceneFile *file, Error *error) {
    if (!hints_name_file(file)) return true;
    const char *name = file->spheres, *slash = strrchr(file->path, '/');
    Text path = {0};
    if (slash && name[0] != '/') text_append(&path, file->path, (size_t)(slash - file->path) + 1);
    text_print(&path, "%s", name);
    bool ok = source_folders_check_name(name, error) &&
              source_store_read_table(file->sources, text_string(&path), &file->sphere_file, error);
    text_free(&path);
    return ok || error_prefix(error, "%s:%d: spheres: ", file->path, file->spheres_line);
}

bool scene_read(Scene *scene, const char *path, const char *library, Error *error) {
    SceneFile *file = scene_file_create(path, library);
    bool ok = annotation_read(file, error) && read_sphere_file(file, error) && find_facts(file, error);
    if (ok) toy_tabs_find(file);
    if (!ok) scene_file_release(file);
    *scene = ok ? (Scene){file, file->values} : (Scene){0};
    return ok;
}

void scene_destroy(Scene *scene) {
    scene_file_release(scene->file);
    *scene = (Scene){0};
}

Scene scene_share(const Scene *scene) {
    Scene copy = *scene;
    if (copy.file) scene_file_share(copy.file);
    return copy;
}

bool scene_same(const Scene *a, const Scene *b) {
    return a->file == b->file && scene_values_same(&a->values, &b->values);
}

bool scene_set(Scene *scene, const char *name, const char *value, Error *error) {
    return setting_apply(scene->file, &scene->values, name, value, error);
}

bool scene_choose_preset(Scene *scene, const char *name, Error *error) {
    return setting_choose_preset(scene->file, &scene->values, name, error);
}

void scene_set_sun(Scene *scene, double elevation_deg, double azimuth_deg) {
    scene->values.sun = sun_at(elevation_deg, azimuth_deg, scene->values.sun.radius_deg);
    scene->values.clock.utc_s = NAN;
}

/* A word of a hint: a number, or a slider's value, with the minus that may stand before its name. */
static double number_of(const Scene *scene, const char *word) {
    const SceneFile *file = scene->file;
    bool minus = *word == '-';
    double number;
    if (number_parse(word, &number)) return number;
    for (int i = 0; i < file->parameter_count; i++) {
        if (strcmp(file->parameters[i].name, word + minus) != 0) continue;
        double value = scene->values.parameters[i][0];
        return minus ? -value : value;
    }
    return 0;
}

int scene_hint_count(const Scene *scene, HintKind kind) {
    return scene->values.ignored_hints & 1U << kind ? 0 : scene->file->hints[kind].count;
}

void scene_hint(const Scene *scene, HintKind kind, int index, double out[MOST_HINT_NUMBERS]) {
    const Hint *hint = &scene->file->hints[kind].list[index];
    for (int i = 0; i < MOST_HINT_NUMBERS; i++)
        out[i] = i < hint_info(kind)->components ? number_of(scene, hint->words[i]) : 0;
}

bool scene_has_mist(const Scene *scene) {
    const Mist *mist = &scene->file->mist;
    return mist->line && scene->values.parameters[mist->parameter][0] > 0;
}

double scene_mist_forward(const Scene *scene) {
    return number_of(scene, scene->file->mist.words[MIST_FORWARD]);
}

bool scene_has_air(const Scene *scene) {
    return scene->file->air_line && scene->values.parameters[scene->file->air_parameter][0] > 0;
}

bool scene_is_seen_from_room(const Scene *scene) {
    int portals = scene_hint_count(scene, HINT_PORTAL);
    if (scene->file->hints[HINT_PORTAL].in_glsl) return portals > 0;
    for (int i = 0; i < portals; i++) {
        double numbers[MOST_HINT_NUMBERS], from[3];
        scene_hint(scene, HINT_PORTAL, i, numbers);
        /* The sun's direction from the same two angles is where the portal faces. */
        Sun facing = sun_at(numbers[4], numbers[3], 1);
        vec3_subtract(scene->values.camera.eye, numbers, from);
        if (vec3_dot(from, facing.direction) > 0) return true;
    }
    return false;
}

int scene_sphere_count(const Scene *scene) {
    const SceneFile *file = scene->file;
    double number;
    if (number_parse(file->spheres, &number)) return (int)number;
    for (int i = 0; i < file->parameter_count; i++) {
        if (strcmp(file->parameters[i].name, file->spheres) == 0) return (int)scene->values.parameters[i][0];
    }
    return -1;
}

const SourceFile *scene_sphere_file(const Scene *scene) {
    return scene->file->sphere_file;
}

bool scene_check(const Scene *scene, Error *error) {
    const double *eye = scene->values.camera.eye, *target = scene->values.camera.target;
    double distance = hypot(hypot(target[0] - eye[0], target[1] - eye[1]), target[2] - eye[2]);
    if (distance < 1e-6)
        return error_set(error, STATUS_USAGE, "%s: the camera's eye is at its target", scene->file->path);
    return sun_clock_check(&scene->values.clock, error) &&
           atmosphere_check(&scene->values.atmosphere, error) &&
           spectrum_check(&scene->values.atmosphere, error);
}
