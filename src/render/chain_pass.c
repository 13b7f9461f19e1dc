#include "render/chain_pass.h"

#include "base/clock.h"
#include "base/memory.h"
#include "gl/texture.h"
#include "render/chain_starts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    COLUMNS = 256,
    /* Chains are counted in such rows: llvmpipe shades four rows together. */
    ROWS_STEP = 4,
    MOST_ROWS = 64,
    /* A chain for so many pixels, so that the candidates of all chains are a few paths for each pixel. */
    PIXELS_A_CHAIN = 4,
    CANDIDATES = 16,
    /* After so many steps all chains begin anew: otherwise the error of the candidates' mean would stay. */
    STEPS_A_LIFE = CANDIDATES + 256,
    /* CHAIN_PAIRS / 2 of glsl/sequence/chain_step.glsl. */
    NUMBER_ROWS = 8,
    /* Steps in a second, before it is measured. */
    FIRST_GUESS = 30
};

/* The time of a call: whoever wants to stop is asked in between. */
static const double most_seconds = 0.1;

/* What glsl/pass/metropolis.glsl writes. */
enum { POINT_NEW, POINT_OLD, LIGHT, TAIL, OUTPUTS };

bool chain_pass_create(ChainPass *pass, const Context *context, const Plan *plan, const RenderParams *params,
                       Error *error) {
    const GlApi *gl = &context->gl;
    *pass = (ChainPass){0};
    if (!plan->sequence.method->walks_chains) return true;
    pass->gl = gl;
    pass->steps_per_second = FIRST_GUESS;
    pass->points = memory_get((size_t)COLUMNS * MOST_ROWS * 4, sizeof *pass->points);
    pass->source_texels = memory_get((size_t)COLUMNS * MOST_ROWS * 4, sizeof *pass->source_texels);
    pass->sources = texture_create(gl, COLUMNS, MOST_ROWS, GL_NEAREST, NULL);
    return target_create(&pass->chains, context, COLUMNS, MOST_ROWS, (1U << OUTPUTS) - 1, error) &&
           target_create(&pass->numbers, context, COLUMNS, MOST_ROWS * NUMBER_ROWS, 1, error) &&
           pass_program(&pass->steps, &chain_steps_pass, gl, plan, params, error) &&
           pass_program(&pass->keep, &chain_keep_pass, gl, plan, params, error);
}

void chain_pass_destroy(ChainPass *pass) {
    if (!pass->gl) return;
    program_destroy(&pass->steps);
    program_destroy(&pass->keep);
    pass->gl->DeleteTextures(1, &pass->sources);
    free(pass->points);
    free(pass->source_texels);
    target_destroy(&pass->chains);
    target_destroy(&pass->numbers);
    *pass = (ChainPass){0};
}

/* Makes a program the one in use, for the next step. */
static void use(const ChainPass *pass, const Program *program, const char *const chain_names[OUTPUTS]) {
    const Target *chains = &pass->chains, *numbers = &pass->numbers;
    program_use(program);
    program_set_uint(program, "chain_number", (unsigned)pass->next);
    program_set_uint(program, "chain_age", (unsigned)(pass->next % STEPS_A_LIFE));
    program_set_uint(program, "chain_candidates", CANDIDATES);
    program_set_float(program, "chain_mean", pass->mean);
    program_set_texture(program, "chain_sources", pass->sources);
    for (int i = 0; i < OUTPUTS; i++)
        if (chain_names[i]) program_set_texture(program, chain_names[i], chains->textures[chains->front][i]);
    program_set_texture(program, "chain_numbers", numbers->textures[numbers->front][0]);
}

/* Proposes a path to each chain, and decides. */
static void propose(ChainPass *pass, int columns, int rows) {
    static const char *const names[OUTPUTS] = {[LIGHT] = "chain_lights", [TAIL] = "chain_tails"};
    use(pass, &pass->steps, names);
    target_begin(&pass->chains, &pass->steps, names);
    program_draw(&pass->steps, 0, 0, columns, rows);
    target_swap(&pass->chains);
}

/* Moves the numbers of the chains that took their step. */
static void keep(ChainPass *pass) {
    static const char *const names[OUTPUTS] = {[LIGHT] = "chain_lights", [TAIL] = "chain_tails"},
                             *const number_names[] = {"chain_numbers"};
    use(pass, &pass->keep, names);
    target_begin(&pass->numbers, &pass->keep, number_names);
    program_draw(&pass->keep, 0, 0, COLUMNS, pass->rows * NUMBER_ROWS);
    target_swap(&pass->numbers);
}

/* Reads what the last step wrote: 4 floats for each chain. */
static void read(const ChainPass *pass, int output, float *texels) {
    const Target *chains = &pass->chains;
    const GlApi *gl = pass->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, chains->framebuffer[chains->front]);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0 + (GLenum)output);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->ReadPixels(0, 0, COLUMNS, pass->rows, GL_RGBA, GL_FLOAT, texels);
}

/* Shares the starts out among the chains, when all candidates are drawn. The random number belongs to this
 * life of the chains: a Weyl sequence over the lives, begun by a hash of the seed. */
static void share_starts(ChainPass *pass) {
    int count = COLUMNS * pass->rows, *sources = memory_get((size_t)count, sizeof *sources);
    float *texels = pass->source_texels, *weights = memory_get((size_t)count, sizeof *weights);
    uint32_t life = (uint32_t)(pass->next / STEPS_A_LIFE), bits = (pass->seed + 1) * 747796405U;
    bits = (bits ^ bits >> 16) * 2891336453U + life * 2654435769U;
    read(pass, LIGHT, texels);
    for (int i = 0; i < count; i++) weights[i] = texels[4 * i + 3];
    pass->mean = chain_starts(weights, count, bits / 4294967296.0, sources) / CANDIDATES;
    for (int i = 0; i < count; i++) {
        texels[4 * i] = (float)(sources[i] % COLUMNS);
        texels[4 * i + 1] = (float)(sources[i] / COLUMNS);
    }
    texture_resize(pass->gl, pass->sources, COLUMNS, MOST_ROWS, texels);
    free(sources);
    free(weights);
}

bool chain_pass_archive(ChainPass *pass, Archive *archive, Error *error) {
    if (!pass->gl) return true;
    size_t size = (size_t)COLUMNS * MOST_ROWS * 4 * sizeof *pass->source_texels;
    ARCHIVE(archive, pass->mean);
    ARCHIVE(archive, pass->next);
    archive_bytes(archive, pass->source_texels, size);
    if (archive_loads(archive))
        texture_resize(pass->gl, pass->sources, COLUMNS, MOST_ROWS, pass->source_texels);
    return target_archive(&pass->chains, archive, error) && target_archive(&pass->numbers, archive, error);
}

/* Adds the points of one kind to the film. */
static void add_points(ChainPass *pass, int kind, Film *film) {
    const Target *chains = &pass->chains;
    const GlApi *gl = pass->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, chains->framebuffer[chains->front]);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0 + (GLenum)kind);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->ReadPixels(0, 0, COLUMNS, pass->rows, GL_RGBA, GL_FLOAT, pass->points);
    film_add_light(film, pass->points, COLUMNS * pass->rows, kind == POINT_NEW ? COLUMNS * pass->rows : 0);
}

static void restart(ChainPass *pass) {
    pass->next = 0;
    target_clear(&pass->chains);
    target_clear(&pass->numbers);
}

bool chain_pass_begin(ChainPass *pass, int width, int height, unsigned seed, Error *error) {
    if (!pass->gl) return true;
    double rows = ceil((double)width * height / PIXELS_A_CHAIN / COLUMNS / ROWS_STEP) * ROWS_STEP;
    pass->rows = (int)fmin(rows, MOST_ROWS);
    pass->seed = seed;
    restart(pass);
    /* Drivers compile a program when it first draws. */
    propose(pass, 1, 1);
    keep(pass);
    if (!program_check(&pass->keep, error)) return false;
    program_use(&pass->steps);
    if (!program_check(&pass->steps, error)) return false;
    restart(pass);
    pass->gl->Finish();
    return gl_check(pass->gl, "beginning chains", error);
}

uint64_t chain_pass_due(const ChainPass *pass, const Film *film, double samples) {
    if (!pass->gl) return 0;
    double due = samples * film->width * film->height - film->light_paths;
    return due > 0 ? (uint64_t)ceil(due) : 0;
}

uint64_t chain_pass_draw(ChainPass *pass, Film *film, uint64_t paths, double seconds) {
    double chains = (double)COLUMNS * pass->rows, begin = clock_seconds();
    if (film->light_paths <= 0 && pass->next > CANDIDATES) restart(pass);
    double most = fmax(floor(fmin(seconds, most_seconds) * pass->steps_per_second), 1);
    int steps = 0, done = 0;
    for (; steps < most && done * chains < (double)paths; steps++) {
        bool starts = pass->next % STEPS_A_LIFE < CANDIDATES;
        if (pass->next % STEPS_A_LIFE == CANDIDATES) share_starts(pass);
        propose(pass, COLUMNS, pass->rows);
        keep(pass);
        for (int kind = POINT_NEW; !starts && kind <= POINT_OLD; kind++) add_points(pass, kind, film);
        done += !starts;
        pass->next++;
    }
    pass->gl->Finish();
    pass->steps_per_second = steps / fmax(clock_seconds() - begin, 1e-6);
    return (uint64_t)(done * chains);
}
