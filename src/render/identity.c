#include "render/identity.h"

#include "base/version.h"

#include <inttypes.h>
#include <string.h>

static void print_numbers(Text *lines, const char *name, const double *numbers, int count) {
    text_print(lines, "%s", name);
    for (int i = 0; i < count; i++) text_print(lines, "%c%.17g", i ? ',' : ' ', numbers[i]);
    text_print(lines, "\n");
}

/* The texts of the scene and of the program that traces its paths. */
static bool print_texts(const RenderParams *params, const Renderer *renderer, Text *lines, Error *error) {
    const SceneFile *file = params->scene->file;
    const SourceFile *spheres = scene_sphere_file(params->scene), *scene = NULL;
    GlslSource source = {0};
    if (!pass_text(paths_pass(&renderer->plan), &renderer->plan, params, &source, error)) return false;
    uint64_t hash = hash_bytes(0, source.text.data, source.text.size);
    glsl_source_destroy(&source);
    if (!source_store_read(file->sources, file->path, &scene, error)) return false;
    hash = hash_bytes(hash, scene->text.data, scene->text.size);
    if (spheres) hash = hash_bytes(hash, spheres->text.data, spheres->text.size);
    text_print(lines, "texts %016" PRIx64 "\n", hash);
    return true;
}

static void print_methods(const Plan *plan, Text *lines) {
    text_print(lines, "sky %s\nfurther %s\nlight %s\nsequence %s\nsun-disk %s\nhits %d\n", plan->sky.text,
               plan->further.text, plan->light.text, plan->sequence.text, plan->sun.text, plan->max_hits);
}

static void print_values(const Scene *scene, Text *lines) {
    const SceneValues *values = &scene->values;
    print_numbers(lines, "camera.eye", values->camera.eye, 3);
    print_numbers(lines, "camera.target", values->camera.target, 3);
    print_numbers(lines, "camera.fov", &values->camera.fov_deg, 1);
    print_numbers(lines, "sun.elevation", &values->sun.elevation_deg, 1);
    print_numbers(lines, "sun.azimuth", &values->sun.azimuth_deg, 1);
    print_numbers(lines, "sun.radius", &values->sun.radius_deg, 1);
    print_numbers(lines, "time", &values->time_s, 1);
    print_numbers(lines, "mouse", values->mouse, 4);
    text_print(lines, "hints-off %u\n", values->ignored_hints);
    for (int i = 0; i < scene->file->parameter_count; i++)
        print_numbers(lines, scene->file->parameters[i].name, values->parameters[i], 3);
    for (int i = 0; atmosphere_field(i); i++) {
        const AtmosphereField *field = atmosphere_field(i);
        print_numbers(lines, field->setting, atmosphere_value(&values->atmosphere, field), field->count);
    }
}

bool identity_print(const RenderParams *params, const Renderer *renderer, const char *aov, Text *lines,
                    Error *error) {
    text_print(lines, "version %s\n", MAGICHOUR_VERSION);
    text_print(lines, "size %dx%d\nseed %u\n", renderer->camera.width, renderer->camera.height,
               renderer->seed);
    print_methods(&renderer->plan, lines);
    text_print(lines, "layers %s\n", aov ? aov : "none");
    print_values(params->scene, lines);
    return print_texts(params, renderer, lines, error);
}

/* A line's name and value. */
typedef struct Line {
    const char *name, *value;
    int name_length, value_length;
} Line;

static Line line_at(const char *at) {
    Line line = {.name = at, .name_length = (int)strcspn(at, " \n")};
    line.value = at + line.name_length + (at[line.name_length] == ' ');
    line.value_length = (int)strcspn(line.value, "\n");
    return line;
}

/* The line of that name in a list of lines; its name is "" if there is none. */
static Line line_of(const char *lines, const Line *wanted) {
    for (const char *at = lines; *at; at += strcspn(at, "\n"), at += *at == '\n') {
        Line line = line_at(at);
        if (line.name_length == wanted->name_length &&
            memcmp(line.name, wanted->name, (size_t)line.name_length) == 0)
            return line;
    }
    return (Line){"", "", 0, 0};
}

static bool same_value(const Line *a, const Line *b) {
    return a->name_length == b->name_length && a->value_length == b->value_length &&
           memcmp(a->value, b->value, (size_t)a->value_length) == 0;
}

static void say(const Line *was, const Line *is, Text *difference) {
    if (is->name_length == 5 && memcmp(is->name, "texts", 5) == 0) {
        text_print(difference,
                   "the text of the scene, of what it includes or of the GLSL library has changed");
        return;
    }
    if (!was->name_length) {
        text_print(difference, "%.*s is %.*s, and was not there before", is->name_length, is->name,
                   is->value_length, is->value);
        return;
    }
    text_print(difference, "%.*s was %.*s, and is %.*s now", was->name_length, was->name, was->value_length,
               was->value, is->value_length, is->value);
}

bool identity_same(const char *before, const char *now, Text *difference) {
    int count = 0;
    for (const char *at = now; *at; at += strcspn(at, "\n"), at += *at == '\n') {
        Line is = line_at(at), was = line_of(before, &is);
        if (same_value(&was, &is)) continue;
        if (!count++) say(&was, &is, difference);
    }
    if (count > 1) text_print(difference, " (and %d more)", count - 1);
    if (!count && strlen(before) != strlen(now))
        text_print(difference, "it had settings that are not there now");
    return !count && strlen(before) == strlen(now);
}

bool identity_value(const char *lines, const char *name, Text *value) {
    Line wanted = {.name = name, .name_length = (int)strlen(name)}, line = line_of(lines, &wanted);
    if (!line.name_length) return false;
    text_append(value, line.value, (size_t)line.value_length);
    return true;
}
