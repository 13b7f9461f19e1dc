#include "choice/method.h"
#include "cmd/cmd.h"
#include "cmd/interrupt.h"
#include "cmd/scene_find.h"
#include "cmd/setup.h"
#include "cmd/toy_options.h"
#include "view/log.h"
#include "view/view.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { RECORDED_SAMPLES = 64 };

typedef struct Source {
    const Options *options;
    char *library;
    /* The scene's file. */
    char *path;
} Source;

static bool load(const void *data, Scene *scene, Error *error) {
    const Source *source = data;
    if (!setup_scene(source->options, source->library, scene, error)) return false;
    if (!scene->file->facts.is_toy || toy_options_check(source->options, scene->file, error)) return true;
    scene_destroy(scene);
    return false;
}

static void copy_name(char *target, size_t size, const char *name) {
    snprintf(target, size, "%s", method_is_auto(name) ? "" : name);
}

static MethodNames method_names(const Options *options) {
    MethodNames names = {.sky = ""};
    copy_name(names.sky, sizeof names.sky, options->sky);
    copy_name(names.light, sizeof names.light, options->light);
    copy_name(names.further, sizeof names.further, options->further);
    copy_name(names.sequence, sizeof names.sequence, options->sequence);
    copy_name(names.sun_disk, sizeof names.sun_disk, options->sun_disk);
    /* An empty name would leave the disk as the scene has it. */
    if (options->sun_disk && !names.sun_disk[0]) snprintf(names.sun_disk, sizeof names.sun_disk, "auto");
    return names;
}

static bool sets_exposure(const Options *options) {
    bool set = options->has_exposure;
    for (int i = 0; i < options->setting_count; i++)
        set |= strncmp(options->settings[i], "exposure=", strlen("exposure=")) == 0;
    return set;
}

static bool check_folder(const char *folder, Error *error) {
    struct stat status;
    if (!folder || mkdir(folder, 0777) == 0) return true;
    int failed = errno;
    if (failed == EEXIST && stat(folder, &status) == 0 && S_ISDIR(status.st_mode)) return true;
    return error_set(error, STATUS_OUTPUT, "--record %s: no folder can be made there: %s", folder,
                     strerror(failed));
}

Status cmd_view(const Options *options, Error *error) {
    Source source = {.options = options};
    error->status = STATUS_DONE;
    interrupt_install();
    interrupt_keep();
    log_enable(options->progress && strcmp(options->progress, "json") == 0);
    bool ok = setup_library(options, &source.library, error) && check_folder(options->record, error) &&
              scene_find(options->inputs[0], source.library, &source.path, error);
    if (ok) {
        ViewParams params = {.load = load,
                             .data = &source,
                             .path = source.path,
                             .library = source.library,
                             .glsl_dir = options->glsl_dir,
                             .methods = method_names(options),
                             .preset = options->preset,
                             .exposure_set = sets_exposure(options),
                             .width = options->width,
                             .height = options->height,
                             .seed = options->seed,
                             .max_hits = options->depth,
                             .samples = options->samples  ? options->samples
                                        : options->record ? RECORDED_SAMPLES
                                                          : 0,
                             .record = options->record,
                             .frames = options->frames,
                             .frame_rate = options->frame_rate,
                             .stop = interrupt_requested,
                             .leave = interrupt_leave};
        ok = view_run(&params, error);
    }
    free(source.library);
    free(source.path);
    if (!ok) return error->status;
    return interrupt_requested() ? STATUS_INTERRUPTED : STATUS_DONE;
}
