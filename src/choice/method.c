#include "choice/method.h"

#include "base/known.h"
#include "base/number.h"

#include <stdio.h>
#include <string.h>

enum {
    MOST_STEPS = 65535,
    DEFAULT_VIEW_STEPS = 16,
    DEFAULT_LIGHT_STEPS = 4,
    FEWEST_NODES = 4,
    MOST_NODES = 12,
    DEFAULT_NODES = 8,
    /* glsl/sky/gauss.glsl cuts a view ray into so many segments at most. */
    MOST_SEGMENTS = 6,
    FEWEST_TEXELS = 4,
    MOST_TEXELS = 1024
};

/* What a table whose size is not given may add to a picture's error, percent. */
static const double default_table_percent = 0.1;

static const MethodFamilyRow families[METHOD_FAMILIES] = {
    [METHOD_SKY] = {"--sky", "table:gauss:8",
                    "gauss:n or a table of it, the cheapest whose bias is within a third of the error asked "
                    "for"},
    [METHOD_LIGHT] = {"--light", "cosine",
                      "portal in a room with portals that the sun itself does not light, mis for a low sun "
                      "on more than ground, control with a table of the sky and a scene that has bounds, "
                      "else cosine"},
    [METHOD_SEQUENCE] = {"--sequence", "sobol", "sobol"},
    [METHOD_SUN] =
        {"--sun-disk", "sampled",
         "traced for a scene with glass, rough metal or mirrors that it does not name, else sampled"},
    [METHOD_FURTHER] = {"--further", "harmonics:10", "harmonics:10"},
};

static bool parse_gauss(MethodChoice *choice, const char *number, Error *error);
static bool parse_paper(MethodChoice *choice, const char *numbers, Error *error);
static bool parse_table(MethodChoice *choice, const char *text, Error *error);
static bool parse_uniform(MethodChoice *choice, const char *number, Error *error);
static bool parse_harmonics(MethodChoice *choice, const char *number, Error *error);

/* The degrees of harmonics that there is a plan for (sky/orders_plan.h). */
static const int degrees[] = {8, 10, 14};
enum { DEFAULT_DEGREE = 10 };

static const Method methods[] = {
    {.family = METHOD_SKY,
     .name = "gauss",
     .file = "pass/sums_gauss.glsl",
     .form = "gauss[:n]",
     .about = "Gauss-Legendre with n nodes a segment, 4 to 12 (8), columns to the sun in closed form",
     .parse = parse_gauss,
     .numbers = NUMBERS_NODES,
     .variants = {"gauss:4", "gauss:8", "gauss:12"},
     .integrates = true},
    {.family = METHOD_SKY,
     .name = "table",
     .form = "table[:METHOD][@CxR]",
     .about = "what gauss or paper gives (gauss:8), tabulated once per sun position, C azimuths by R "
              "elevations above the horizon and R below (by the sun)",
     .parse = parse_table},
    {.family = METHOD_SKY,
     .name = "paper",
     .file = "pass/sums_paper.glsl",
     .form = "paper[:NxM]",
     .about =
         "the paper's sums, N midpoints along the view ray, M back to the eye and M toward the sun (16x4)",
     .parse = parse_paper,
     .numbers = NUMBERS_STEPS,
     .variants = {"paper:16x4", "paper:64x16"},
     .integrates = true},
    {.family = METHOD_SKY,
     .name = "uniform",
     .file = "pass/sky_uniform.glsl",
     .form = "uniform[:L]",
     .about = "radiance L (1) from everywhere",
     .parse = parse_uniform,
     .numbers = NUMBERS_LEVEL},

    {.family = METHOD_LIGHT,
     .name = "cosine",
     .file = "light/cosine.glsl",
     .about = "bounces by Lambert's cosine, no light sampling"},
    {.family = METHOD_LIGHT,
     .name = "control",
     .file = "pass/light_control.glsl",
     .about = "as cosine, but on level ground with the open sky as control variate and bounces toward the "
              "scene's bounds",
     .needs_irradiance = true,
     .loops_over_bounds = true,
     .extra_sky_lookups = 1},
    {.family = METHOD_LIGHT,
     .name = "mis",
     .file = "pass/light_mis.glsl",
     .about = "bounces by the material or toward the bright sky, by multiple importance sampling",
     .needs_sky_sampler = true},
    {.family = METHOD_LIGHT,
     .name = "portal",
     .file = "light/portal.glsl",
     .about =
         "as cosine, and each hit sends a ray to the sky by way of one of the scene's portals, by multiple "
         "importance sampling",
     .samples_portals = true},
    {.family = METHOD_LIGHT,
     .name = "paper",
     .file = "light/paper.glsl",
     .about =
         "the bounce of the paper's program, lobe 2 cos^3 / pi: not Lambert's, so that the picture differs",
     .own_lobe = true},

    {.family = METHOD_SEQUENCE,
     .name = "additive",
     .file = "sequence/additive.glsl",
     .about = "additive recurrence in 24 dimensions, shifted by hashing",
     .low_discrepancy = true},
    {.family = METHOD_SEQUENCE,
     .name = "random",
     .file = "sequence/random.glsl",
     .about = "independent numbers from a PCG hash"},
    {.family = METHOD_SEQUENCE,
     .name = "metropolis",
     .file = "sequence/sobol.glsl",
     .about = "Markov chains that stay near bright paths (Kelemen 2002); no error can be told, so --spp or "
              "--time is needed",
     .low_discrepancy = true,
     .walks_chains = true},
    {.family = METHOD_SEQUENCE,
     .name = "sobol",
     .file = "sequence/sobol.glsl",
     .about = "Sobol pairs, shuffled and Owen-scrambled by hashing",
     .low_discrepancy = true},

    {.family = METHOD_SUN,
     .name = "off",
     .file = "sun/off.glsl",
     .about = "the sun lights the sky and is not there itself"},
    {.family = METHOD_SUN,
     .name = "sampled",
     .file = "pass/sun_sampled.glsl",
     .about =
         "each hit samples the disk, directly and by way of the mirrors that the scene names; the disk's own "
         "image is exact",
     .has_disk = true,
     .samples_disk = true,
     .draws_image = true},
    {.family = METHOD_SUN,
     .name = "traced",
     .file = "pass/sun_traced.glsl",
     .about = "as sampled, and what glass, metal and unnamed mirrors throw on other surfaces is traced from "
              "the sun, too",
     .has_disk = true,
     .samples_disk = true,
     .draws_image = true,
     .traces_light = true},
    {.family = METHOD_SUN,
     .name = "chance",
     .file = "pass/sun_chance.glsl",
     .about = "rays meet the disk only by chance; a check of the other method, far noisier",
     .has_disk = true},

    {.family = METHOD_FURTHER,
     .name = "harmonics",
     .form = "harmonics[:n]",
     .about =
         "the further orders of scattering from spherical harmonics up to degree n, 8, 10 (default) or 14",
     .parse = parse_harmonics,
     .numbers = NUMBERS_DEGREE,
     .variants = {"harmonics:8", "harmonics:10", "harmonics:14"}},
};

const MethodFamilyRow *method_family(MethodFamily family) {
    return &families[family];
}

const Method *method_get(int index) {
    return index >= 0 && index < (int)(sizeof methods / sizeof *methods) ? &methods[index] : NULL;
}

bool method_is_auto(const char *text) {
    return !text || strcmp(text, "auto") == 0;
}

bool method_is_reference(const char *text) {
    return text && strcmp(text, "reference") == 0;
}

/* The "16x4" of paper:16x4. */
static bool parse_paper(MethodChoice *choice, const char *numbers, Error *error) {
    int used = 0, view = DEFAULT_VIEW_STEPS, light = DEFAULT_LIGHT_STEPS;
    if (numbers && (sscanf(numbers, "%5dx%5d%n", &view, &light, &used) != 2 || numbers[used] || view < 1 ||
                    light < 1 || view > MOST_STEPS || light > MOST_STEPS)) {
        return error_set(error, STATUS_USAGE, "--sky: 'paper:%s' is not paper:NxM with N and M from 1 to %d",
                         numbers, MOST_STEPS);
    }
    choice->steps = (MethodSteps){view, light};
    choice->iterations = view + (long)view * light;
    snprintf(choice->text, sizeof choice->text, "paper:%dx%d", view, light);
    return true;
}

static bool parse_gauss(MethodChoice *choice, const char *number, Error *error) {
    unsigned long long nodes = DEFAULT_NODES;
    if (number && (!count_parse(number, &nodes) || nodes < FEWEST_NODES || nodes > MOST_NODES)) {
        return error_set(error, STATUS_USAGE, "--sky: 'gauss:%s' is not gauss:n with n from %d to %d", number,
                         FEWEST_NODES, MOST_NODES);
    }
    choice->nodes = (int)nodes;
    /* As many as there would be if the compiler unrolled none of the loops. */
    choice->iterations = MOST_SEGMENTS * (1 + 2 * (long)nodes + (long)(nodes * nodes));
    snprintf(choice->text, sizeof choice->text, "gauss:%llu", nodes);
    return true;
}

static bool parse_uniform(MethodChoice *choice, const char *number, Error *error) {
    choice->level = 1;
    if (number && !number_parse_range("--sky uniform", number, 0, 1e6, &choice->level, error)) return false;
    snprintf(choice->text, sizeof choice->text, "uniform:%g", choice->level);
    return true;
}

static bool parse_harmonics(MethodChoice *choice, const char *number, Error *error) {
    unsigned long long n = DEFAULT_DEGREE;
    bool ok = !number || count_parse(number, &n), known = false;
    for (size_t i = 0; i < sizeof degrees / sizeof *degrees; i++) known = known || n == (unsigned)degrees[i];
    if (!ok || !known) {
        return error_set(error, STATUS_USAGE,
                         "--further: 'harmonics:%s' is not harmonics:n with n of 8, 10 or 14", number);
    }
    choice->degree = (int)n;
    snprintf(choice->text, sizeof choice->text, "harmonics:%d", choice->degree);
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
    choice->table_size = (MethodTable){columns, rows, size ? 0 : default_table_percent};
    snprintf(base, sizeof base, "%s", choice->text);
    snprintf(choice->text, sizeof choice->text, size ? "table:%.28s@%dx%d" : "table:%.28s", base, columns,
             rows);
    return true;
}

static bool parse_numbers(MethodChoice *choice, const char *numbers, Error *error) {
    const Method *method = choice->method;
    if (method->parse) return method->parse(choice, numbers, error);
    snprintf(choice->text, sizeof choice->text, "%s", method->name);
    if (!numbers) return true;
    return error_set(error, STATUS_USAGE, "%s: %s takes no numbers", families[method->family].option,
                     method->name);
}

bool method_choose(MethodChoice *choice, MethodFamily family, const char *text, Error *error) {
    if (method_is_auto(text)) text = families[family].fallback;
    size_t length = strcspn(text, ":@");
    const char *numbers = text[length] == ':' ? text + length + 1 : text[length] ? text + length : NULL;
    Known known = known_to(text, length);
    known_add(&known, "auto");
    *choice = (MethodChoice){0};
    for (int i = 0; method_get(i); i++) {
        const Method *method = &methods[i];
        if (method->family != family) continue;
        if (strlen(method->name) == length && strncmp(method->name, text, length) == 0) {
            known_free(&known);
            choice->method = method;
            return parse_numbers(choice, numbers, error);
        }
        known_add(&known, method->name);
    }
    return known_fail(&known, STATUS_USAGE, error, "%s: unknown method '%s'", families[family].option, text);
}
