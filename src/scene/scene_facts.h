/* What a scene's GLSL says about the scene, found once when the file is read. What a scene has no use for is
 * not compiled, and errors are about the scene and not about what the host makes of it. */
#pragma once

#include "base/text.h"
#include "source/glsl_source.h"

/* Shadertoy's inputs. */
typedef enum SceneInput { INPUT_RESOLUTION, INPUT_TIME, INPUT_FRAME, INPUT_MOUSE, SCENE_INPUTS } SceneInput;

typedef struct SceneFacts {
    /* The signature of the first function that a scene has to define and this one lacks; NULL where none is.
     */
    const char *missing;
    /* Whether it defines scene_sphere(). */
    bool makes_spheres;
    /* Whether it defines scene_mist(). */
    bool makes_mist;
    /* Whether it is no scene but a program that paints a picture by itself (scene/toy_source.h). */
    bool is_toy;
    /* Whether its rays search by loops (glsl/shape/search.glsl), and how often the text calls march() and
     * hit_spheres(). */
    bool searches;
    int march_calls, hit_spheres_calls;
    /* Whether one of its materials emits. */
    bool emits;
    /* Whether one of its materials may throw light in narrow lobes or single directions, as mirrors and glass
     * do. */
    bool throws;
    /* Which of the library's materials it includes. */
    bool has_glass, has_rough_metal, has_author;
    /* The names of its materials by their numbers; owned. */
    char **materials;
    int material_count;
    /* A bit for each input that it mentions, and for each that it does not declare itself. */
    unsigned mentioned_inputs, owed_inputs;
} SceneFacts;

/* `source`: the scene flattened alone. To be freed. */
SceneFacts scene_facts(const GlslSource *source);
void scene_facts_free(SceneFacts *facts);

/* Whether the scene mentions the input. */
bool scene_facts_mention(const SceneFacts *facts, SceneInput input);

/* The declarations of the inputs that the scene is owed. */
void scene_facts_declare_inputs(const SceneFacts *facts, Text *declarations);
