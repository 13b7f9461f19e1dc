#include "base/file.h"
#include "base/number.h"
#include "cmd/cmd.h"
#include "cmd/options_parse.h"
#include "scene/moment.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { USUAL_FRAMES = 100 };

/* Where the sun stands in the first and in the last frame: elevations and azimuths, or moments. */
typedef struct Sweep {
    const Options *options;
    char **argv;
    int frames;
    bool has_azimuth;
    double from[2], to[2];
    Moment first, last;
} Sweep;

/* Cuts "FROM..TO" in two words of `size` bytes each. */
static bool cut_range(const char *name, const char *text, char *from, char *to, size_t size, Error *error) {
    const char *dots = strstr(text, "..");
    if (!dots || dots == text || !dots[2] || strlen(text) >= size)
        return error_set(error, STATUS_USAGE, "%s: '%s' is not FROM..TO", name, text);
    snprintf(from, size, "%.*s", (int)(dots - text), text);
    snprintf(to, size, "%s", dots + 2);
    return true;
}

/* Reads "EL" or "EL,AZ". */
static bool parse_place(const char *text, double place[2], bool *has_azimuth, Error *error) {
    char elevation[128];
    const char *comma = strchr(text, ',');
    snprintf(elevation, sizeof elevation, "%.*s", comma ? (int)(comma - text) : (int)strlen(text), text);
    *has_azimuth = comma != NULL;
    return number_parse_range("--sun", elevation, -90, 90, &place[0], error) &&
           (!comma || number_parse_range("--sun", comma + 1, -360, 360, &place[1], error));
}

static bool parse_sun(Sweep *sweep, Error *error) {
    char from[128], to[128];
    bool ends = false;
    if (!cut_range("--sun", sweep->options->sun_range, from, to, sizeof from, error) ||
        !parse_place(from, sweep->from, &sweep->has_azimuth, error) ||
        !parse_place(to, sweep->to, &ends, error))
        return false;
    return ends == sweep->has_azimuth ||
           error_set(error, STATUS_USAGE, "--sun: '%s' has an azimuth at one end alone",
                     sweep->options->sun_range);
}

static bool parse_when(Sweep *sweep, Error *error) {
    char from[128], to[128];
    const Options *options = sweep->options;
    if (!options->when || !options->where)
        return error_set(error, STATUS_USAGE, "--when and --where say together where the sun stands");
    return cut_range("--when", options->when, from, to, sizeof from, error) &&
           moment_parse("--when", from, &sweep->first, error) &&
           moment_parse("--when", to, &sweep->last, error);
}

static double between(double from, double to, double share) {
    return from + (to - from) * share;
}

/* Whole seconds, which is what the words of a moment have. */
static void print_moment(const Sweep *sweep, double share, Text *out) {
    Moment moment = {round(between(sweep->first.utc_s, sweep->last.utc_s, share)), sweep->first.zone_s};
    double seconds = fmod(fmod(moment.utc_s + moment.zone_s, 60) + 60, 60);
    moment_print_date(&moment, out);
    text_print(out, "T");
    moment_print_time(&moment, out);
    text_print(out, ":%02.0f", seconds);
    moment_print_zone(&moment, out);
}

static void print_sun(const Sweep *sweep, int frame, Text *line) {
    double share = sweep->frames > 1 ? (double)frame / (sweep->frames - 1) : 0;
    if (!sweep->options->sun_range) {
        text_print(line, " --when ");
        print_moment(sweep, share, line);
        text_print(line, " --where ");
        text_print_quoted(line, sweep->options->where);
        return;
    }
    text_print(line, " --sun %.9g", between(sweep->from[0], sweep->to[0], share));
    if (sweep->has_azimuth) text_print(line, ",%.9g", between(sweep->from[1], sweep->to[1], share));
}

/* The render of a frame, as one line. */
static void print_job(const Sweep *sweep, int frame, Text *line) {
    const Options *options = sweep->options;
    Text path = {0};
    text_print_quoted(line, sweep->argv[0]);
    text_print(line, " render");
    for (int i = 0; i < options->input_count; i++) {
        text_print(line, " ");
        text_print_quoted(line, options->inputs[i]);
    }
    print_sun(sweep, frame, line);
    for (int i = 0; i < 2; i++) {
        path.size = 0;
        text_print(&path, "%s/frame-%05d.%s", options->outputs[0], frame + 1, i ? "png" : "exr");
        text_print(line, " -o ");
        text_print_quoted(line, text_string(&path));
    }
    text_free(&path);
    text_print(line, "\n");
}

/* Whether `render` takes the words behind the "--", without the sun and the files, which are the sweep's. */
static bool check_rest(const Sweep *sweep, Error *error) {
    const Options *given = sweep->options;
    char *words[MOST_INPUTS + 2] = {sweep->argv[0], "render"};
    Options parsed;
    for (int i = 0; i < given->input_count; i++) words[i + 2] = (char *)given->inputs[i];
    if (!options_parse(&parsed, given->input_count + 2, words, error)) return false;
    if (parsed.has_sun || parsed.when || parsed.where)
        return error_set(error, STATUS_USAGE,
                         "behind --: the sun is the sweep's (--sun or --when in front of it)");
    if (parsed.output_count)
        return error_set(error, STATUS_USAGE, "behind --: the files are the sweep's (-o DIR in front of it)");
    return true;
}

static bool prepare(Sweep *sweep, Error *error) {
    const Options *options = sweep->options;
    sweep->frames = options->frames ? options->frames : USUAL_FRAMES;
    if (options->output_count != 1) return error_set(error, STATUS_USAGE, "where to? (-o DIR, once)");
    if (!options->sun_range == !(options->when || options->where))
        return error_set(error, STATUS_USAGE,
                         "where does the sun stand? (--sun FROM..TO, or --when FROM..TO with --where)");
    if (!(options->sun_range ? parse_sun(sweep, error) : parse_when(sweep, error)) ||
        !check_rest(sweep, error))
        return false;
    if (mkdir(options->outputs[0], 0777) == 0 || errno == EEXIST) return true;
    return error_set(error, STATUS_OUTPUT, "%s: cannot be made: %s", options->outputs[0], strerror(errno));
}

static void say(const Sweep *sweep, const char *path) {
    const Options *options = sweep->options;
    Text frames = {0}, film = {0};
    text_print(&frames, "%s/frame-%%05d.png", options->outputs[0]);
    text_print(&film, "%s/film.mp4", options->outputs[0]);
    printf("%s: %d renders, a line each: `sh %s` does them one after the other, tools/cluster/ with all "
           "processors or "
           "machines\nthe film, when they are done: ffmpeg -framerate %g -i ",
           path, sweep->frames, path, options->frame_rate > 0 ? options->frame_rate : 25);
    Text words = {0};
    text_print_quoted(&words, text_string(&frames));
    text_print(&words, " -pix_fmt yuv420p ");
    text_print_quoted(&words, text_string(&film));
    printf("%s\n", text_string(&words));
    text_free(&words);
    text_free(&frames);
    text_free(&film);
}

Status cmd_sweep(const Options *options, char **argv, Error *error) {
    Sweep sweep = {.options = options, .argv = argv};
    Text jobs = {0}, path = {0};
    error->status = STATUS_DONE;
    bool ok = prepare(&sweep, error);
    for (int i = 0; ok && i < sweep.frames; i++) print_job(&sweep, i, &jobs);
    if (ok) text_print(&path, "%s/jobs", options->outputs[0]);
    ok = ok && file_replace(text_string(&path), jobs.data, jobs.size, error);
    if (ok && !options->quiet) say(&sweep, text_string(&path));
    text_free(&jobs);
    text_free(&path);
    return ok ? STATUS_DONE : error->status;
}
