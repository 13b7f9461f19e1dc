#include "choice/auto.h"

#include "choice/bias.h"

#include <math.h>
#include <stdio.h>

/* A picture's noise after n samples is about 10 % / sqrt(n): the crater's and the materials' are. */
static const double noise_of_one_sample = 10;

double auto_error_percent(const AutoWish *wish) {
    if (wish->error_percent > 0) return wish->error_percent;
    return wish->samples > 0 ? fmin(noise_of_one_sample / sqrt(wish->samples), AUTO_ERROR_PERCENT)
                             : AUTO_ERROR_PERCENT;
}

/* No error is known before some 16 samples. */
static double paths_of(const AutoWish *wish) {
    double needed = pow(noise_of_one_sample / auto_error_percent(wish), 2);
    return (wish->samples > 0 ? wish->samples : fmax(needed, 16)) * wish->pixels;
}

/* Seconds that a sky takes on two cores with llvmpipe, beside the picture's own: compiling, which goes with
 * the square of the nodes, once for a shader that asks anew and once more for a table's; then 9 ns a node and
 * path, or a look into a table, the slower the less of it fits the caches. */
static double seconds_of(const MethodChoice *choice, int columns, int rows, double paths) {
    double nodes = choice->nodes, compile = 0.09 + 0.0035 * nodes * nodes;
    if (!choice->table) return compile + 9e-9 * nodes * paths;
    double texels = 2.0 * columns * rows;
    return compile + 0.03 + 9e-9 * nodes * texels + (7e-9 + 3e-11 * sqrt(texels)) * paths;
}

/* What auto looks at: nodes asked for each path, or a table that they fill. */
typedef struct Candidate {
    MethodChoice choice;
    double bias, seconds; /* percent; estimated */
} Candidate;

enum { NODES = 7, SIZES = 5, CANDIDATES = NODES * (1 + SIZES) };

static const int nodes_tried[NODES] = {4, 5, 6, 7, 8, 10, 12};

static bool describe(Candidate *candidate, int nodes, int columns, const AutoWish *wish, Error *error) {
    char text[sizeof candidate->choice.text];
    snprintf(text, sizeof text, columns ? "table:gauss:%d@%dx%d" : "gauss:%d", nodes, columns, 3 * columns);
    if (!method_choose(&candidate->choice, METHOD_SKY, text, error)) return false;
    candidate->bias = bias_sky_percent(&candidate->choice, wish->sun_elevation_deg, wish->atmosphere);
    candidate->seconds = seconds_of(&candidate->choice, columns, 3 * columns, paths_of(wish));
    return true;
}

/* Of those that err by `limit` at most the cheapest, or else the best. */
static bool is_better(const Candidate *a, const Candidate *b, double limit) {
    if ((a->bias <= limit) != (b->bias <= limit)) return a->bias <= limit;
    return a->bias <= limit ? a->seconds < b->seconds : a->bias < b->bias;
}

/* The best of those that would cost less, in words. */
static void say_why(MethodChoice *choice, const Candidate *best, const Candidate *all, double limit) {
    const Candidate *cheaper = NULL;
    char rest[100] = "nothing is cheaper";
    for (int i = 0; i < CANDIDATES; i++) {
        if (all[i].seconds < best->seconds && (!cheaper || all[i].bias < cheaper->bias)) cheaper = &all[i];
    }
    if (cheaper)
        snprintf(rest, sizeof rest, "%s is cheaper and errs by %.2g %%", cheaper->choice.text, cheaper->bias);
    snprintf(choice->why, sizeof choice->why, "bias %.2g %%, %s %.2g %%, a third of the error asked for; %s",
             best->bias, best->bias <= limit ? "within" : "the least that there is, not within", limit,
             best->bias <= limit ? rest : "ask for more");
}

static bool take_cheapest(MethodChoice *choice, const AutoWish *wish, Error *error) {
    Candidate all[CANDIDATES];
    double limit = auto_error_percent(wish) / 3;
    const Candidate *best = all;
    for (int i = 0; i < CANDIDATES; i++) {
        int size = i % (1 + SIZES), columns = size ? 8 << size : 0;
        if (!describe(&all[i], nodes_tried[i / (1 + SIZES)], columns, wish, error)) return false;
        if (is_better(&all[i], best, limit)) best = &all[i];
    }
    *choice = best->choice;
    say_why(choice, best, all, limit);
    /* Should the sun move, the table takes what its nodes have left, so now that size. */
    int of_nodes = (int)(best - all) / (1 + SIZES) * (1 + SIZES);
    if (choice->table && best->bias <= limit) choice->table_size.percent = limit - all[of_nodes].bias;
    return true;
}

bool auto_sky(MethodChoice *choice, const char *text, const AutoWish *wish, Error *error) {
    if (!method_is_auto(text)) return method_choose(choice, METHOD_SKY, text, error);
    if (!method_choose(choice, METHOD_SKY, "table:gauss:12", error)) return false;
    if (!isnan(bias_sky_percent(choice, wish->sun_elevation_deg, wish->atmosphere)))
        return take_cheapest(choice, wish, error);
    snprintf(choice->why, sizeof choice->why,
             "nothing was measured for such an air or such a sun: the best nodes");
    return true;
}

/* Where mis takes the least time to an error, measured over the scenes with the sun from 60 to -2 degrees:
 * what stands upright sees the glow of a low sun, and by the cosine alone seldom: with the sun at 1 to 15
 * degrees a sixth to a half of the time, in the house and the arcade nine tenths, and on hills, which are
 * ground, up to twice as much. Light that glass and metal throw is found by the material's own bounces, of
 * which mis leaves a half: there it takes twice the time. And where nothing but mirrors stands on the ground,
 * control is ahead by a quarter. */
static bool glows(const MethodChoice *sky, const AutoWish *wish) {
    bool low = wish->sun_elevation_deg >= -1 && wish->sun_elevation_deg <= 20;
    return low && sky->method->integrates && !wish->shiny && !(wish->bounds && wish->mirrors);
}

bool auto_light(MethodChoice *choice, const char *text, const MethodChoice *sky, const AutoWish *wish,
                Error *error) {
    bool automatic = method_is_auto(text);
    bool low = glows(sky, wish);
    if (automatic && low) text = "mis";
    if (automatic && !low && sky->table && wish->bounds) text = "control";
    if (!method_choose(choice, METHOD_LIGHT, text, error)) return false;
    if (automatic) {
        snprintf(choice->why, sizeof choice->why, "%s",
                 low            ? "a low sun glows on what stands upright"
                 : !sky->table  ? "control would ask the sky twice a path, and there is no table of it"
                 : wish->bounds ? "the sky is a table and the scene has bounds"
                                : "the scene has no bounds");
    }
    return true;
}
