#include "render/photon_pass.h"

#include "base/clock.h"
#include "base/memory.h"
#include "gl/texture.h"

#include <math.h>
#include <stdlib.h>

enum {
    /* A batch's texels. Paths are counted in whole rows. */
    BATCH_COLUMNS = 256,
    BATCH_ROWS = 256,
    /* The rows of the batch by which the paths are aimed. */
    AIM_ROWS = 128,
    /* The coarse picture by which throwing surfaces are looked for, and the paths in each of its pixels. */
    COARSE_SIDE = 64,
    COARSE_ROWS = 4,
    COARSE_PATHS = 4,
    COARSE_HITS = 4,
    /* Paths in a second, before it is measured. */
    FIRST_GUESS = 300000
};

/* What glsl/pass/photons.glsl writes. */
enum { POINT, START };

/* The number of light paths for each path from the camera. */
static const double paths_a_path = 0.4;

static void attach(const PhotonPass *pass) {
    static const GLenum buffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT0 + 1};
    const GLuint textures[] = {pass->points, pass->starts};
    pass->gl->BindFramebuffer(GL_FRAMEBUFFER, pass->framebuffer);
    for (int i = 0; i < 2; i++)
        pass->gl->FramebufferTexture2D(GL_FRAMEBUFFER, buffers[i], GL_TEXTURE_2D, textures[i], 0);
    pass->gl->DrawBuffers(2, buffers);
}

bool photon_pass_create(PhotonPass *pass, const Context *context, const Plan *plan,
                        const RenderParams *params, Error *error) {
    const GlApi *gl = &context->gl;
    *pass = (PhotonPass){0};
    if (!plan->sun.method->traces_light) return true;
    pass->gl = gl;
    pass->paths_per_second = FIRST_GUESS;
    pass->points = texture_create(gl, BATCH_COLUMNS, BATCH_ROWS, GL_NEAREST, NULL);
    pass->starts = texture_create(gl, BATCH_COLUMNS, BATCH_ROWS, GL_NEAREST, NULL);
    pass->tree = texture_create(gl, AIM_NODES, 1, GL_NEAREST, NULL);
    gl->GenFramebuffers(1, &pass->framebuffer);
    attach(pass);
    return gl_check(gl, "textures for light paths", error) &&
           pass_program(&pass->throwers, &throwers_pass, gl, plan, params, error) &&
           pass_program(&pass->photons, &photons_pass, gl, plan, params, error);
}

void photon_pass_destroy(PhotonPass *pass) {
    if (!pass->gl) return;
    const GLuint textures[] = {pass->points, pass->starts, pass->tree};
    pass->gl->DeleteFramebuffers(1, &pass->framebuffer);
    pass->gl->DeleteTextures(3, textures);
    program_destroy(&pass->throwers);
    program_destroy(&pass->photons);
    *pass = (PhotonPass){0};
}

static void read(const PhotonPass *pass, int attachment, int width, int height, float *texels) {
    const GlApi *gl = pass->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, pass->framebuffer);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0 + (GLenum)attachment);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, texels);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0);
}

void photon_pass_give(const PhotonPass *pass, const Program *program) {
    if (!pass->gl) return;
    program_set_texture(program, "aim_tree", pass->tree);
    program_set_vec4(program, "aim_box", pass->aim.box);
    program_set_float(program, "aim_middle", pass->aim.plane);
    program_set_float(program, "aim_highest", pass->aim.top);
    program_set_float(program, "aim_paths", pass->paths_a_sample);
}

/* Draws rows of the batch with a program that is in use. */
static void draw(const PhotonPass *pass, const Program *program, int row, int width, int rows) {
    pass->gl->BindFramebuffer(GL_FRAMEBUFFER, pass->framebuffer);
    pass->gl->Viewport(0, 0, BATCH_COLUMNS, BATCH_ROWS);
    program_draw(program, 0, row, width, rows);
}

/* Makes the program of light paths the one in use, for those from number `first` on. */
static void use(const PhotonPass *pass, uint64_t first) {
    program_use(&pass->photons);
    photon_pass_give(pass, &pass->photons);
    program_set_uint(&pass->photons, "photon_first", (unsigned)first);
    program_set_uint(&pass->photons, "photon_lap", (unsigned)(first >> 32));
    program_set_uint(&pass->photons, "photon_columns", BATCH_COLUMNS);
}

/* Rows that are drawn together: as many as take a tenth of a second, but llvmpipe shades four rows together.
 */
static int piece_rows(const PhotonPass *pass, double rows_left) {
    static const double piece_s = 0.1;
    double fit = 4 * floor(piece_s * pass->paths_per_second / BATCH_COLUMNS / 4);
    return (int)fmin(fmax(fit, 4), rows_left);
}

/* Traces rows of paths, in pieces, the first of which is small before the speed is known. */
static void trace(PhotonPass *pass, uint64_t first, int rows) {
    use(pass, first);
    pass->gl->BindFramebuffer(GL_FRAMEBUFFER, pass->framebuffer);
    pass->gl->Viewport(0, 0, BATCH_COLUMNS, BATCH_ROWS);
    for (int row = 0; row < rows;) {
        double begin = clock_seconds();
        int piece = pass->measured ? piece_rows(pass, rows - row) : (int)fmin(4, rows - row);
        program_draw(&pass->photons, 0, row, BATCH_COLUMNS, piece);
        pass->gl->Finish();
        pass->paths_per_second = (double)piece * BATCH_COLUMNS / fmax(clock_seconds() - begin, 1e-6);
        pass->measured = true;
        row += piece;
    }
}

/* Finds places that throw light, and aims at them. */
static bool find_throwers(PhotonPass *pass, const Frame *frame, Error *error) {
    double coarse[3] = {COARSE_SIDE, COARSE_SIDE, 0},
           spread = tan(fmin(frame->state.sun.radius_deg, 45) * 0.017453292519943295);
    float *places = memory_get((size_t)COARSE_SIDE * COARSE_SIDE * 4, sizeof *places);
    program_use(&pass->throwers);
    program_set_vec3(&pass->throwers, "picture_size", coarse);
    program_set_uint(&pass->throwers, "thrower_paths", COARSE_PATHS);
    program_set_int(&pass->throwers, "thrower_hits", COARSE_HITS);
    bool ok = program_check(&pass->throwers, error);
    if (ok) {
        /* A few rows at a time, because nothing is known of their time. */
        for (int row = 0; row < COARSE_SIDE; row += COARSE_ROWS) {
            draw(pass, &pass->throwers, row, COARSE_SIDE, COARSE_ROWS);
            pass->gl->Finish();
        }
        read(pass, POINT, COARSE_SIDE, COARSE_SIDE, places);
        aim_begin(&pass->aim, places, COARSE_SIDE * COARSE_SIDE, spread);
        ok = gl_check(pass->gl, "looking for surfaces that throw light", error);
    }
    free(places);
    return ok;
}

static void upload(const PhotonPass *pass) {
    texture_resize(pass->gl, pass->tree, AIM_NODES, 1, pass->aim.nodes[0]);
}

/* Improves the aim by the light that a batch of paths brings. */
static void improve(PhotonPass *pass) {
    float *starts = memory_get((size_t)AIM_ROWS * BATCH_COLUMNS * 4, sizeof *starts);
    trace(pass, 0, AIM_ROWS);
    read(pass, START, BATCH_COLUMNS, AIM_ROWS, starts);
    aim_improve(&pass->aim, starts, AIM_ROWS * BATCH_COLUMNS);
    free(starts);
    upload(pass);
}

/* So many light paths in whole rows, as a picture has that took them bit by bit. */
static uint64_t whole_rows(double paths) {
    return (uint64_t)ceil(ceil(paths) / BATCH_COLUMNS) * BATCH_COLUMNS;
}

bool photon_pass_aim(PhotonPass *pass, const Frame *frame, bool traces, Error *error) {
    if (!pass->gl) return true;
    double pixels = (double)frame->camera.width * frame->camera.height;
    pass->aim.any = false;
    if (traces && !find_throwers(pass, frame, error)) return false;
    pass->paths_a_sample = pass->aim.any ? paths_a_path * pixels : 0;
    upload(pass);
    if (pass->aim.any) improve(pass);
    if (!pass->aim.any) pass->paths_a_sample = 0;
    pass->first = whole_rows(pass->paths_a_sample * (double)frame->first_sample);
    pass->before = frame->first_sample;
    use(pass, 0);
    return program_check(&pass->photons, error) && gl_check(pass->gl, "aiming light paths", error);
}

uint64_t photon_pass_due(const PhotonPass *pass, const Film *film, double samples) {
    double due =
        pass->paths_a_sample * ((double)pass->before + samples) - (double)pass->first - film->light_paths;
    return due > 0 ? (uint64_t)ceil(due) : 0;
}

/* A whole number of rows with so many paths, but no more rows than are traced in that time. llvmpipe shades
 * four rows together. */
static uint64_t rows_for(const PhotonPass *pass, uint64_t paths, double seconds) {
    double fit = 4 * floor(seconds * pass->paths_per_second / BATCH_COLUMNS / 4);
    double rows = ceil((double)paths / BATCH_COLUMNS);
    return (uint64_t)fmin(fmin(rows, BATCH_ROWS), fmax(fit, 4));
}

uint64_t photon_pass_draw(PhotonPass *pass, Film *film, uint64_t paths, double seconds) {
    uint64_t rows = rows_for(pass, paths, seconds);
    trace(pass, pass->first + (uint64_t)film->light_paths, (int)rows);
    float *points = memory_get((size_t)rows * BATCH_COLUMNS * 4, sizeof *points);
    read(pass, POINT, BATCH_COLUMNS, (int)rows, points);
    film_add_light(film, points, (int)rows * BATCH_COLUMNS, (double)rows * BATCH_COLUMNS);
    free(points);
    return rows * BATCH_COLUMNS;
}
