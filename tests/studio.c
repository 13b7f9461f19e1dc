#include "studio.h"

#include "support.h"

#include "cmd/options_parse.h"
#include "cmd/setup.h"

#include <stdio.h>
#include <string.h>

enum { MOST_WORDS = 64 };

static void parse(Studio *studio, const char *scene, const char *arguments) {
    char *words[MOST_WORDS] = {(char[]){"magichour"}, (char[]){"render"}, studio->scene_path};
    int count = 3;
    Error error;
    snprintf(studio->scene_path, sizeof studio->scene_path, "%s", scene);
    snprintf(studio->words, sizeof studio->words, "%s", arguments);
    for (char *word = strtok(studio->words, " "); word && count < MOST_WORDS; word = strtok(NULL, " "))
        words[count++] = word;
    if (!options_parse(&studio->options, count, words, &error)) fail_msg("%s: %s", arguments, error.text);
}

void studio_open(Studio *studio, const char *scene, const char *arguments) {
    Error error;
    memset(studio, 0, sizeof *studio);
    support_open(&studio->context);
    parse(studio, scene, arguments);
    const Options *options = &studio->options;
    const char *library = options->glsl_dir ? options->glsl_dir : "glsl";
    if (!setup_scene(options, library, &studio->scene, &error)) fail_msg("%s", error.text);
    studio->options.samples = support_samples(options->samples);
    studio->params = (RenderParams){.scene = &studio->scene,
                                    .sky = options->sky,
                                    .light = options->light,
                                    .sequence = options->sequence,
                                    .sun_disk = options->sun_disk,
                                    .width = options->width,
                                    .height = options->height,
                                    .seed = options->seed,
                                    .max_hits = options->depth,
                                    .samples = options->samples,
                                    .error_percent = options->error.amount};
    if (!renderer_create(&studio->renderer, &studio->context, &studio->params, &error))
        fail_msg("%s %s: %s", scene, arguments, error.text);
}

void studio_close(Studio *studio) {
    renderer_destroy(&studio->renderer);
    scene_destroy(&studio->scene);
    context_close(&studio->context);
}

Image studio_picture(Studio *studio, unsigned seed) {
    Renderer *renderer = &studio->renderer;
    Image image;
    FilmCount count;
    Error error;
    studio->params.seed = seed;
    if (!renderer_restart(renderer, &studio->context, &studio->params, &error)) fail_msg("%s", error.text);
    while (renderer->film.samples < studio->options.samples) {
        if (!renderer_pass(renderer, studio->options.samples - renderer->film.samples, NULL, &error))
            fail_msg("%s", error.text);
    }
    if (!film_read(&renderer->film, &image, &count, &error)) fail_msg("%s", error.text);
    return image;
}
