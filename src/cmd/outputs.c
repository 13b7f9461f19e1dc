#include "cmd/outputs.h"

#include "base/descriptor.h"
#include "base/file.h"
#include "image/format.h"

#include <string.h>

const char *outputs_format(const Options *options, int index) {
    bool told = options->output_count > 1 && image_knows_ending(options->outputs[index]);
    return told ? NULL : options->format;
}

const char *outputs_name(const char *path) {
    return strcmp(path, "-") == 0 ? "standard output" : path;
}

/* Standard output takes one picture, and then nothing else. */
static bool reserve_output(const Options *options, Error *error) {
    int count = 0;
    for (int i = 0; i < options->output_count; i++) count += descriptor_is_output(options->outputs[i]);
    if (count > 1)
        return error_set(error, STATUS_USAGE, "-o: standard output is named %d times, but takes one picture",
                         count);
    return !count || descriptor_reserve_output(error);
}

bool outputs_check(const Options *options, Error *error) {
    for (int i = 0; i < options->output_count; i++) {
        if (!image_check_target(options->outputs[i], outputs_format(options, i), error)) return false;
    }
    return reserve_output(options, error);
}

bool outputs_write(const Options *options, const Image *image, const ImageWriteParams *params, Error *error) {
    ImageWriteParams own = *params;
    bool ok = true;
    for (int i = 0; i < options->output_count; i++) {
        Error failed = {0};
        own.format = outputs_format(options, i);
        if (image_write(image, options->outputs[i], &own, &failed)) continue;
        if (ok) *error = failed;
        ok = false;
    }
    return ok;
}

bool outputs_check_text(const Options *options, Error *error) {
    for (int i = 0; i < options->output_count; i++) {
        if (!file_check_target(options->outputs[i], error)) return false;
    }
    return reserve_output(options, error);
}
