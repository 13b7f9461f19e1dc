#include "cmd/cmd.h"
#include "cmd/outputs.h"
#include "cmd/render_write.h"
#include "error/merge.h"
#include "image/format.h"
#include "image/sun_pixels.h"
#include "render/describe.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Metadata of the parts that the whole has otherwise, or not at all. */
static const char *const replaced[] = {
    "magichour.command",     "magichour.samples",  "magichour.samples_range",
    "magichour.light_paths", "magichour.chance_",  "magichour.error_",
    "magichour.noise_",      "magichour.promised", "magichour.sun_pixels",
    "magichour.rejected",    "magichour.searches", "magichour.seconds",
    "magichour.gl_renderer", "magichour.part",     NULL};

static bool is_replaced(const char *name) {
    for (int i = 0; replaced[i]; i++)
        if (strncmp(name, replaced[i], strlen(replaced[i])) == 0) return true;
    return strncmp(name, "magichour.", 10) != 0;
}

/* The number that a part's metadata have, or `missing`. */
static double number_of(const Part *part, const char *name, double missing) {
    const char *text = part_attribute(part, name);
    return text ? strtod(text, NULL) : missing;
}

static double sum_of(const Merge *merge, const char *name) {
    double sum = 0;
    for (int i = 0; i < merge->count; i++) sum += number_of(&merge->parts[i], name, 0);
    return sum;
}

/* The noise and the sky's bias together. */
static double error_of(const Merge *merge) {
    double bias = number_of(&merge->parts[0], "magichour.sky_bias_percent", NAN);
    return hypot(merge->noise_percent, isnan(bias) ? 0 : bias);
}

static void describe_drivers(const Merge *merge, AttributeList *list) {
    Text drivers = {0};
    for (int i = 0; i < merge->count; i++) {
        const char *driver = part_attribute(&merge->parts[i], "magichour.gl_renderer");
        if (driver && !strstr(text_string(&drivers), driver))
            text_print(&drivers, "%s%s", drivers.size ? "; " : "", driver);
    }
    attribute_add(list, "magichour.gl_renderer", "%s", text_string(&drivers));
    text_free(&drivers);
}

static double samples_of(const Merge *merge) {
    double pixels = (double)merge->width * merge->height - (double)merge->missing;
    return (double)(merge->samples.accepted + merge->samples.rejected) / fmax(pixels, 1);
}

static void describe(const Merge *merge, const Options *options, int argc, char **argv, AttributeList *list) {
    const AttributeList *first = &merge->parts[0].attributes;
    Text command = {0};
    text_print_command(&command, argc, argv);
    for (int i = 0; i < first->count; i++)
        if (!is_replaced(first->items[i].name))
            attribute_add(list, first->items[i].name, "%s", first->items[i].value);
    attribute_add(list, "magichour.command", "%s", text_string(&command));
    attribute_add(list, "magichour.parts", "%d", merge->count);
    attribute_add(list, "magichour.samples", "%.6g", samples_of(merge));
    attribute_add(list, "magichour.samples_range", "%" PRIu64 " to %" PRIu64, merge->least, merge->most);
    if (merge->whole.light_paths > 0)
        attribute_add(list, "magichour.light_paths", "%.0f", merge->whole.light_paths);
    describe_chance(&merge->chance, list);
    if (merge->noise_percent < INFINITY) {
        attribute_add(list, "magichour.error_percent", "%.4g", error_of(merge));
        attribute_add(list, "magichour.noise_percent", "%.4g", merge->noise_percent);
    }
    sun_pixels_describe(merge->sun, merge->width, merge->height, list);
    attribute_add(list, "magichour.rejected", "%" PRIu64, merge->samples.rejected);
    describe_search(&merge->whole.search, list);
    attribute_add(list, "magichour.seconds", "%.6f", sum_of(merge, "magichour.seconds"));
    describe_drivers(merge, list);
    if (!options->final) part_describe(&merge->whole, list);
    text_free(&command);
}

static bool write_outputs(const Merge *merge, const Options *options, int argc, char **argv, Error *error) {
    AttributeList attributes = {0};
    double exposure = number_of(&merge->parts[0], "magichour.exposure", 0);
    describe(merge, options, argc, argv, &attributes);
    ImageWriteParams params = {.exposure_ev = options->has_exposure ? options->exposure_ev : exposure,
                               .tone = render_tone(options),
                               .attributes = &attributes};
    bool ok = outputs_write(options, &merge->image, &params, error);
    attribute_list_free(&attributes);
    return ok;
}

static void say(const Merge *merge, const Options *options) {
    for (int i = 0; i < options->output_count; i++)
        printf("%s%s", i ? ", " : "", outputs_name(options->outputs[i]));
    printf(": %d parts, %.4g samples", merge->count, samples_of(merge));
    if (merge->most > merge->least) printf(" (%" PRIu64 " to %" PRIu64 ")", merge->least, merge->most);
    if (merge->noise_percent < INFINITY)
        printf("; estimated error %.3g %%: noise %.3g %%", error_of(merge), merge->noise_percent);
    printf("\n");
}

static void warn(const Merge *merge) {
    const char *driver = part_attribute(&merge->parts[0], "magichour.gl_renderer");
    if (merge->image.data.width == 0
            ? merge->missing > 0
            : merge->missing > (uint64_t)merge->width * (uint64_t)merge->height -
                                   (uint64_t)merge->image.data.width * (uint64_t)merge->image.data.height)
        fprintf(stderr, "magichour: warning: %.3g %% of the pixels are in no part: they are black\n",
                100 * (double)merge->missing / ((double)merge->width * merge->height));
    for (int i = 1; driver && i < merge->count; i++) {
        const char *other = part_attribute(&merge->parts[i], "magichour.gl_renderer");
        if (!other || strcmp(driver, other) == 0) continue;
        fprintf(stderr,
                "magichour: warning: the parts were drawn by different drivers (%s, %s): the sum is not the "
                "same to the bit as by either alone\n",
                driver, other);
        break;
    }
}

Status cmd_merge(const Options *options, int argc, char **argv, Error *error) {
    Merge merge = {0};
    error->status = STATUS_DONE;
    bool ok =
        options->output_count || error_set(error, STATUS_USAGE, "where to? (-o FILE.exr, .png or .pfm)");
    ok = ok && outputs_check(options, error) &&
         merge_files(&merge, options->inputs, options->input_count, !options->final, error) &&
         write_outputs(&merge, options, argc, argv, error);
    if (ok && !options->quiet) say(&merge, options);
    if (ok) warn(&merge);
    merge_free(&merge);
    return ok ? STATUS_DONE : error->status;
}
