#include "base/budget.h"
#include "base/clock.h"
#include "base/vec3.h"
#include "base/version.h"
#include "cmd/cmd.h"
#include "cmd/interrupt.h"
#include "cmd/outputs.h"
#include "cmd/setup.h"
#include "cmd/sky_at.h"
#include "image/format.h"
#include "render/describe.h"
#include "sky/sun.h"
#include "sky/sun_disk.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Samples on each side of a pixel that the disk may touch. */
enum { DISK_SAMPLES = 16 };
/* The directions that the probe draws at a time. */
enum { DRAWN = 65536 };
/* The map, and its file while it is written. */
enum { BYTES_A_PIXEL = 48 };
static const double piece_seconds = 0.3;

/* Maps. Row 0 is +y, the middle column is +z, and +x is a quarter of the width from the left: the lat-long
 * layout of OpenEXR and Mitsuba. */
static void map_direction(double x, double y, int width, int height, double out[3]) {
    sky_job_direction(90 - 180 * y / height, 180 - 360 * x / width, out);
}

static void add_disk(const SkyJob *job, Image *image) {
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

static bool write_map(const SkyJob *job, const Image *image, int argc, char **argv, Error *error) {
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
    bool ok = outputs_write(job->options, image, &params, error);
    attribute_list_free(&list);
    text_free(&command);
    return ok;
}

/* How many rows to look up next, if these took so long: an interruption waits hardly longer than that. */
static int next_rows(int rows, double seconds, int width) {
    int most = width < DRAWN ? DRAWN / width : 1;
    double wanted = rows * piece_seconds / fmax(seconds, 1e-6);
    return (int)fmin(fmax(fmin(wanted, 4.0 * rows), 1), most);
}

/* Looks up the map's rows from the top. An interruption ends it after those that `done` counts. */
static bool ask_rows(SkyJob *job, Image *image, int *done, Error *error) {
    SkyState state = {job->scene.values.atmosphere, job->scene.values.sun};
    int width = image->width, height = image->height, next = 1;
    bool ok = true;
    while (ok && *done < height && !interrupt_requested()) {
        int rows = height - *done < next ? height - *done : next;
        double start = clock_seconds();
        float *first = image->rgba + 4 * (size_t)*done * (size_t)width;
        gauge_report(&job->gauge, (double)*done / height, "map");
        for (int i = 0; i < width * rows; i++) {
            double direction[3];
            map_direction(i % width + 0.5, *done + i / width + 0.5, width, height, direction);
            for (int c = 0; c < 3; c++) first[4 * i + c] = (float)direction[c];
        }
        ok = sky_probe_ask(&job->probe, &state, first, (size_t)width * (size_t)rows, first, error);
        next = next_rows(rows, clock_seconds() - start, width);
        if (ok) *done += rows;
        if (ok) interrupt_keep();
    }
    return interrupt_forgive(ok, error);
}

/* Writes a map of which only the first rows are there, and says so. */
static bool keep_rows(const SkyJob *job, Image *image, int rows, int argc, char **argv, Error *error) {
    size_t size = 4 * (size_t)image->width;
    for (size_t i = (size_t)rows * size; i < (size_t)image->height * size; i++) image->rgba[i] = i % 4 == 3;
    fprintf(
        stderr,
        "magichour: interrupted: the first %d of the map's %d rows are written, and the others are black\n",
        rows, image->height);
    return write_map(job, image, argc, argv, error);
}

static bool make_map(SkyJob *job, int argc, char **argv, Error *error) {
    const Options *options = job->options;
    int width = options->width ? options->width : 1024,
        height = options->height ? options->height : width / 2;
    size_t bytes = (size_t)width * (size_t)height * BYTES_A_PIXEL;
    if (!scene_check_size(width, height, error) ||
        !budget_take(bytes, SIZE_MAX, STATUS_USAGE, "the map", error) || !outputs_check(options, error))
        return false;
    MethodChoice disk;
    if (!sun_choose(&disk, options->sun_disk, &job->scene, error) ||
        !sky_job_open(job, &job->scene.values.atmosphere, (double)width * height, error)) {
        return false;
    }
    job->method = job->probe.choice.text;
    Image image = image_create(width, height);
    int rows = 0;
    bool ok = ask_rows(job, &image, &rows, error);
    gauge_end(&job->gauge, interrupt_requested());
    if (ok && disk.method->has_disk) add_disk(job, &image);
    if (rows == height) {
        ok = ok && write_map(job, &image, argc, argv, error);
    } else if (ok) {
        ok = keep_rows(job, &image, rows, argc, argv, error);
    }
    image_free(&image);
    return ok;
}

Status cmd_sky(const Options *options, int argc, char **argv, Error *error) {
    SkyJob job = {.options = options, .gauge = gauge_start(options)};
    bool ok;
    error->status = STATUS_DONE;
    interrupt_install();
    if (!options->at && !options->output_count) {
        error_set(error, STATUS_USAGE, "where to? (-o FILE.exr for a map, or --at FILE.csv)");
        return error->status;
    }
    if (options->at && options->format) {
        error_set(error, STATUS_USAGE, "--format is for maps: --at writes CSV");
        return error->status;
    }
    if (!options->at && options->spectrum) {
        error_set(error, STATUS_USAGE, "--spectrum is for --at alone");
        return error->status;
    }
    if (!options->at && method_is_reference(options->sky)) {
        error_set(error, STATUS_USAGE, "--sky reference is for --at alone");
        return error->status;
    }
    ok = setup_scene(options, NULL, &job.scene, error) &&
         (options->at ? sky_at(&job, error) : make_map(&job, argc, argv, error));
    gauge_end(&job.gauge, interrupt_requested());
    if (ok && !options->at && !options->quiet && !interrupt_requested()) {
        printf("%s: the sky by %s, sun at %g\n", outputs_name(options->outputs[0]), job.method,
               job.scene.values.sun.elevation_deg);
    }
    sky_job_close(&job);
    if (!ok) return error->status;
    return interrupt_requested() ? STATUS_INTERRUPTED : STATUS_DONE;
}
