#include "cmd/cmd.h"
#include "cmd/setup.h"
#include "render/renderer.h"

#include <stdio.h>
#include <stdlib.h>

Status cmd_flatten(const Options *options, Error *error) {
    char *library = NULL;
    Scene scene = {0};
    GlslSource source = {0};
    bool ok = setup_library(options, &library, error) && setup_scene(options, &scene, error);
    if (ok) {
        RenderParams params = {.scene = &scene,
                               .library = library,
                               .sky = options->sky,
                               .light = options->light,
                               .sequence = options->sequence,
                               .sun_disk = options->sun_disk};
        ok = renderer_flatten(&params, &source, error);
    }
    if (ok) fwrite(source.text.data, 1, source.text.size, stdout);
    glsl_source_destroy(&source);
    scene_destroy(&scene);
    free(library);
    return ok ? STATUS_DONE : error->status;
}
