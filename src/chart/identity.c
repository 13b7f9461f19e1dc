#include "chart/identity.h"

#include "base/archive.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static void print_values(const char *name, const double *values, int count, Text *out) {
    text_print(out, "%s", name);
    for (int i = 0; i < count; i++) text_print(out, " %.9g", values[i]);
    text_print(out, "\n");
}

void identity_of_picture(const RenderParams *params, Text *out) {
    const Scene *scene = params->scene;
    Text rest = {0};
    print_values("eye", scene->values.camera.eye, 3, &rest);
    print_values("target", scene->values.camera.target, 3, &rest);
    print_values("fov", &scene->values.camera.fov_deg, 1, &rest);
    print_values("radius", &scene->values.sun.radius_deg, 1, &rest);
    for (int i = 0; i < scene->file->parameter_count; i++)
        print_values(scene->file->parameters[i].name, scene->values.parameters[i], 3, &rest);
    for (int i = 0; atmosphere_field(i); i++) {
        const AtmosphereField *field = atmosphere_field(i);
        print_values(field->name, atmosphere_value(&scene->values.atmosphere, field), field->count, &rest);
    }
    text_print(out, "# scene %s\n# sun %.9g,%.9g disk %s\n", scene->file->path,
               scene->values.sun.elevation_deg, scene->values.sun.azimuth_deg,
               params->sun_disk         ? params->sun_disk
               : scene->values.sun_disk ? "on"
                                        : "off");
    text_print(out, "# size %dx%d, depth %d\n# settings %016" PRIx64 "\n",
               params->width ? params->width : scene->file->width,
               params->height ? params->height : scene->file->height, params->max_hits,
               hash_bytes(0, rest.data, rest.size));
    text_free(&rest);
}

/* Prints the processor's name, if Linux tells it. */
static void print_processor(Text *out) {
    char line[256];
    FILE *file = fopen("/proc/cpuinfo", "r");
    while (file && fgets(line, sizeof line, file)) {
        char *colon = strchr(line, ':');
        if (strncmp(line, "model name", 10) != 0 || !colon) continue;
        text_print(out, ", %.*s", (int)strcspn(colon + 2, "\n"), colon + 2);
        break;
    }
    if (file) fclose(file);
}

void identity_of_machine(const Context *context, Text *out) {
    text_print(out, "# machine %s, %s", context->renderer, context->version);
    print_processor(out);
    text_print(out, ", %ld processors\n", sysconf(_SC_NPROCESSORS_ONLN));
}

bool identity_add_shader(const RenderParams *params, uint64_t *hash, Error *error) {
    GlslSource source;
    if (!pass_trace_text(params, &source, error)) return false;
    *hash = hash_bytes(*hash, source.text.data, source.text.size);
    glsl_source_destroy(&source);
    return true;
}
