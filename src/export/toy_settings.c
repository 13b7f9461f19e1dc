#include "export/toy_settings.h"

#include "export/constants.h"
#include "gl/camera.h"

#include <stdio.h>
#include <string.h>

static void vector(Text *text, const char *type, const char *name, const double *values, int count) {
    text_print(text, "const %s %s = ", type, name);
    constants_print_vector(text, values, count);
    text_print(text, ";\n");
}

static void camera_vector(Text *text, const char *name, const double *values) {
    text_print(text, "const vec3 %s = ", name);
    constants_print_vector(text, values, 3);
    text_print(text, ";");
}

/* The vectors have a float's nearest digits, so that the picture is that of `render`. Beside them stands what
 * makes them, for somebody who moves the camera. */
static void write_camera(const Scene *scene, Text *text) {
    const Viewpoint *from = &scene->values.camera;
    Camera camera = camera_of(scene, 1, 1);
    bool upright = camera.up[1] > 1e-6;
    text_print(
        text,
        "// The camera, in metres with y up: where it stands and looks, and what leads from the middle of a "
        "square picture to its\n// edges, at distance 1. Each comment says what the constant was made "
        "of, and may take its place.\n");
    camera_vector(text, "CAMERA_EYE", camera.eye);
    text_print(text, "\n");
    camera_vector(text, "CAMERA_FORWARD", camera.forward);
    text_print(text, "  // normalize(");
    constants_print_vector(text, from->target, 3);
    text_print(text, " - CAMERA_EYE)\n");
    camera_vector(text, "CAMERA_RIGHT", camera.right);
    text_print(text, "  // tan(radians(0.5 * ");
    constants_print_float(text, from->fov_deg);
    text_print(text, ")) * normalize(cross(CAMERA_FORWARD, vec3(0.0, %s)))\n",
               upright ? "1.0, 0.0" : "0.0, 1.0");
    camera_vector(text, "CAMERA_UP", camera.up);
    text_print(text, "  // cross(CAMERA_RIGHT, CAMERA_FORWARD)\n");
}

void toy_settings_common(const Scene *scene, int max_hits, unsigned seed, Text *text) {
    const Sun *sun = &scene->values.sun;
    double place[2] = {sun->elevation_deg, sun->azimuth_deg};
    static const double low[2] = {-10, 0}, high[2] = {90, 360};
    bool has_mouse = scene_facts_mention(&scene->file->facts, INPUT_MOUSE);
    write_camera(scene, text);
    text_print(text, "\n// The sun's elevation and azimuth (from +z toward +x) in degrees%s.\n",
               has_mouse ? "" : ", until the mouse is pressed");
    vector(text, "vec2", "SUN", place, 2);
    text_print(
        text,
        "%s\n// The sun may follow the mouse: upward its elevation, to the right its azimuth, from the "
        "picture's lower left\n// corner to its upper right one.\n",
        has_mouse ? "// The scene has the mouse for itself." : "");
    text_print(text, "const bool MOUSE_MOVES_SUN = %s;\n", has_mouse ? "false" : "true");
    vector(text, "vec2", "SUN_AT_CORNER", low, 2);
    vector(text, "vec2", "SUN_AT_OTHER_CORNER", high, 2);
    text_print(text, "\n// Radiance is shown times 2 to the power of this.\nconst float EXPOSURE_EV = ");
    constants_print_float(text, scene->values.exposure_ev);
    text_print(
        text,
        ";\n\n// A path ends after so many hits at the latest. Other seeds give other random numbers.\n"
        "const int MOST_HITS = %d;\nconst uint SEED = %uu;\n\n",
        max_hits, seed);
}

void toy_settings_comment(const char *words, Text *text) {
    for (; *words; words++) text_print(text, "%c", strchr("\r\n\\", *words) ? ' ' : *words);
}

/* The parameter's name as the text has it. */
static const char *name_in(const Parameter *parameter, const Names *found, char *name, size_t size) {
    static const char *const prefixes[] = {"", "own_"};
    for (int i = 0; i < 2; i++) {
        int length = snprintf(name, size, "%s%s", prefixes[i], parameter->name);
        if (names_find(found, name, (size_t)length) >= 0) return name;
    }
    return NULL;
}

void toy_settings_find(const Scene *scene, const GlslTokens *tokens, Names *found) {
    Names all = {0};
    char name[80];
    for (int i = 0; i + 2 < tokens->count; i++) {
        const GlslToken *word = &tokens->list[i + 2];
        if (glsl_token_is(tokens, i, "uniform")) names_add(&all, tokens->text + word->at, word->size);
    }
    for (int i = 0; i < scene->file->parameter_count; i++) {
        if (name_in(&scene->file->parameters[i], &all, name, sizeof name))
            names_add(found, name, strlen(name));
    }
    names_free(&all);
}

/* "The height of the ball, from -0.5 to 3 m." */
static void describe(const Parameter *parameter, Text *text) {
    const char *label = parameter->label[0] ? parameter->label : parameter->name;
    text_print(text, "// ");
    toy_settings_comment(label, text);
    if (parameter->type == PARAMETER_SLIDER)
        text_print(text, ", from %.6g to %.6g%s%s", parameter->min, parameter->max,
                   parameter->unit[0] ? " " : "", parameter->unit);
    text_print(text, ".\n");
}

void toy_settings_parameters(const Scene *scene, const Names *found, Text *text) {
    static const char *const types[] = {"float", "bool", "vec3"};
    for (int i = 0; i < scene->file->parameter_count; i++) {
        const Parameter *parameter = &scene->file->parameters[i];
        const double *value = scene->values.parameters[i];
        char name[80];
        if (!name_in(parameter, found, name, sizeof name)) continue;
        describe(parameter, text);
        text_print(text, "const %s %s = ", types[parameter->type], name);
        switch (parameter->type) {
        case PARAMETER_SLIDER:
            constants_print_float(text, value[0]);
            break;
        case PARAMETER_CHECKBOX:
            text_print(text, "%s", value[0] > 0 ? "true" : "false");
            break;
        case PARAMETER_COLOR:
            constants_print_vector(text, value, 3);
            break;
        }
        text_print(text, ";\n");
    }
}
