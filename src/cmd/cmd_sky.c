#include "base/file.h"
#include "base/memory.h"
#include "base/vec3.h"
#include "base/version.h"
#include "choice/auto.h"
#include "cmd/cmd.h"
#include "cmd/setup.h"
#include "cmd/sky_rows.h"
#include "image/format.h"
#include "render/describe.h"
#include "sky/sky_probe.h"
#include "sky/sky_truth.h"
#include "sky/sun.h"
#include "sky/sun_disk.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Samples on each side of a pixel that the disk may touch. */
enum { DISK_SAMPLES = 16 };

/* The target error for auto. It allows a third of it as bias, and a map has no other error. */
static const double map_error_percent = 0.3;

typedef struct Job {
    const Options *options;
    char *library;
    SourceStore *sources;
    /* Only the sky's settings are used. */
    Scene scene;
    Context context;
    SkyProbe probe;
    /* The method's full name. */
    const char *method;
} Job;

static SkyState state_of(const Scene *scene) {
    return (SkyState){scene->values.atmosphere, scene->values.sun};
}

static void unit_vector(double elevation_deg, double azimuth_deg, double out[3]) {
    double level = cos(elevation_deg * degree);
    out[0] = level * sin(azimuth_deg * degree);
    out[1] = sin(elevation_deg * degree);
    out[2] = level * cos(azimuth_deg * degree);
}

static bool open_probe(Job *job, double directions, Error *error) {
    const Atmosphere *a = &job->scene.values.atmosphere;
    AutoWish wish = {.error_percent = map_error_percent,
                     .samples = 1,
                     .pixels = directions,
                     .sun_elevation_deg = job->scene.values.sun.elevation_deg,
                     .atmosphere = a};
    MethodChoice choice;
    if (!setup_library(job->options, &job->library, error)) return false;
    job->sources = source_store_create(job->library);
    return auto_sky(&choice, job->options->sky, &wish, error) &&
           context_open(&job->context, job->options->backend, error) &&
           sky_probe_create(&job->probe, &job->context, job->sources, &choice, a, error);
}

/* Maps. Row 0 is +y, the middle column is +z, and +x is a quarter of the width from the left: the lat-long
 * layout of OpenEXR and Mitsuba. */
static void map_direction(double x, double y, int width, int height, double out[3]) {
    unit_vector(90 - 180 * y / height, 180 - 360 * x / width, out);
}

static void add_disk(const Job *job, Image *image) {
    const Scene *scene = &job->scene;
    double radius = scene->values.sun.radius_deg + 180.0 / image->height + 360.0 / image->width;
    SunDisk disk = sun_disk(&scene->values.atmosphere, &scene->values.sun);
    const double *sun = disk.middle;
    for (int i = 0; i < image->width * image->height; i++) {
        double middle[3];
        map_direction(i % image->width + 0.5, i / image->width + 0.5, image->width, image->height, middle);
        if (sun[0] * middle[0] + sun[1] * middle[1] + sun[2] * middle[2] < cos(fmin(radius, 180) * degree))
            continue;
        for (int s = 0; s < DISK_SAMPLES * DISK_SAMPLES; s++) {
            double direction[3], radiance[3];
            map_direction(i % image->width + (s % DISK_SAMPLES + 0.5) / DISK_SAMPLES,
                          i / image->width + (s / DISK_SAMPLES + 0.5) / DISK_SAMPLES, image->width,
                          image->height, direction);
            sun_disk_radiance(&disk, &scene->values.atmosphere, direction, radiance);
            for (int c = 0; c < 3; c++)
                image->rgba[4 * i + c] += (float)(radiance[c] / (DISK_SAMPLES * DISK_SAMPLES));
        }
    }
}

static bool write_map(const Job *job, const Image *image, int argc, char **argv, Error *error) {
    AttributeList list = {0};
    Text command = {0};
    text_print_command(&command, argc, argv);
    attribute_add(&list, "magichour.version", "%s", MAGICHOUR_VERSION);
    attribute_add(&list, "magichour.command", "%s", text_string(&command));
    attribute_add(
        &list, "magichour.orientation",
        "lat-long, y up: row 0 is +y, the centre column +z, a quarter from the left +x, the edges -z");
    attribute_add(&list, "magichour.sky", "%s", job->method);
    attribute_add(&list, "magichour.sun", "elevation %.9g azimuth %.9g (from +z toward +x)",
                  job->scene.values.sun.elevation_deg, job->scene.values.sun.azimuth_deg);
    describe_atmosphere(&job->scene.values.atmosphere, &list);
    bool none = job->options->tone && strcmp(job->options->tone, "none") == 0;
    ImageWriteParams params = {.exposure_ev = job->scene.values.exposure_ev,
                               .tone = none ? TONE_NONE : TONE_AUTHOR,
                               .latlong = true,
                               .attributes = &list};
    bool ok = true;
    for (int i = 0; ok && i < job->options->output_count; i++) {
        ok = image_write(image, job->options->outputs[i], &params, error);
    }
    attribute_list_free(&list);
    text_free(&command);
    return ok;
}

static bool make_map(Job *job, int argc, char **argv, Error *error) {
    const Options *options = job->options;
    int width = options->width ? options->width : 1024,
        height = options->height ? options->height : width / 2;
    if (!scene_check_size(width, height, error)) return false;
    for (int i = 0; i < options->output_count; i++) {
        if (!image_check_path(options->outputs[i], error) || !file_check_target(options->outputs[i], error))
            return false;
    }
    MethodChoice disk;
    if (!sun_choose(&disk, options->sun_disk, &job->scene, error) ||
        !open_probe(job, (double)width * height, error)) {
        return false;
    }
    job->method = job->probe.choice.text;
    Image image = image_create(width, height);
    for (int i = 0; i < width * height; i++) {
        double direction[3];
        map_direction(i % width + 0.5, i / width + 0.5, width, height, direction);
        for (int c = 0; c < 3; c++) image.rgba[4 * i + c] = (float)direction[c];
    }
    SkyState state = state_of(&job->scene);
    bool ok =
        sky_probe_ask(&job->probe, &state, image.rgba, (size_t)width * (size_t)height, image.rgba, error);
    if (ok && disk.method->has_disk) add_disk(job, &image);
    ok = ok && write_map(job, &image, argc, argv, error);
    image_free(&image);
    return ok;
}

/* Rows of `sky --at`. */

static int compare_rows(const void *left, const void *right) {
    const SkyRow *a = *(SkyRow *const *)left, *b = *(SkyRow *const *)right;
    if (a->height_m != b->height_m) return a->height_m < b->height_m ? -1 : 1;
    if (a->sun_el_deg != b->sun_el_deg) return a->sun_el_deg < b->sun_el_deg ? -1 : 1;
    return 0;
}

static void ask_reference(const Job *job, SkyRow *row) {
    double view[3], sun[3];
    unit_vector(row->view_el_deg, row->az_deg, view);
    unit_vector(row->sun_el_deg, 0, sun);
    sky_truth(&job->scene.values.atmosphere, row->height_m, view, sun, row->radiance);
}

/* Looks up rows that share an observer and a sun. */
static bool ask_group(Job *job, SkyRow **rows, size_t count, Error *error) {
    SkyState state = {job->scene.values.atmosphere,
                      sun_at(rows[0]->sun_el_deg, 0, job->scene.values.sun.radius_deg)};
    float *values = memory_get(4 * count, sizeof *values);
    state.atmosphere.observer_height_m = rows[0]->height_m;
    for (size_t i = 0; i < count; i++) {
        double view[3];
        unit_vector(rows[i]->view_el_deg, rows[i]->az_deg, view);
        for (int c = 0; c < 3; c++) values[4 * i + (size_t)c] = (float)view[c];
    }
    bool ok = sky_probe_ask(&job->probe, &state, values, count, values, error);
    for (size_t i = 0; ok && i < count; i++) {
        for (int c = 0; c < 3; c++) rows[i]->radiance[c] = (double)values[4 * i + (size_t)c];
    }
    free(values);
    return ok;
}

static bool ask_rows(Job *job, SkyRows *rows, Error *error) {
    if (method_is_reference(job->options->sky)) {
        for (size_t i = 0; i < rows->count; i++) ask_reference(job, &rows->rows[i]);
        return true;
    }
    /* Few of these directions share a sun, so no table is made unless the user chose one. */
    if (!open_probe(job, 1, error)) return false;
    SkyRow **order = memory_get(rows->count, sizeof *order);
    for (size_t i = 0; i < rows->count; i++) order[i] = &rows->rows[i];
    qsort(order, rows->count, sizeof *order, compare_rows);
    bool ok = true;
    for (size_t begin = 0, end; ok && begin < rows->count; begin = end) {
        for (end = begin + 1; end < rows->count && compare_rows(&order[begin], &order[end]) == 0;) end++;
        ok = ask_group(job, order + begin, end - begin, error);
    }
    free(order);
    return ok;
}

static bool answer_rows(Job *job, Error *error) {
    const Options *options = job->options;
    const char *target = options->output_count ? options->outputs[0] : NULL;
    SkyRows rows;
    Text out = {0};
    if (options->output_count > 1) return error_set(error, STATUS_USAGE, "--at writes one file");
    if (target && !file_check_target(target, error)) return false;
    if (!sky_rows_read(&rows, options->at, error)) return false;
    bool ok = ask_rows(job, &rows, error);
    if (ok) sky_rows_print(&rows, &out);
    if (ok && target) ok = file_replace(target, out.data, out.size, error);
    if (ok && !target && fwrite(out.data, 1, out.size, stdout) != out.size) {
        ok = error_set(error, STATUS_OUTPUT, "standard output: cannot be written");
    }
    text_free(&out);
    sky_rows_free(&rows);
    return ok;
}

Status cmd_sky(const Options *options, int argc, char **argv, Error *error) {
    Job job = {.options = options};
    bool ok;
    if (!options->at && !options->output_count) {
        error_set(error, STATUS_USAGE, "where to? (-o FILE.exr for a map, or --at FILE.csv)");
        return error->status;
    }
    if (!options->at && method_is_reference(options->sky)) {
        error_set(error, STATUS_USAGE, "--sky reference is for --at alone");
        return error->status;
    }
    ok = setup_scene(options, NULL, &job.scene, error) &&
         (options->at ? answer_rows(&job, error) : make_map(&job, argc, argv, error));
    if (ok && !options->at && !options->quiet) {
        printf("%s: the sky by %s, sun at %g\n", options->outputs[0], job.method,
               job.scene.values.sun.elevation_deg);
    }
    sky_probe_destroy(&job.probe);
    context_close(&job.context);
    scene_destroy(&job.scene);
    source_store_release(job.sources);
    free(job.library);
    return ok ? STATUS_DONE : error->status;
}
