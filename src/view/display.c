#include "view/display.h"

#include <math.h>

static const char *const files[DISPLAY_WAYS] = {"pass/shown_picture.glsl", "pass/shown_enlarged.glsl",
                                                "pass/shown_difference.glsl", "pass/shown_raw.glsl",
                                                "pass/shown_cells.glsl"};

bool display_create(Display *display, const Context *context, const char *library, Error *error) {
    SourceStore *sources = source_store_create(library);
    bool ok = true;
    *display = (Display){0};
    for (int way = 0; ok && way < DISPLAY_WAYS; way++) {
        const GlslSlot slots[] = {{"shown", files[way], NULL}, {NULL, NULL, NULL}};
        GlslSource source;
        ok = glsl_source_create(&source, sources, "pass/display.glsl", slots, error) &&
             program_create(&display->programs[way], &context->gl, &source, error);
        glsl_source_destroy(&source);
    }
    if (ok) {
        const GlslSlot none[] = {{NULL, NULL, NULL}};
        GlslSource source;
        ok = glsl_source_create(&source, sources, "pass/join.glsl", none, error) &&
             program_create(&display->join, &context->gl, &source, error);
        glsl_source_destroy(&source);
    }
    source_store_release(sources);
    return ok;
}

void display_destroy(Display *display) {
    for (int way = 0; way < DISPLAY_WAYS; way++) program_destroy(&display->programs[way]);
    program_destroy(&display->join);
}

static const Program *use(const Display *display, DisplayWay way, const DisplayParams *params) {
    const Program *program = &display->programs[way];
    double size[3] = {params->width, params->height, 0};
    Uniforms uniforms = {0};
    uniforms_declared_in(&uniforms, "pass/display.glsl");
    uniforms_vec3(&uniforms, "window_size", size);
    uniforms_declared_in(&uniforms, "pass/shown_tone.glsl");
    uniforms_float(&uniforms, "gain", exp2(params->exposure_ev));
    uniforms_declared_in(&uniforms, "pass/shown_difference.glsl");
    uniforms_float(&uniforms, "difference", params->difference);
    program_use(program);
    program_set(program, &uniforms);
    uniforms_free(&uniforms);
    return program;
}

/* The texture of the film's sums. What `rest` would add is too small to show in 8 bits. Another framebuffer
 * may be bound afterwards. */
static GLuint front(const Display *display, const Film *film) {
    return film_join(film, &display->join);
}

static GLuint back(const Film *film) {
    return film->target.textures[1 - film->target.front][0];
}

/* Draws the columns [left, right) and rows [top, bottom) of a film. */
static void draw_part(const Display *display, const DisplayParams *params, GLuint texture, const Film *film,
                      const int columns[2], const int rows[2]) {
    bool same = film->width == params->width && film->height == params->height;
    const Program *program = use(display, same ? DISPLAY_PICTURE : DISPLAY_ENLARGED, params);
    if (columns[0] >= columns[1] || rows[0] >= rows[1]) return;
    program_set_texture(program, "film_a", texture);
    program_draw(program, columns[0], params->height - rows[1], columns[1] - columns[0], rows[1] - rows[0]);
}

static void draw_side(const Display *display, const DisplayParams *params, const DisplaySide *side,
                      GLuint front, const int columns[2]) {
    int upper[2] = {0, side->next ? side->rows : 0}, lower[2] = {upper[1], params->height};
    if (side->next) draw_part(display, params, back(side->next), side->next, columns, upper);
    draw_part(display, params, front, side->film, columns, lower);
}

static void draw_all(const Program *program, const DisplayParams *params) {
    program_draw(program, 0, 0, params->width, params->height);
}

static void draw_raw(const Display *display, const DisplayParams *params) {
    const Program *program = use(display, DISPLAY_RAW, params);
    program_set_texture(program, "film_a", params->raw);
    draw_all(program, params);
}

static void draw_difference(const Display *display, const DisplayParams *params, const GLuint fronts[2]) {
    const Program *program = use(display, DISPLAY_DIFFERENCE, params);
    program_set_texture(program, "film_a", fronts[0]);
    program_set_texture(program, "film_b", fronts[1]);
    draw_all(program, params);
}

bool display_draw(const Display *display, const DisplayParams *params, Error *error) {
    const GlApi *gl = display->programs[0].gl;
    const DisplaySide *sides = params->sides;
    int divider = sides[1].film ? (int)round(params->divider * params->width) : params->width;
    int left[2] = {0, divider}, right[2] = {divider, params->width};
    GLuint fronts[2] = {0};
    for (int i = 0; i < 2; i++)
        if (sides[i].film) fronts[i] = front(display, sides[i].film);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->Viewport(0, 0, params->width, params->height);
    if (params->raw) {
        draw_raw(display, params);
    } else if (params->difference > 0) {
        draw_difference(display, params, fronts);
    } else {
        draw_side(display, params, &sides[0], fronts[0], left);
        if (sides[1].film) draw_side(display, params, &sides[1], fronts[1], right);
    }
    return gl_check(gl, "showing the picture", error);
}

void display_cells(const Display *display, const Film *film, const Target *cells) {
    const DisplayParams params = {.width = cells->width, .height = cells->height};
    GLuint sums = front(display, film);
    cells->gl->BindFramebuffer(GL_FRAMEBUFFER, cells->framebuffer[1 - cells->front]);
    cells->gl->Viewport(0, 0, cells->width, cells->height);
    const Program *program = use(display, DISPLAY_CELLS, &params);
    program_set_texture(program, "film_a", sums);
    draw_all(program, &params);
}
