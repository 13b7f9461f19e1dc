/* A scene: its file, and the settings that were made over what the file says. It is small and may be copied;
 * a copy borrows the file. */
#pragma once

#include "scene/scene_file.h"
#include "scene/setting.h"

typedef struct Scene {
    const SceneFile *file;
    SceneValues values;
} Scene;

/* The scene that a file without annotations would be; `path` names it in errors. `library` is the folder of
 * the GLSL library. To be destroyed. */
Scene scene_default(const char *path, const char *library);

/* Reads a scene's file, with all that it includes: the texts, which are opened this once, the annotations and
 * the facts. Presets are tried out, so that a wrong one is found at once. STATUS_SCENE with "path:line: ...".
 */
MUST_CHECK bool scene_read(Scene *scene, const char *path, const char *library, Error *error);

/* Releases the file. */
void scene_destroy(Scene *scene);

/* A copy with a reference of its own to the file, to be destroyed. */
Scene scene_share(const Scene *scene);

/* Whether both have the same file, read at the same time, and the same values. */
bool scene_same(const Scene *a, const Scene *b);

/* Sets "sun.elevation", "camera.fov", "exposure", "atmosphere.mie_g" or a parameter. STATUS_USAGE names what
 * is known. */
MUST_CHECK bool scene_set(Scene *scene, const char *name, const char *value, Error *error);
MUST_CHECK bool scene_choose_preset(Scene *scene, const char *name, Error *error);

/* Sets the sun's place and keeps its radius. The scene's clock then no longer says where the sun stands. */
void scene_set_sun(Scene *scene, double elevation_deg, double azimuth_deg);

/* How many hints of a kind there are: none if the kind is ignored. */
int scene_hint_count(const Scene *scene, HintKind kind);

/* One annotated hint's numbers, with the sliders as they are. Hints that the scene defines in GLSL are known
 * to the GPU alone (render/hints.h). */
void scene_hint(const Scene *scene, HintKind kind, int index, double out[MOST_HINT_NUMBERS]);

/* Whether the scene has mist that is switched on. */
bool scene_has_mist(const Scene *scene);

/* The mean cosine of the angle by which it turns light. */
double scene_mist_forward(const Scene *scene);

/* Whether the atmosphere's air lies between the surfaces. */
bool scene_has_air(const Scene *scene);

/* Whether the camera stands where one of the scene's portals faces, so that it is in the room that light
 * enters there. Where the scene defines its portals in GLSL that is not known, and taken to be so. */
bool scene_is_seen_from_room(const Scene *scene);

/* How many spheres the GLSL function scene_sphere() makes, with the sliders as they are; -1 where they come
 * from a file. */
int scene_sphere_count(const Scene *scene);

/* The file that the spheres come from, which is named from the scene's folder; NULL where there is none. */
const SourceFile *scene_sphere_file(const Scene *scene);

/* What no single value shows: a camera that looks somewhere, an atmosphere above its planet (STATUS_USAGE).
 */
MUST_CHECK bool scene_check(const Scene *scene, Error *error);
