/* A scene's file: its texts, what its annotations say, and what its GLSL says. It does not change once it is
 * read, and is shared by all that use it. */
#pragma once

#include "base/error.h"
#include "scene/hint.h"
#include "scene/mist.h"
#include "scene/scene_facts.h"
#include "scene/scene_values.h"

typedef enum ParameterType { PARAMETER_SLIDER, PARAMETER_CHECKBOX, PARAMETER_COLOR } ParameterType;

/* The declaration of an annotated uniform. */
typedef struct Parameter {
    char name[64];
    ParameterType type;
    /* Of a slider. */
    double min, max;
    /* Owned; "" where there is none. */
    char *unit, *label;
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

enum { SCENE_MOST_SPHERES = 1000000 };

typedef struct SceneFile {
    /* As it was given; owned. */
    char *path;
    /* The texts that it is made of, and all that its programs are made of. */
    SourceStore *sources;
    /* Owned; "" where there is none. */
    char *title, *look;
    /* The picture's, pixels. */
    int width, height;
    /* The sky method that the scene asks for; empty if it asks for none. */
    char sky[64];
    int sky_line;
    /* The lines of the annotations that choose the atmosphere and the sun's disk; 0 where there is none. */
    int atmosphere_line, sun_disk_line;
    Parameter parameters[MOST_PARAMETERS];
    int parameter_count;
    Preset presets[32];
    int preset_count;
    HintList hints[HINT_KINDS];
    Mist mist;
    /* Of the atmosphere's air between the surfaces: the annotation's line, 0 where there is none, and the
     * parameter that switches it on and off. */
    int air_line, air_parameter;
    /* For hit_spheres(): how many spheres there are, as a number or a slider's name, or a CSV file that has
     * them; empty if there are none. */
    char spheres[256];
    int spheres_line;
    /* That file; NULL where there is none. */
    const SourceFile *sphere_file;
    SceneFacts facts;
    /* Of a program that paints by itself: the paths of the tabs that belong to it (scene/toy_tabs.h); owned,
     * NULL where there is none. */
    char *common, *buffer;
    /* What the file sets. */
    SceneValues values;
    /* References. */
    int users;
} SceneFile;

/* A file without annotations, to be filled while its one reference is held. `library` is the folder of the
 * GLSL library. */
SceneFile *scene_file_create(const char *path, const char *library);

/* One more reference to the same file, to be released. */
const SceneFile *scene_file_share(const SceneFile *file);

/* The last one frees the file. NULL is allowed. */
void scene_file_release(const SceneFile *file);
