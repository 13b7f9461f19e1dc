#include "chart/plot_frame.h"

double plot_frame_x(const PlotFrame *frame, double x) {
    return frame->box.x + frame->box.width * plot_axis_at(&frame->across, x);
}

double plot_frame_y(const PlotFrame *frame, double y) {
    return frame->box.y + frame->box.height * (1 - plot_axis_at(&frame->up, y));
}

/* Returns how much of a polyline is in the box, or of its points alone. */
static int crowd_of_points(const PlotFrame *frame, const PlotPoint *points, int count, bool line,
                           PlotBox box) {
    int hidden = 0;
    for (int i = 0; i < 8 * count; i++) {
        const PlotPoint *a = &points[i / 8], *b = i / 8 + 1 < count && line ? a + 1 : a;
        double share = i % 8 / 8.0;
        if (i % 8 && a == b) continue;
        double x = plot_frame_x(frame, a->x) * (1 - share) + plot_frame_x(frame, b->x) * share - box.x,
               y = plot_frame_y(frame, a->y) * (1 - share) + plot_frame_y(frame, b->y) * share - box.y;
        if (x > -5 && x < box.width + 5 && y > -5 && y < box.height + 5) hidden += i % 8 ? 1 : 4;
    }
    return hidden;
}

int plot_frame_crowd(const PlotFrame *frame, PlotBox box) {
    const PlotPanel *panel = frame->panel;
    int hidden = crowd_of_points(frame, panel->front, panel->front_count, true, box);
    for (int s = 0; s < panel->series_count; s++) {
        const PlotSeries *series = &panel->series[s];
        hidden += crowd_of_points(frame, series->points, series->count, series->line != PLOT_NO_LINE, box);
    }
    for (int i = 0; i < frame->taken_count; i++) {
        const PlotBox *other = &frame->taken[i];
        if (box.x < other->x + other->width && other->x < box.x + box.width &&
            box.y < other->y + other->height && other->y < box.y + box.height)
            hidden += 400;
    }
    const PlotBox *all = &frame->box;
    if (box.x < all->x || box.y < all->y || box.x + box.width > all->x + all->width ||
        box.y + box.height > all->y + all->height)
        hidden += 1000;
    return hidden;
}

void plot_frame_take(PlotFrame *frame, PlotBox box) {
    if (frame->taken_count < PLOT_POINTS) frame->taken[frame->taken_count++] = box;
}
