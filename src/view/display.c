#include "view/display.h"

#include <math.h>

static const char *const files[DISPLAY_WAYS] = {"pass/shown_picture.glsl", "pass/shown_enlarged.glsl",
                                                "pass/shown_difference.glsl", "pass/shown_raw.glsl"};

bool display_create(Display *display, const Context *context, const char *library, Error *error) {
    *display = (Display){0};
    for (int way = 0; way < DISPLAY_WAYS; way++) {
        const GlslSlot slots[] = {{"shown", files[way], NULL}, {NULL, NULL, NULL}};
        GlslSource source;
        bool ok = glsl_source_create(&source, library, "pass/display.glsl", slots, error) &&
                  program_create(&display->programs[way], &context->gl, &source, error);
        glsl_source_destroy(&source);
        if (!ok) return false;
    }
    return true;
}

void display_destroy(Display *display) {
    for (int way = 0; way < DISPLAY_WAYS; way++) program_destroy(&display->programs[way]);
}

static const Program *use(const Display *display, DisplayWay way, const DisplayParams *params) {
    const Program *program = &display->programs[way];
    double size[3] = {params->width, params->height, 0};
    program_use(program);
    program_set_vec3(program, "window_size", size);
    program_set_float(program, "gain", exp2(params->exposure_ev));
    program_set_float(program, "difference", params->difference);
    program_set_int(program, "film_a", 0);
    program_set_int(program, "film_b", 1);
    return program;
}

static void bind(const GlApi *gl, int unit, GLuint texture) {
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->ActiveTexture(GL_TEXTURE0);
}

/* The film's sums; its compensation is below what 8 bits show. */
static GLuint front(const Film *film) {
    return film->target.textures[film->target.front][0];
}

static GLuint back(const Film *film) {
    return film->target.textures[1 - film->target.front][0];
}

/* Columns [left, right) and rows [top, bottom) of a film. */
static void draw_part(const Display *display, const DisplayParams *params, GLuint texture, const Film *film,
                      const int columns[2], const int rows[2]) {
    bool same = film->width == params->width && film->height == params->height;
    const Program *program = use(display, same ? DISPLAY_PICTURE : DISPLAY_ENLARGED, params);
    if (columns[0] >= columns[1] || rows[0] >= rows[1]) return;
    bind(program->gl, 0, texture);
    program_draw(program, columns[0], params->height - rows[1], columns[1] - columns[0], rows[1] - rows[0]);
}

static void draw_side(const Display *display, const DisplayParams *params, const DisplaySide *side,
                      const int columns[2]) {
    int upper[2] = {0, side->next ? side->rows : 0}, lower[2] = {upper[1], params->height};
    if (side->next) draw_part(display, params, back(side->next), side->next, columns, upper);
    draw_part(display, params, front(side->film), side->film, columns, lower);
}

static void draw_all(const Display *display, const DisplayParams *params, DisplayWay way) {
    program_draw(use(display, way, params), 0, 0, params->width, params->height);
}

bool display_draw(const Display *display, const DisplayParams *params, Error *error) {
    const GlApi *gl = display->programs[0].gl;
    const DisplaySide *sides = params->sides;
    int divider = sides[1].film ? (int)round(params->divider * params->width) : params->width;
    int left[2] = {0, divider}, right[2] = {divider, params->width};
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->Viewport(0, 0, params->width, params->height);
    if (params->raw) {
        bind(gl, 0, params->raw);
        draw_all(display, params, DISPLAY_RAW);
    } else if (params->difference > 0) {
        bind(gl, 0, front(sides[0].film));
        bind(gl, 1, front(sides[1].film));
        draw_all(display, params, DISPLAY_DIFFERENCE);
    } else {
        draw_side(display, params, &sides[0], left);
        if (sides[1].film) draw_side(display, params, &sides[1], right);
    }
    return gl_check(gl, "showing the picture", error);
}
