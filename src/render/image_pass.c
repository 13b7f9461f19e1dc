#include "render/image_pass.h"

#include "base/clock.h"
#include "gl/texture.h"

#include <math.h>

/* llvmpipe shades blocks of columns together. */
enum { COLUMNS_STEP = 16 };

static const float nothing[4] = {0};

bool image_pass_create(ImagePass *pass, const Context *context, const Plan *plan, Error *error) {
    const GlApi *gl = &context->gl;
    *pass = (ImagePass){0};
    if (!plan->sun.method->draws_image) return true;
    *pass = (ImagePass){.gl = gl, .width = 1, .height = 1};
    pass->texture = texture_create(gl, 1, 1, GL_NEAREST, nothing);
    gl->GenFramebuffers(1, &pass->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, pass->framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, pass->texture, 0);
    return gl_check(gl, "the sun's image", error);
}

void image_pass_destroy(ImagePass *pass) {
    if (!pass->gl) return;
    pass->gl->DeleteFramebuffers(1, &pass->framebuffer);
    pass->gl->DeleteTextures(1, &pass->texture);
    program_destroy(&pass->program);
    *pass = (ImagePass){0};
}

bool image_pass_compile(ImagePass *pass, const SunImage *image, const Plan *plan, const RenderParams *params,
                        Error *error) {
    GlslSource source = {0};
    /* A window must not come to a stop when the sun comes into view. */
    if (!pass->gl || pass->program.id || !(image->count || params->use != PICTURE_FILE)) return true;
    bool ok = pass_text(&sun_image_pass, plan, params, &source, error) &&
              pass_compile(&pass->program, pass->gl, &source, params, error);
    glsl_source_destroy(&source);
    return ok;
}

/* The side of the empty texture that stands in for one of this side. llvmpipe compiles a program anew when a
 * texture's side becomes a power of two or ceases to be one, which takes it up to a second. */
static int stand_in(int side) {
    return side & (side - 1) ? 3 : 1;
}

void image_pass_begin(ImagePass *pass, const SunImage *image, int width, int height) {
    if (!pass->gl) return;
    pass->where = *image;
    if (!image->count) width = stand_in(width), height = stand_in(height);
    if (width != pass->width || height != pass->height)
        texture_resize(pass->gl, pass->texture, width, height, NULL);
    pass->width = width;
    pass->height = height;
    pass->gl->BindFramebuffer(GL_FRAMEBUFFER, pass->framebuffer);
    pass->gl->ClearBufferfv(GL_COLOR, 0, nothing);
}

void image_pass_warm_up(const ImagePass *pass, const Film *film) {
    const Program *program = &pass->program;
    if (!program->id) return;
    program_use(program);
    program_set_uint(program, "group_samples", 1);
    film_give(film, program);
    pass->gl->BindFramebuffer(GL_FRAMEBUFFER, pass->framebuffer);
    pass->gl->Viewport(0, 0, pass->width, pass->height);
    program_draw(program, 0, 0, 1, 1);
    pass->gl->ClearBufferfv(GL_COLOR, 0, nothing);
}

static int largest(int a, int b) {
    return a > b ? a : b;
}

/* Draws a rectangle in pieces of a twentieth of a second. */
static void draw_pieces(ImagePass *pass, const Rectangle *r, unsigned group) {
    static const double piece_s = 0.05, first_guess = 1e4;
    double *speed = &pass->pixel_samples_per_second;
    for (int x = 0, y = 0; y < r->height;) {
        double pixels = piece_s * (*speed > 0 ? *speed : first_guess) / group, begin = clock_seconds();
        int rows = x ? 1 : (int)fmin(fmax(floor(pixels / r->width), 1), r->height - y),
            columns = (int)fmin(fmax(floor(pixels / rows), COLUMNS_STEP), r->width - x);
        program_draw(&pass->program, r->x + x, r->y + y, columns, rows);
        pass->gl->Finish();
        double taken = fmax(clock_seconds() - begin, 1e-6), measured = (double)rows * columns * group / taken;
        /* One small piece that is quick says little of the next. */
        *speed = *speed > 0 ? fmin(measured, 4 * *speed) : fmin(measured, 4 * first_guess);
        x = x + columns < r->width ? x + columns : 0;
        y += x ? 0 : rows;
    }
}

static void draw_both(ImagePass *pass, const Rectangle *a, const Rectangle *b, unsigned group) {
    int x = largest(a->x, b->x), y = largest(a->y, b->y);
    int right = -largest(-a->x - a->width, -b->x - b->width);
    int bottom = -largest(-a->y - a->height, -b->y - b->height);
    Rectangle both = {x, y, right - x, bottom - y};
    if (right > x && bottom > y) draw_pieces(pass, &both, group);
}

void image_pass_draw(ImagePass *pass, const Film *film, const Rectangle *regions, int count, unsigned group) {
    const Program *program = &pass->program;
    if (!pass->where.count) return;
    program_use(program);
    program_set_uint(program, "group_samples", group);
    film_give(film, program);
    pass->gl->BindFramebuffer(GL_FRAMEBUFFER, pass->framebuffer);
    pass->gl->Viewport(0, 0, pass->width, pass->height);
    for (int i = 0; i < pass->where.count * count; i++)
        draw_both(pass, &pass->where.rectangles[i / count], &regions[i % count], group);
}
