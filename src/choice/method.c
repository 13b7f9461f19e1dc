#include "choice/method.h"

#include "base/text.h"

#include <stdio.h>
#include <string.h>

enum {
    MOST_STEPS = 65535,
    FEWEST_NODES = 4,
    MOST_NODES = 12,
    DEFAULT_NODES = 8,
    MOST_SEGMENTS = 6,
    FEWEST_TEXELS = 4,
    MOST_TEXELS = 1024
};

/* What a table whose size is not given may add to a picture's error, percent. */
static const double default_table_percent = 0.1;

static const char *const family_names[METHOD_FAMILIES] = {"--sky", "--light", "--sequence", "--sun-disk"};

static const char *const defaults[METHOD_FAMILIES] = {"table:gauss:8", "cosine", "sobol", "sampled"};

static const Method methods[] = {
    {METHOD_SKY, "gauss", "pass/sums_gauss.glsl", true,
     "gauss[:n]: Gauss-Legendre with n nodes a segment, 4 to 12 (8), columns to the sun in closed form"},
    {METHOD_SKY, "table", NULL, false,
     "table[:METHOD][@CxR]: what gauss or paper gives (gauss:8), tabulated once per sun position, C azimuths "
     "by R "
     "elevations above the horizon and R below (by the sun)"},
    {METHOD_SKY, "paper", "pass/sums_paper.glsl", true,
     "paper[:NxM]: the paper's sums, N midpoints along the view ray, M back to the eye and M toward the sun "
     "(16x4)"},
    {METHOD_SKY, "uniform", "pass/sky_uniform.glsl", false, "uniform[:L]: radiance L (1) from everywhere"},
    {METHOD_LIGHT, "cosine", "light/cosine.glsl", false,
     "Lambert's surfaces, bounces by the cosine, no light sampling"},
    {METHOD_LIGHT, "control", "pass/light_control.glsl", false,
     "cosine, on level ground with the open sky as control variate and bounces toward the scene's bounds"},
    {METHOD_LIGHT, "mis", "pass/light_mis.glsl", false,
     "bounces by the material or toward the bright sky, by multiple importance sampling"},
    {METHOD_LIGHT, "paper", "light/paper.glsl", false,
     "the author's bounce, lobe 2 cos^3 / pi: a picture of its own"},
    {METHOD_SEQUENCE, "additive", "sequence/additive.glsl", false,
     "additive recurrence in 24 dimensions, shifted by hashing"},
    {METHOD_SEQUENCE, "random", "sequence/random.glsl", false, "independent numbers from a PCG hash"},
    {METHOD_SEQUENCE, "sobol", "sequence/sobol.glsl", false,
     "Sobol pairs, shuffled and Owen-scrambled by hashing"},
    {METHOD_SUN, "off", "sun/off.glsl", false, "the sun lights the sky and is not there itself"},
    {METHOD_SUN, "sampled", "sun/sampled.glsl", false,
     "each hit seeks the disk, straight and by the mirrors that the scene names; its own image is exact"},
    {METHOD_SUN, "chance", "sun/chance.glsl", false, "rays find the disk or do not: to judge the other by"},
};

const Method *method_get(int index) {
    return index >= 0 && index < (int)(sizeof methods / sizeof *methods) ? &methods[index] : NULL;
}

const char *method_default(MethodFamily family) {
    return defaults[family];
}

/* The "16x4" of paper:16x4. */
static bool parse_paper(MethodChoice *choice, const char *numbers, Error *error) {
    int used = 0, n = 16, m = 4;
    if (numbers && (sscanf(numbers, "%5dx%5d%n", &n, &m, &used) != 2 || numbers[used] || n < 1 || m < 1 ||
                    n > MOST_STEPS || m > MOST_STEPS)) {
        return error_set(error, STATUS_USAGE, "--sky: 'paper:%s' is not paper:NxM with N and M from 1 to %d",
                         numbers, MOST_STEPS);
    }
    choice->counts[0] = n;
    choice->counts[1] = m;
    choice->iterations = n + (long)n * m;
    snprintf(choice->text, sizeof choice->text, "paper:%dx%d", n, m);
    return true;
}

static bool parse_gauss(MethodChoice *choice, const char *number, Error *error) {
    unsigned long long nodes = DEFAULT_NODES;
    if (number && (!count_parse(number, &nodes) || nodes < FEWEST_NODES || nodes > MOST_NODES)) {
        return error_set(error, STATUS_USAGE, "--sky: 'gauss:%s' is not gauss:n with n from %d to %d", number,
                         FEWEST_NODES, MOST_NODES);
    }
    choice->counts[0] = (int)nodes;
    choice->iterations =
        MOST_SEGMENTS * (1 + 2 * (long)nodes + (long)(nodes * nodes)); /* were nothing unrolled */
    snprintf(choice->text, sizeof choice->text, "gauss:%llu", nodes);
    return true;
}

static bool parse_uniform(MethodChoice *choice, const char *number, Error *error) {
    choice->level = 1;
    if (number && !number_parse_range("--sky uniform", number, 0, 1e6, &choice->level, error)) return false;
    snprintf(choice->text, sizeof choice->text, "uniform:%g", choice->level);
    return true;
}

/* The "gauss:8@32x96" of table:gauss:8@32x96. */
static bool parse_table(MethodChoice *choice, const char *text, Error *error) {
    const char *size = text ? strchr(text, '@') : NULL;
    char base[sizeof choice->text];
    int columns = 0, rows = 0, used = 0;
    if (size &&
        (sscanf(size, "@%4dx%4d%n", &columns, &rows, &used) != 2 || size[used] || columns < FEWEST_TEXELS ||
         rows < FEWEST_TEXELS || columns > MOST_TEXELS || rows > MOST_TEXELS)) {
        return error_set(error, STATUS_USAGE,
                         "--sky: 'table%s%s' is not table:METHOD@COLUMNSxROWS with both from %d to %d",
                         *text == '@' ? "" : ":", text, FEWEST_TEXELS, MOST_TEXELS);
    }
    snprintf(base, sizeof base, "%.*s", size ? (int)(size - text) : 40, text ? text : "");
    if (!method_choose(choice, METHOD_SKY, base[0] ? base : "gauss", error)) return false;
    if (choice->table || !choice->method->integrates) {
        return error_set(error, STATUS_USAGE, "--sky: 'table:%s': a table is filled by gauss or paper", text);
    }
    choice->table = true;
    choice->columns = columns;
    choice->rows = rows;
    choice->table_percent = size ? 0 : default_table_percent;
    snprintf(base, sizeof base, "%s", choice->text);
    snprintf(choice->text, sizeof choice->text, size ? "table:%.28s@%dx%d" : "table:%.28s", base, columns,
             rows);
    return true;
}

static bool parse_numbers(MethodChoice *choice, const char *numbers, Error *error) {
    const Method *method = choice->method;
    if (method->family == METHOD_SKY) {
        if (strcmp(method->name, "paper") == 0) return parse_paper(choice, numbers, error);
        if (strcmp(method->name, "gauss") == 0) return parse_gauss(choice, numbers, error);
        if (strcmp(method->name, "table") == 0) return parse_table(choice, numbers, error);
        return parse_uniform(choice, numbers, error);
    }
    snprintf(choice->text, sizeof choice->text, "%s", method->name);
    if (!numbers) return true;
    return error_set(error, STATUS_USAGE, "%s: %s takes no numbers", family_names[method->family],
                     method->name);
}

bool method_choose(MethodChoice *choice, MethodFamily family, const char *text, Error *error) {
    if (!text || strcmp(text, "auto") == 0) text = defaults[family];
    size_t length = strcspn(text, ":@");
    const char *numbers = text[length] == ':' ? text + length + 1 : text[length] ? text + length : NULL;
    Text known = {0};
    *choice = (MethodChoice){0};
    for (int i = 0; method_get(i); i++) {
        const Method *method = &methods[i];
        if (method->family != family) continue;
        if (strlen(method->name) == length && strncmp(method->name, text, length) == 0) {
            text_free(&known);
            choice->method = method;
            return parse_numbers(choice, numbers, error);
        }
        text_print(&known, ", %s", method->name);
    }
    error_set(error, STATUS_USAGE, "%s: unknown method '%s' (known: auto%s)", family_names[family], text,
              text_string(&known));
    text_free(&known);
    return false;
}
