/* A scene: a GLSL file's annotations, and the settings that were made over them. */
#pragma once

#include "base/error.h"
#include "scene/atmosphere.h"

typedef enum ParameterType { PARAMETER_SLIDER, PARAMETER_CHECKBOX, PARAMETER_COLOR } ParameterType;

/* An annotated uniform. */
typedef struct Parameter {
    char name[64];
    ParameterType type;
    double value[3]; /* [0] for a slider and a checkbox (0 or 1) */
    double min, max;
    char unit[16], label[96];
} Parameter;

/* `NAME VALUE` of a preset, applied as --set does. */
typedef struct Setting {
    char name[64], value[96];
} Setting;

typedef struct Preset {
    char name[64];
    Setting settings[16];
    int setting_count;
    int line;
} Preset;

/* A sphere that the scene names: x, y, z, radius, each a number or a slider's name. */
typedef struct NamedSphere {
    char words[4][64];
    int line;
} NamedSphere;

/* Which way a flat mirror faces: azimuth and elevation, degrees, each a number or a slider's name, which may
 * have a minus before it. */
typedef struct NamedPlane {
    char words[2][64];
    int line;
} NamedPlane;

enum { MOST_NAMED_SPHERES = 16, SCENE_MOST_SPHERES = 1000000 };

typedef struct Scene {
    char *path; /* owned */
    char title[128], look[256];
    double eye[3], target[3], fov_deg; /* vertical angle */
    double sun_elevation_deg, sun_azimuth_deg, sun_radius_deg;
    bool sun_disk; /* whether the sun is there itself, beside the sky that it lights */
    double exposure_ev;
    double time_s, mouse[4]; /* Shadertoy's iTime and iMouse, for scenes that want them */
    int width, height;
    char sky[64]; /* the sky method that the scene asks for; empty if it asks for none */
    int sky_line;
    Atmosphere atmosphere;
    Parameter parameters[32];
    int parameter_count;
    Preset presets[32];
    int preset_count;
    NamedSphere bounds[MOST_NAMED_SPHERES]; /* around what may block the sky */
    int bound_count;
    NamedSphere mirrors[MOST_NAMED_SPHERES]; /* mirrors in the shape of a sphere */
    int mirror_count;
    NamedPlane planes[MOST_NAMED_SPHERES]; /* flat mirrors */
    int plane_count;
    char spheres[256]; /* for hit_spheres(): how many, as a number or a slider's name, or a CSV file; or empty
                        */
    int spheres_line;
    NamedSphere emitters[MOST_NAMED_SPHERES]; /* about what emits */
    int emitter_count;
} Scene;

/* Pictures' limits, as a sentence for errors and the check itself (STATUS_USAGE). */
MUST_CHECK bool scene_check_size(double width, double height, Error *error);

/* The scene that a file without annotations would be; `path` names it in errors. */
Scene scene_default(const char *path);

/* Reads a scene file's annotations; presets are tried out, so that a wrong one is found at once.
 * STATUS_SCENE with "path:line: ...". */
MUST_CHECK bool scene_read(Scene *scene, const char *path, Error *error);
void scene_destroy(Scene *scene);

/* Sets "sun.elevation", "camera.fov", "exposure", "atmosphere.mie_g" or a parameter. STATUS_USAGE names what
 * is known. */
MUST_CHECK bool scene_set(Scene *scene, const char *name, const char *value, Error *error);
MUST_CHECK bool scene_choose_preset(Scene *scene, const char *name, Error *error);

/* A named sphere's numbers, with the sliders as they are: x, y, z, radius. */
void scene_sphere(const Scene *scene, const NamedSphere *sphere, double out[4]);

/* How many spheres scene_sphere() makes, with the sliders as they are; -1 where they come from a file. */
int scene_sphere_count(const Scene *scene);

/* That file, which is named from the scene's folder; to be freed. */
char *scene_sphere_path(const Scene *scene);

/* What no single value shows: a camera that looks somewhere, an atmosphere above its planet (STATUS_USAGE).
 */
MUST_CHECK bool scene_check(const Scene *scene, Error *error);
