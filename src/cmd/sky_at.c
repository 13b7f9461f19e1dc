#include "cmd/sky_at.h"

#include "base/file.h"
#include "base/memory.h"
#include "cmd/interrupt.h"
#include "cmd/outputs.h"
#include "cmd/sky_rows.h"
#include "cmd/wavelengths.h"
#include "scene/spectrum.h"
#include "scene/spectrum_data.h"
#include "sky/sky_truth.h"
#include "sky/sun.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Three columns at a time: the air that they are computed with, and the first of them. */
typedef struct Columns {
    Atmosphere air;
    int first;
} Columns;

/* By the sun first: some of the sky's tables are the same for all heights. */
static int compare_rows(const void *left, const void *right) {
    const SkyRow *a = *(SkyRow *const *)left, *b = *(SkyRow *const *)right;
    if (a->sun_el_deg != b->sun_el_deg) return a->sun_el_deg < b->sun_el_deg ? -1 : 1;
    if (a->height_m != b->height_m) return a->height_m < b->height_m ? -1 : 1;
    return 0;
}

/* The part of all columns that some of them are, for the gauge. */
typedef struct Share {
    SkyJob *job;
    double from, to;
} Share;

static Share share_of(SkyJob *job, const Columns *columns, const SkyRows *rows) {
    double all = rows->columns;
    return (Share){job, columns->first / all, fmin((columns->first + 3) / all, 1)};
}

static void report(const Share *share, double done, const char *words) {
    gauge_report(&share->job->gauge, share->from + done * (share->to - share->from), words);
}

/* The solution is nine tenths of the work. */
static bool watch_reference(void *state, double share) {
    report(state, 0.9 * share, "all orders of scattering in double precision");
    return !interrupt_requested();
}

/* From the first row with all its columns on, there is something to save. */
static void keep(const SkyRows *rows, const SkyRow *row) {
    if (row->done >= rows->columns) interrupt_keep();
}

static void ask_reference(SkyJob *job, const Columns *columns, const SkyRows *rows) {
    Share share = share_of(job, columns, rows);
    SkyWatch watch = {watch_reference, &share};
    SkyTruth *truth = sky_truth_create(&columns->air, &watch);
    for (size_t i = 0; truth && i < rows->count && !interrupt_requested(); i++) {
        SkyRow *row = &rows->rows[i];
        double view[3], sun[3];
        sky_job_direction(row->view_el_deg, row->az_deg, view);
        sky_job_direction(row->sun_el_deg, 0, sun);
        sky_truth_ask(truth, row->height_m, view, sun, row->values + columns->first);
        row->done += 3;
        keep(rows, row);
        report(&share, 0.9 + 0.1 * (double)i / (double)rows->count, "rows in double precision");
    }
    sky_truth_destroy(truth);
}

/* Looks up rows that share an observer and a sun. */
static bool ask_group(SkyJob *job, const Columns *columns, SkyRow **rows, size_t count, Error *error) {
    SkyState state = {columns->air, sun_at(rows[0]->sun_el_deg, 0, job->scene.values.sun.radius_deg)};
    float *values = memory_get(4 * count, sizeof *values);
    state.atmosphere.observer_height_m = rows[0]->height_m;
    for (size_t i = 0; i < count; i++) {
        double view[3];
        sky_job_direction(rows[i]->view_el_deg, rows[i]->az_deg, view);
        for (int c = 0; c < 3; c++) values[4 * i + (size_t)c] = (float)view[c];
    }
    bool ok = sky_probe_ask(&job->probe, &state, values, count, values, error);
    for (size_t i = 0; ok && i < count; i++) {
        for (int c = 0; c < 3; c++) rows[i]->values[columns->first + c] = (double)values[4 * i + (size_t)c];
        rows[i]->done += 3;
    }
    free(values);
    return ok;
}

static bool ask_columns(SkyJob *job, const Columns *columns, const SkyRows *rows, Error *error) {
    if (method_is_reference(job->options->sky)) {
        ask_reference(job, columns, rows);
        return true;
    }
    SkyRow **order = memory_get(rows->count, sizeof *order);
    for (size_t i = 0; i < rows->count; i++) order[i] = &rows->rows[i];
    qsort(order, rows->count, sizeof *order, compare_rows);
    bool ok = true;
    Share share = share_of(job, columns, rows);
    for (size_t begin = 0, end; ok && begin < rows->count && !interrupt_requested(); begin = end) {
        report(&share, (double)begin / (double)rows->count, "rows");
        for (end = begin + 1; end < rows->count && compare_rows(&order[begin], &order[end]) == 0;) end++;
        ok = ask_group(job, columns, order + begin, end - begin, error);
        keep(rows, order[begin]);
    }
    free(order);
    return ok;
}

/* Few of the directions share a sun, so no table is made unless the user chose one. */
static bool open(SkyJob *job, const Atmosphere *air, Error *error) {
    return method_is_reference(job->options->sky) || sky_job_open(job, air, 1, error);
}

static bool ask_colors(SkyJob *job, SkyRows *rows, Error *error) {
    const Columns columns = {.air = job->scene.values.atmosphere};
    sky_rows_add(rows, "R");
    sky_rows_add(rows, "G");
    sky_rows_add(rows, "B");
    return open(job, &columns.air, error) && ask_columns(job, &columns, rows, error);
}

/* The wavelengths are computed as channels, three at a time, for a sun of irradiance 1. Where they are no
 * multiple of three the last one is repeated. */
static bool ask_wavelengths(SkyJob *job, const Wavelengths *list, SkyRows *rows, Error *error) {
    const Atmosphere *atmosphere = &job->scene.values.atmosphere;
    Atmosphere channels = *atmosphere;
    bool ok;
    for (int i = 0; i < list->count; i++) {
        char name[40];
        snprintf(name, sizeof name, "L_%g", list->nm[i]);
        sky_rows_add(rows, name);
    }
    channels.spectrum = SPECTRUM_RGB;
    ok = open(job, &channels, error);
    for (int first = 0; ok && first < list->count && !interrupt_requested(); first += 3) {
        double nm[3];
        for (int c = 0; c < 3; c++) nm[c] = list->nm[first + c < list->count ? first + c : list->count - 1];
        Columns columns = {spectrum_air_at(atmosphere, nm), first};
        ok = ask_columns(job, &columns, rows, error);
    }
    for (size_t i = 0; ok && i < rows->count; i++) {
        for (int k = 0; k < list->count; k++) rows->rows[i].values[k] *= spectrum_sun_per_nm(list->nm[k]);
    }
    return ok;
}

static bool write_rows(const char *target, const SkyRows *rows, Error *error) {
    Text out = {0};
    sky_rows_print(rows, &out);
    bool ok = file_replace(target, out.data, out.size, error);
    text_free(&out);
    return ok;
}

bool sky_at(SkyJob *job, Error *error) {
    const Options *options = job->options;
    const char *target = options->output_count ? options->outputs[0] : "-";
    Wavelengths list = {0};
    SkyRows rows;
    if (options->output_count > 1) return error_set(error, STATUS_USAGE, "--at writes one file");
    if (!outputs_check_text(options, error)) return false;
    if (options->spectrum &&
        !wavelengths_choose(&list, options->spectrum, &job->scene.values.atmosphere, error))
        return false;
    if (!sky_rows_read(&rows, options->at, error)) return false;
    bool ok = options->spectrum ? ask_wavelengths(job, &list, &rows, error) : ask_colors(job, &rows, error);
    gauge_end(&job->gauge, interrupt_requested());
    /* The rows that are done are worth keeping. */
    ok = interrupt_forgive(ok, error);
    if (ok && interrupt_requested()) {
        fprintf(stderr, "magichour: interrupted: %zu of %zu rows are computed and written\n",
                sky_rows_done(&rows), rows.count);
    }
    ok = ok && write_rows(target, &rows, error);
    sky_rows_free(&rows);
    return ok;
}
