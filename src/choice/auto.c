#include "choice/auto.h"

#include "choice/bias.h"
#include "scene/spectrum.h"

#include <math.h>
#include <stdio.h>

/* relRMSE of a picture of one sample a pixel, percent; after n samples it is this over sqrt(n). Measured in
 * the crater and in the materials, with the default light method and sequence. */
static const double noise_of_one_sample = 10;

double auto_error_percent(const AutoWish *wish) {
    if (wish->error_percent > 0) return wish->error_percent;
    return wish->samples > 0 ? fmin(noise_of_one_sample / sqrt(wish->samples), AUTO_ERROR_PERCENT)
                             : AUTO_ERROR_PERCENT;
}

/* The estimate of a picture's error takes 16 samples a pixel, so that no target is reached with fewer. */
static const double fewest_samples = 16;

/* How many paths the picture is likely to take. */
static double paths_of(const AutoWish *wish) {
    double needed = pow(noise_of_one_sample / auto_error_percent(wish), 2);
    return (wish->samples > 0 ? wish->samples : fmax(needed, fewest_samples)) * wish->pixels;
}

/* Seconds, measured on two cores with llvmpipe. Only their ratios matter. They can be measured again as the
 * time to the first sample and the time of a path of the scene `sky`, with each gauss:n and with tables of
 * each size.
 *
 * A program that contains gauss:n takes first_compile + compile_by_nodes * n^2 longer to compile. One that
 * fills a table is a second program, and takes table_compile besides. */
static const double first_compile = 0.09, compile_by_nodes = 0.0035, table_compile = 0.03;
/* gauss:n takes n times this for each path, or for each texel that it fills. */
static const double node_time = 9e-9;
/* A path's look into a table, and what is added for each square root of a texel: the larger the table is, the
 * less of it the caches hold. */
static const double lookup_time = 7e-9, lookup_by_root = 3e-11;

/* What a sky adds to the time of a picture of so many paths. */
static double seconds_of(const MethodChoice *choice, int columns, int rows, double paths,
                         const AutoWish *wish) {
    double nodes = choice->nodes, compile = first_compile + compile_by_nodes * nodes * nodes,
           sums = node_time * nodes * spectrum_bands(wish->atmosphere);
    if (!choice->table) return compile + sums * paths;
    double texels = 2.0 * columns * rows;
    return compile + table_compile + sums * texels + (lookup_time + lookup_by_root * sqrt(texels)) * paths;
}

/* A sky that auto may take: gauss:n for each path, or a table that gauss:n fills. */
typedef struct Candidate {
    MethodChoice choice;
    /* Of the table; 0 if there is none. */
    int columns;
    double bias_percent;
    double seconds;
} Candidate;

enum { NODES = 7, SIZES = 5, CANDIDATES = NODES * (1 + SIZES) };

static const int nodes_tried[NODES] = {4, 5, 6, 7, 8, 10, 12};

static bool describe(Candidate *candidate, int nodes, int columns, const AutoWish *wish, Error *error) {
    char text[sizeof candidate->choice.text];
    snprintf(text, sizeof text, columns ? "table:gauss:%d@%dx%d" : "gauss:%d", nodes, columns, 3 * columns);
    if (!method_choose(&candidate->choice, METHOD_SKY, text, error)) return false;
    candidate->bias_percent = bias_sky_percent(&candidate->choice, wish->sun_elevation_deg, wish->atmosphere);
    candidate->columns = columns;
    candidate->seconds = seconds_of(&candidate->choice, columns, 3 * columns, paths_of(wish), wish);
    return true;
}

/* Of two skies whose bias is within `limit`, the cheaper is better; else the one with the smaller bias. */
static bool is_better(const Candidate *a, const Candidate *b, double limit) {
    if ((a->bias_percent <= limit) != (b->bias_percent <= limit)) return a->bias_percent <= limit;
    return a->bias_percent <= limit ? a->seconds < b->seconds : a->bias_percent < b->bias_percent;
}

/* The share of the error asked for that bias may take. Noise takes the rest, in squares: for a third an
 * eighth more samples, and for a half a third more. Further orders get a half, because to fill the tables of
 * a better quality takes longer than these samples. */
static double bias_limit(const AutoWish *wish) {
    return auto_error_percent(wish) / (wish->atmosphere->orders > 1 ? 2 : 3);
}

static const char *share_words(const AutoWish *wish) {
    return wish->atmosphere->orders > 1 ? "half" : "a third";
}

/* Of the share of the error that is left for bias, what the further orders leave for the sky. */
typedef struct Limit {
    double percent;
    double further_percent;
    char words[80];
} Limit;

/* The least bias that any table has. */
static bool least_sky(double *percent, const AutoWish *wish, Error *error) {
    MethodChoice best;
    if (!method_choose(&best, METHOD_SKY, "table:gauss:12@256x768", error)) return false;
    *percent = bias_sky_percent(&best, wish->sun_elevation_deg, wish->atmosphere);
    return true;
}

static bool find_limit(Limit *limit, const MethodChoice *further, const AutoWish *wish, Error *error) {
    double most = bias_limit(wish), least,
           taken = bias_further_percent(further, wish->sun_elevation_deg, wish->atmosphere);
    if (!least_sky(&least, wish, error)) return false;
    bool leaves = taken > 0 && taken + least <= most;
    limit->further_percent = taken;
    limit->percent = leaves ? most - taken : most;
    snprintf(limit->words, sizeof limit->words, "%s%.20s%s%s of the error asked for", leaves ? "what " : "",
             leaves ? further->text : "", leaves ? " leaves of " : "", share_words(wish));
    return true;
}

/* What a sky adds to the time of a picture that reaches its error: the more bias there is, the less is left
 * for noise, and the more paths it takes. INFINITY where bias leaves nothing. */
static double seconds_in_the_end(const Candidate *a, const Limit *limit, const AutoWish *wish) {
    double error = auto_error_percent(wish), left = error - limit->further_percent - a->bias_percent,
           usual = error - bias_limit(wish);
    if (left <= 0) return INFINITY;
    return seconds_of(&a->choice, a->columns, 3 * a->columns, paths_of(wish) * pow(usual / left, 2), wish);
}

/* No table keeps within the limit. Ray by ray a sky takes many times longer, so that the most accurate table
 * is worth more paths, and it is taken at once if no sky leaves anything for noise. */
static const Candidate *prefer_table(const Candidate *best, const Candidate *all, const Limit *limit,
                                     const AutoWish *wish) {
    const Candidate *table = NULL;
    for (int i = 0; i < CANDIDATES; i++) {
        if (all[i].columns && !isnan(all[i].bias_percent) &&
            (!table || all[i].bias_percent < table->bias_percent))
            table = &all[i];
    }
    if (!table || table->bias_percent <= limit->percent) return best;
    double by_table = seconds_in_the_end(table, limit, wish), by_ray = seconds_in_the_end(best, limit, wish);
    if (isinf(by_table) && isinf(by_ray)) return table->seconds < best->seconds ? table : best;
    return by_table < by_ray ? table : best;
}

/* Of the skies that would cost less, the most accurate; NULL if there is none. */
static const Candidate *find_cheaper(const Candidate *best, const Candidate *all) {
    const Candidate *cheaper = NULL;
    for (int i = 0; i < CANDIDATES; i++) {
        if (all[i].seconds < best->seconds && !isnan(all[i].bias_percent) &&
            (!cheaper || all[i].bias_percent < cheaper->bias_percent))
            cheaper = &all[i];
    }
    return cheaper;
}

/* Writes choice->why: the bias of what was taken, and that of what was not. `accurate` is the sky that would
 * have been taken if time were no matter. */
static void say_why(MethodChoice *choice, const Candidate *best, const Candidate *accurate,
                    const Candidate *all, const Limit *limit) {
    const Candidate *cheaper = find_cheaper(best, all);
    char rest[110] = "nothing is cheaper";
    bool within = best->bias_percent <= limit->percent;
    if (within && cheaper)
        snprintf(rest, sizeof rest, "%s is cheaper and errs by %.2g %%", cheaper->choice.text,
                 cheaper->bias_percent);
    if (!within) snprintf(rest, sizeof rest, "ask for more");
    if (best != accurate)
        snprintf(rest, sizeof rest, "%s errs by %.2g %% and takes %.2g times the time", accurate->choice.text,
                 accurate->bias_percent, accurate->seconds / best->seconds);
    snprintf(choice->why, sizeof choice->why, "bias %.2g %%, %s %.2g %%, %s; %s", best->bias_percent,
             within             ? "within"
             : best == accurate ? "the least that there is, not within"
                                : "the least of a table, not within",
             limit->percent, limit->words, rest);
}

static bool take_cheapest(MethodChoice *choice, const MethodChoice *further, const AutoWish *wish,
                          Error *error) {
    Candidate all[CANDIDATES];
    Limit limit;
    const Candidate *accurate = all;
    if (!find_limit(&limit, further, wish, error)) return false;
    for (int i = 0; i < CANDIDATES; i++) {
        int size = i % (1 + SIZES), columns = size ? 8 << size : 0;
        if (!describe(&all[i], nodes_tried[i / (1 + SIZES)], columns, wish, error)) return false;
        if (is_better(&all[i], accurate, limit.percent)) accurate = &all[i];
    }
    const Candidate *best = prefer_table(accurate, all, &limit, wish);
    *choice = best->choice;
    say_why(choice, best, accurate, all, &limit);
    /* The size is found by the sun, as it is for a table that the user names without a size: if the sun
     * moves, the table may add as much error as the nodes leave of the limit. */
    int of_nodes = (int)(best - all) / (1 + SIZES) * (1 + SIZES);
    if (choice->table && best->bias_percent <= limit.percent)
        choice->table_size.percent = limit.percent - all[of_nodes].bias_percent;
    return true;
}

bool auto_sky(MethodChoice *choice, const char *text, const MethodChoice *further, const AutoWish *wish,
              Error *error) {
    if (!method_is_auto(text)) return method_choose(choice, METHOD_SKY, text, error);
    if (!method_choose(choice, METHOD_SKY, "table:gauss:12", error)) return false;
    if (!isnan(bias_sky_percent(choice, wish->sun_elevation_deg, wish->atmosphere)))
        return take_cheapest(choice, further, wish, error);
    snprintf(choice->why, sizeof choice->why,
             "no bias was measured for such an air or such a sun: the most accurate is taken");
    return true;
}

/* From the cheapest to the most accurate: each takes about twice the time of the one before
 * (glsl/sky/README.md). */
static const char *const qualities[] = {"harmonics:8", "harmonics:10", "harmonics:14"};
enum { QUALITIES = sizeof qualities / sizeof *qualities };

/* The bias of the sky that goes with the further orders, if it is known. A text that names no sky is left to
 * auto_sky(). */
static bool sky_beside(double *percent, const char *text, const AutoWish *wish, Error *error) {
    MethodChoice sky;
    Error unused;
    if (!least_sky(percent, wish, error)) return false;
    if (!method_is_auto(text) && method_choose(&sky, METHOD_SKY, text, &unused))
        *percent = bias_sky_percent(&sky, wish->sun_elevation_deg, wish->atmosphere);
    if (isnan(*percent)) *percent = 0;
    return true;
}

bool auto_further(MethodChoice *choice, const char *text, const char *sky_text, const AutoWish *wish,
                  Error *error) {
    double limit = bias_limit(wish), sun = wish->sun_elevation_deg, sky, bias[QUALITIES];
    MethodChoice all[QUALITIES];
    int taken = 0;
    if (!method_is_auto(text) || wish->atmosphere->orders <= 1)
        return method_choose(choice, METHOD_FURTHER, text, error);
    if (!sky_beside(&sky, sky_text, wish, error)) return false;
    for (int i = 0; i < QUALITIES; i++) {
        if (!method_choose(&all[i], METHOD_FURTHER, qualities[i], error)) return false;
        bias[i] = bias_further_guess_percent(&all[i], sun, wish->atmosphere);
        /* Of those that are not good enough the best. */
        if (bias[taken] + sky > limit && bias[i] < bias[taken]) taken = i;
    }
    *choice = all[taken];
    if (isnan(bias_further_percent(choice, sun, wish->atmosphere))) {
        snprintf(choice->why, sizeof choice->why,
                 "no bias was measured for such an air or such a sun: chosen by what is known of earth");
        return true;
    }
    char rest[60] = "nothing is cheaper";
    if (taken)
        snprintf(rest, sizeof rest, "%s is cheaper and errs by %.2g %%", qualities[taken - 1],
                 bias[taken - 1]);
    bool within = bias[taken] + sky <= limit;
    snprintf(choice->why, sizeof choice->why,
             "bias %.2g %%, with the sky's %s %.2g %%, %s of the error asked for; %s", bias[taken],
             within ? "within" : "not within", limit, share_words(wish),
             within ? rest : "there is none better");
    return true;
}
