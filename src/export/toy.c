#include "export/toy.h"

#include "export/constants.h"
#include "export/dialect.h"
#include "export/fold.h"
#include "export/prune.h"
#include "export/strip.h"
#include "export/structure_choice.h"
#include "export/toy_folder.h"
#include "export/toy_hold.h"
#include "export/toy_names.h"
#include "export/toy_settings.h"
#include "export/whole_numbers.h"
#include "render/passes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const Pass common_pass = {.name = "Common", .entry = "pass/shadertoy_common.glsl"};

/* Six nodes have a bias of 0.2 % of single radiances, at half the time of eight. */
static const char default_sky[] = "gauss:6";

/* Bytes of the tab Common that leave room for its head, and for what somebody adds. The site is said to take
 * 64 kB. */
enum { MOST_COMMON = 39000 };

typedef struct Maker {
    RenderParams params;
    Plan plan;
    const char *command, *glsl_folder;
    char sky[64];
    /* The parameters as the scene's text has them. */
    Names parameters;
    /* The constants that are not the scene's own, and the texts of the tabs. */
    Text settings;
    ToyTexts texts;
} Maker;

/* A scene's own method, without the table that it may fill. */
static bool choose_sky(Maker *maker, Error *error) {
    const SceneFile *file = maker->params.scene->file;
    MethodChoice choice;
    if (!method_is_auto(maker->params.sky)) return true;
    maker->params.sky = default_sky;
    if (!file->sky[0] || method_is_auto(file->sky)) return true;
    if (!method_choose(&choice, METHOD_SKY, file->sky, error)) {
        error->status = STATUS_SCENE;
        return error_prefix(error, "%s:%d: ", file->path, file->sky_line);
    }
    const char *from = choice.table ? strchr(choice.text, ':') + 1 : choice.text;
    snprintf(maker->sky, sizeof maker->sky, "%.*s", (int)strcspn(from, "@"), from);
    maker->params.sky = maker->sky;
    return true;
}

static bool choose(Maker *maker, Error *error) {
    if (method_is_auto(maker->params.light)) maker->params.light = method_family(METHOD_LIGHT)->fallback;
    return choose_sky(maker, error) && plan_make(&maker->plan, &maker->params, NULL, error) &&
           toy_hold_plan(&maker->plan, &maker->params, error);
}

static void apply(GlslSource *source, TextEdits *edits) {
    Text text = text_edits_apply(edits, text_string(&source->text));
    text_free(&source->text);
    source->text = text;
}

/* The statements that give the scene what it has of Shadertoy's inputs. iTime stands still, because the sums
 * are of one moment. */
static void write_inputs(const Maker *maker, const GlslTokens *tokens, Text *text) {
    const double *mouse = maker->params.scene->values.mouse;
    for (int i = 0; toy_inputs[i]; i++) {
        const char *input = toy_inputs[i];
        if (!toy_names_has_input(tokens, input) || strcmp(input, "iTime") == 0) continue;
        if (!text->size) text_print(text, "    // What the scene has of Shadertoy's inputs.\n");
        text_print(text, "    scene_%s = ", input);
        if (strcmp(input, "iMouse") == 0 &&
            (mouse[0] != 0 || mouse[1] != 0 || mouse[2] != 0 || mouse[3] != 0)) {
            text_print(text, "iMouse == vec4(0.0) ? ");
            constants_print_vector(text, mouse, 4);
            text_print(text, " : ");
        }
        text_print(text, "%s;\n", input);
    }
}

/* The text of a tab that is a file of the library. `inputs` fills its slot. */
static bool make_tab(const Maker *maker, const char *entry, const char *inputs, Text *text, Error *error) {
    const GlslSlot slots[] = {{"scene-inputs", NULL, inputs}, {NULL, NULL, NULL}};
    GlslSource source;
    if (!glsl_source_create(&source, maker->params.scene->file->sources, entry, slots, error)) return false;
    GlslTokens tokens = glsl_tokens(text_string(&source.text));
    TextEdits edits = {0};
    for (int i = 0; i + 3 < tokens.count; i++) {
        /* The exposure is the one uniform. */
        if (!glsl_token_is(&tokens, i, "uniform")) continue;
        text_edits_add(&edits, tokens.list[i].at, tokens.list[i].size, "const");
        text_edits_add(&edits, tokens.list[i + 3].at, 0, " = exp2(EXPOSURE_EV)");
    }
    apply(&source, &edits);
    *text = strip(&source, maker->glsl_folder, STRIP_FEW);
    glsl_tokens_free(&tokens);
    glsl_source_destroy(&source);
    return true;
}

static bool make_tabs(Maker *maker, const GlslSource *common, Error *error) {
    GlslTokens tokens = glsl_tokens(text_string(&common->text));
    Text inputs = {0};
    write_inputs(maker, &tokens, &inputs);
    glsl_tokens_free(&tokens);
    bool ok =
        make_tab(maker, "pass/shadertoy_trace.glsl", text_string(&inputs), &maker->texts.buffer, error) &&
        make_tab(maker, "pass/shadertoy_image.glsl", "", &maker->texts.image, error);
    text_free(&inputs);
    return ok;
}

static bool rename_names(const Maker *maker, GlslSource *common, Error *error) {
    GlslTokens tokens = glsl_tokens(text_string(&common->text));
    Text others = {0};
    TextEdits edits = {0};
    text_print(&others, "%s%s%s", text_string(&maker->settings), text_string(&maker->texts.buffer),
               text_string(&maker->texts.image));
    const ToyNames names = {maker->params.scene->file, common, &tokens, text_string(&others)};
    bool ok = toy_names_put(&names, &edits, error);
    whole_numbers_mend(common, maker->glsl_folder, &tokens, &edits);
    apply(common, &edits);
    text_free(&others);
    glsl_tokens_free(&tokens);
    return ok;
}

static void collect_values(const Maker *maker, Uniforms *values) {
    const RenderParams *params = &maker->params;
    Camera camera = camera_of(params->scene, plan_width(params), plan_height(params));
    Frame frame = frame_of(&maker->plan, params, &camera);
    frame_uniforms(&frame, &maker->plan, params->seed, values);
    for (const ResourceKind *const *kind = picture_tables; *kind; kind++) {
        if ((*kind)->uniforms && resource_is_needed(*kind, picture_tables, &frame))
            (*kind)->uniforms(NULL, &frame, values);
    }
    uniforms_float(values, "scene_iTime", params->scene->values.time_s);
}

static bool put_constants(Maker *maker, GlslSource *common, Error *error) {
    static const char *const variables[] = {"sun_direction",
                                            "sun_level",
                                            "camera_eye",
                                            "camera_forward",
                                            "camera_right",
                                            "camera_up",
                                            "picture_size",
                                            "scene_iResolution",
                                            "scene_iFrame",
                                            "scene_iMouse",
                                            NULL};
    GlslTokens tokens = glsl_tokens(text_string(&common->text));
    Uniforms values = {0};
    TextEdits edits = {0};
    collect_values(maker, &values);
    toy_settings_find(maker->params.scene, &tokens, &maker->parameters);
    const ConstantsParams params = {&values, variables, &maker->parameters};
    bool ok = toy_hold_text(&tokens, &maker->params, error) && constants_put(&tokens, &params, &edits, error);
    apply(common, &edits);
    uniforms_free(&values);
    glsl_tokens_free(&tokens);
    return ok;
}

/* With as many of the library's comments as there is room for. */
static void write_common(Maker *maker, const GlslSource *common) {
    Text *text = &maker->texts.common;
    for (StripComments comments = STRIP_FEW;; comments--) {
        Text rest = strip(common, maker->glsl_folder, comments);
        text_free(text);
        text_print(text, "%s\n%s", text_string(&maker->settings), text_string(&rest));
        text_free(&rest);
        if (text->size <= MOST_COMMON || comments == STRIP_ALL) return;
    }
}

static bool make_common(Maker *maker, GlslSource *common, Error *error) {
    if (!structure_choice_check(common, error)) return false;
    toy_settings_common(maker->params.scene, maker->plan.max_hits, maker->params.seed, &maker->settings);
    if (!make_tabs(maker, common, error) || !rename_names(maker, common, error) ||
        !put_constants(maker, common, error))
        return false;
    toy_settings_parameters(maker->params.scene, &maker->parameters, &maker->settings);
    dialect_expand(common);
    fold(common, maker->glsl_folder);
    prune(common, maker->glsl_folder, text_string(&maker->texts.buffer));
    write_common(maker, common);
    return true;
}

bool toy_export_write(const RenderParams *params, const char *command, const char *folder, Error *error) {
    const SceneFile *file = params->scene->file;
    Maker maker = {.params = *params, .command = command, .glsl_folder = file->sources->folder};
    GlslSource common = {0};
    bool ok = choose(&maker, error) && pass_text(&common_pass, &maker.plan, &maker.params, &common, error) &&
              make_common(&maker, &common, error);
    if (ok) {
        toy_folder_head(&maker.texts, file, command);
        ok = toy_folder_write(&maker.texts, folder, error);
    }
    glsl_source_destroy(&common);
    names_free(&maker.parameters);
    text_free(&maker.settings);
    toy_texts_free(&maker.texts);
    return ok;
}
