#include "scene/scene_facts.h"

#include "base/memory.h"
#include "source/glsl_materials.h"
#include "source/glsl_scan.h"

#include <stdlib.h>
#include <string.h>

static const char *const inputs[SCENE_INPUTS][2] = {[INPUT_RESOLUTION] = {"vec3", "iResolution"},
                                                    [INPUT_TIME] = {"float", "iTime"},
                                                    [INPUT_FRAME] = {"int", "iFrame"},
                                                    [INPUT_MOUSE] = {"vec4", "iMouse"}};

/* What every scene defines, and what one that marches defines besides. */
static const char *find_missing(const GlslSource *source, const GlslScan *scan) {
    static const struct {
        const char *name, *signature;
        /* The file whose scenes need it; NULL where all do. */
        const char *file;
    } functions[] = {
        {"scene_intersect", "void scene_intersect(Ray ray, INOUT(Hit) hit)", NULL},
        {"scene_material", "Material scene_material(Hit hit)", NULL},
        {"scene_distance", "float scene_distance(vec3 p)", "shape/march.glsl"},
    };
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        bool needed = !functions[i].file || glsl_source_includes(source, functions[i].file);
        if (needed && !glsl_scan_defines(scan, functions[i].name)) return functions[i].signature;
    }
    return NULL;
}

static void find_inputs(const GlslScan *scan, SceneFacts *facts) {
    for (int i = 0; i < SCENE_INPUTS; i++) {
        if (!glsl_scan_mentions(scan, inputs[i][1])) continue;
        facts->mentioned_inputs |= 1U << i;
        if (!glsl_scan_declares(scan, inputs[i][0], inputs[i][1])) facts->owed_inputs |= 1U << i;
    }
}

/* A file that has a structure Ray of its own brings a world of its own, also if functions in it have a
 * scene's names: no scene could have it beside the library's. */
static bool paints(const GlslScan *scan) {
    bool has_entry = glsl_scan_defines(scan, "mainImage") || glsl_scan_defines(scan, "main");
    bool is_scene = glsl_scan_defines(scan, "scene_intersect") && !glsl_scan_declares(scan, "struct", "Ray");
    return has_entry && !is_scene;
}

SceneFacts scene_facts(const GlslSource *source) {
    GlslScan scan = glsl_scan(text_string(&source->text));
    SceneFacts facts = {.missing = find_missing(source, &scan),
                        .makes_spheres = glsl_scan_defines(&scan, "scene_sphere"),
                        .makes_mist = glsl_scan_defines(&scan, "scene_mist"),
                        .is_toy = paints(&scan),
                        .searches = glsl_source_includes(source, "shape/search.glsl"),
                        .march_calls = glsl_scan_calls(&scan, "march"),
                        .hit_spheres_calls = glsl_scan_calls(&scan, "hit_spheres"),
                        .emits = glsl_materials_emit(&source->materials, text_string(&source->text)),
                        .throws = glsl_materials_throw(&source->materials, text_string(&source->text)),
                        .has_glass = glsl_source_includes(source, "material/glass.glsl"),
                        .has_rough_metal = glsl_source_includes(source, "material/rough_metal.glsl"),
                        .has_author = glsl_source_includes(source, "material/author.glsl")};
    find_inputs(&scan, &facts);
    glsl_scan_free(&scan);
    facts.materials = memory_get((size_t)source->materials.count, sizeof *facts.materials);
    facts.material_count = source->materials.count;
    for (int i = 0; i < source->materials.count; i++)
        facts.materials[i] = memory_string(source->materials.names[i]);
    return facts;
}

void scene_facts_free(SceneFacts *facts) {
    for (int i = 0; i < facts->material_count; i++) free(facts->materials[i]);
    free(facts->materials);
    *facts = (SceneFacts){0};
}

bool scene_facts_mention(const SceneFacts *facts, SceneInput input) {
    return facts->mentioned_inputs & 1U << input;
}

void scene_facts_declare_inputs(const SceneFacts *facts, Text *declarations) {
    for (int i = 0; i < SCENE_INPUTS; i++) {
        if (facts->owed_inputs & 1U << i)
            text_print(declarations, "uniform %s %s;\n", inputs[i][0], inputs[i][1]);
    }
}
