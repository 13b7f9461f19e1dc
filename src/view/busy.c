#include "view/busy.h"

#include "base/clock.h"
#include "view/log.h"

#include <stdio.h>

/* How often events are asked for, from when on the line is shown and how often, and how long the worker may
 * take to end its task when the user leaves; seconds. */
static const double poll_s = 0.004, patience_s = 0.4, interval_s = 0.1, leave_s = 0.3;
/* A copy takes a few milliseconds. */
static const double copy_interval_s = 0.25;

bool busy_start(Busy *busy, Error *error) {
    return worker_start(&busy->worker, busy->window, error);
}

void busy_stop(Busy *busy) {
    worker_stop(&busy->worker);
    target_destroy(&busy->copy);
}

bool busy_copy(Busy *busy, Error *error) {
    const Context *context = &busy->window->context;
    const GlApi *gl = &context->gl;
    int width = busy->window->width, height = busy->window->height;
    double now = clock_seconds();
    bool fits = busy->copy.gl && busy->copy.width == width && busy->copy.height == height;
    if (fits && now < busy->copied + copy_interval_s) return true;
    if (!fits) {
        target_destroy(&busy->copy);
        if (!target_create(&busy->copy, context, width, height, 1, error)) return false;
    }
    busy->copied = now;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, busy->copy.framebuffer[busy->copy.front]);
    gl->BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return gl_check(gl, "keeping the picture", error);
}

/* Shows the copy and the line. */
static bool show(Busy *busy, double seconds, Error *error) {
    const GlApi *gl = &busy->window->context.gl;
    const float black[4] = {0, 0, 0, 1};
    char line[64];
    if (!busy->window->width) return true;
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->ClearBufferfv(GL_COLOR, 0, black);
    DisplayParams params = {.width = busy->window->width,
                            .height = busy->window->height,
                            .raw = busy->copy.textures[busy->copy.front][0]};
    if (params.raw && !display_draw(busy->display, &params, error)) return false;
    snprintf(line, sizeof line, "compiling, %.0f s", seconds);
    overlay_say(busy->overlay, line);
    window_present(busy->window);
    log_begin("compiling");
    log_number("seconds", seconds);
    log_end();
    busy->shown = true;
    return true;
}

/* Ends the program in the midst of the work. */
static void leave(const Busy *busy, bool stopped) {
    log_begin("end");
    log_text("message", "");
    log_end();
    busy->params->leave(stopped);
}

bool busy_run(Busy *busy, WorkerTask *task, void *data, Error *error) {
    double start = clock_seconds(), shown = start, wished = 0;
    bool ok = true;
    window_forget_call();
    worker_begin(&busy->worker, task, data);
    while (!worker_wait(&busy->worker, poll_s)) {
        double now = clock_seconds();
        window_poll(busy->window, 0);
        bool stops = busy->params->stop && busy->params->stop();
        if (wished <= 0 && (stops || window_wants_end(busy->window))) wished = now;
        if (wished > 0 && now > wished + leave_s) leave(busy, stops);
        if (!ok || now < start + patience_s || now < shown + interval_s) continue;
        shown = now;
        ok = show(busy, now - start, error);
    }
    return ok && worker_result(&busy->worker, error);
}
