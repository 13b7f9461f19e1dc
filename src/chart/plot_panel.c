#include "chart/plot_panel.h"

#include "base/vec3.h"
#include "chart/plot_frame.h"
#include "chart/plot_text.h"

#include <math.h>
#include <stdio.h>

static const double left_margin = 54, right_margin = 16, top_margin = 26, bottom_margin = 44;
static const double row_height = 14, swatch = 26, ring_radius = 7.5;
static const char front_label[] = "the Pareto front of all";
static const PlotText small = {.size = 10}, beside = {.size = 10, .backed = true},
                      bold = {.size = 10, .bold = true, .backed = true};

/* The colours of Okabe and Ito, without their yellow, which is too light on white. */
static const double colors[PLOT_COLORS][3] = {{0.00, 0.45, 0.70}, {0.84, 0.37, 0.00}, {0.00, 0.62, 0.45},
                                              {0.80, 0.47, 0.65}, {0.90, 0.62, 0.00}, {0.34, 0.71, 0.91},
                                              {0.25, 0.25, 0.25}};

enum {
    /* The rings of places that are tried for a label. */
    LABEL_RINGS = 6,
    /* What a ring further out costs, in the unit of plot_frame_crowd(). */
    FAR_COSTS = 6
};

void plot_panel_include(const PlotPanel *panel, PlotAxis *across, PlotAxis *up) {
    for (int s = 0; s < panel->series_count; s++) {
        for (int i = 0; i < panel->series[s].count; i++) {
            const PlotPoint *point = &panel->series[s].points[i];
            plot_axis_include(across, point->x);
            plot_axis_include(up, point->y);
            plot_axis_include(up, point->high);
        }
    }
    plot_axis_include(across, panel->ring.x);
    plot_axis_include(up, panel->ring.y);
}

static void draw_grid_line(const PlotFrame *frame, bool vertical, double value, bool strong) {
    const PlotBox *box = &frame->box;
    /* A line through the middle of pixels is sharp. */
    double x = floor(plot_frame_x(frame, value)) + 0.5, y = floor(plot_frame_y(frame, value)) + 0.5;
    cairo_move_to(frame->cairo, vertical ? x : box->x, vertical ? box->y : y);
    cairo_line_to(frame->cairo, vertical ? x : box->x + box->width, vertical ? box->y + box->height : y);
    double grey = strong ? 0.80 : 0.92;
    cairo_set_source_rgb(frame->cairo, grey, grey, grey);
    cairo_set_line_width(frame->cairo, strong ? 1 : 0.7);
    cairo_stroke(frame->cairo);
}

static void draw_axis(const PlotFrame *frame, bool vertical) {
    const PlotAxis *axis = vertical ? &frame->across : &frame->up;
    const PlotBox *box = &frame->box;
    PlotTick ticks[PLOT_TICKS];
    int count = plot_axis_ticks(axis, ticks);
    for (int i = 0; i < count; i++) draw_grid_line(frame, vertical, ticks[i].value, ticks[i].strong);
    for (int i = 0; i < count; i++) {
        if (!ticks[i].label[0]) continue;
        if (vertical) {
            plot_text(frame->cairo, ticks[i].label, plot_frame_x(frame, ticks[i].value),
                      box->y + box->height + 14, &(PlotText){.size = 10, .grey = true, .align = 0.5});
        } else {
            plot_text(frame->cairo, ticks[i].label, box->x - 6, plot_frame_y(frame, ticks[i].value) + 3.5,
                      &(PlotText){.size = 10, .grey = true, .align = 1});
        }
    }
}

static void draw_axes(const PlotFrame *frame) {
    cairo_t *cairo = frame->cairo;
    const PlotBox *box = &frame->box;
    draw_axis(frame, true);
    draw_axis(frame, false);
    cairo_rectangle(cairo, floor(box->x) + 0.5, floor(box->y) + 0.5, floor(box->width), floor(box->height));
    cairo_set_source_rgb(cairo, 0.4, 0.4, 0.4);
    cairo_set_line_width(cairo, 1);
    cairo_stroke(cairo);
    plot_text(cairo, frame->panel->title, box->x, box->y - 8, &(PlotText){.size = 11, .bold = true});
    plot_text(cairo, frame->panel->x_label, box->x + box->width / 2, box->y + box->height + 32,
              &(PlotText){.size = 11, .align = 0.5});
    cairo_save(cairo);
    cairo_translate(cairo, box->x - 40, box->y + box->height / 2);
    cairo_rotate(cairo, -pi / 2);
    plot_text(cairo, frame->panel->y_label, 0, 0, &(PlotText){.size = 11, .align = 0.5});
    cairo_restore(cairo);
}

static void draw_marker(cairo_t *cairo, PlotMarker marker, double x, double y) {
    static const double corners[][8] = {[PLOT_SQUARE] = {-3, -3, 3, -3, 3, 3, -3, 3},
                                        [PLOT_TRIANGLE] = {0, -4, 3.7, 2.9, -3.7, 2.9, 0, -4},
                                        [PLOT_DIAMOND] = {0, -4.4, 4.4, 0, 0, 4.4, -4.4, 0}};
    cairo_new_path(cairo);
    if (marker == PLOT_DOT) {
        cairo_arc(cairo, x, y, 3.2, 0, 2 * pi);
    } else {
        for (int i = 0; i < 8; i += 2)
            cairo_line_to(cairo, x + corners[marker][i], y + corners[marker][i + 1]);
    }
    cairo_close_path(cairo);
    cairo_fill(cairo);
}

static void use_line(cairo_t *cairo, PlotLine line) {
    static const double dashes[] = {5, 3}, dots[] = {1.2, 2.6};
    if (line == PLOT_DASHED) cairo_set_dash(cairo, dashes, 2, 0);
    if (line == PLOT_DOTTED) cairo_set_dash(cairo, dots, 2, 0);
    cairo_set_line_width(cairo, 1.6);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
}

static void draw_polyline(const PlotFrame *frame, const PlotPoint *points, int count) {
    for (int i = 0; i < count; i++)
        cairo_line_to(frame->cairo, plot_frame_x(frame, points[i].x), plot_frame_y(frame, points[i].y));
    cairo_stroke(frame->cairo);
    cairo_set_dash(frame->cairo, NULL, 0, 0);
}

static void draw_series(const PlotFrame *frame, const PlotSeries *series) {
    const double *color = colors[series->color];
    cairo_set_source_rgb(frame->cairo, color[0], color[1], color[2]);
    use_line(frame->cairo, series->line);
    if (series->line != PLOT_NO_LINE) draw_polyline(frame, series->points, series->count);
    cairo_set_dash(frame->cairo, NULL, 0, 0);
    cairo_set_line_width(frame->cairo, 1);
    for (int i = 0; i < series->count; i++) {
        const PlotPoint *point = &series->points[i];
        double x = plot_frame_x(frame, point->x), y = plot_frame_y(frame, point->y);
        draw_marker(frame->cairo, series->marker, x, y);
        if (point->high <= 0) continue;
        cairo_move_to(frame->cairo, x, y);
        cairo_line_to(frame->cairo, x, plot_frame_y(frame, point->high));
        cairo_move_to(frame->cairo, x - 3, plot_frame_y(frame, point->high));
        cairo_line_to(frame->cairo, x + 3, plot_frame_y(frame, point->high));
        cairo_stroke(frame->cairo);
    }
}

static void use_halo(cairo_t *cairo) {
    cairo_set_source_rgb(cairo, 1.0, 0.90, 0.55);
    cairo_set_line_width(cairo, 9);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
}

/* Draws a label where it hides least, around a point. It is at least `gap` away from the point, and as near
 * as it can be. */
static PlotBox draw_label(PlotFrame *frame, const char *text, double x, double y, double gap,
                          const PlotText *style) {
    double width = plot_text_width(frame->cairo, text, style), height = 11;
    PlotBox best = {0};
    int least = 1 << 30;
    for (int i = 0; i < 8 * LABEL_RINGS; i++) {
        static const int across[] = {1, -1, 1, -1, 1, -1, 0, 0}, down[] = {-1, 1, 1, -1, 0, 0, 1, -1};
        double away = gap + 12 * (i / 8);
        PlotBox place = {x + across[i % 8] * (away + width / 2) - width / 2,
                         y + down[i % 8] * (away + height / 2) - height / 2, width, height};
        int hidden = plot_frame_crowd(frame, place) + FAR_COSTS * (i / 8);
        if (hidden < least) least = hidden, best = place;
    }
    plot_frame_take(frame, best);
    plot_text(frame->cairo, text, best.x, best.y + height - 2, style);
    return best;
}

static void draw_labels(PlotFrame *frame) {
    for (int s = 0; s < frame->panel->series_count; s++) {
        for (int i = 0; i < frame->panel->series[s].count; i++) {
            const PlotPoint *point = &frame->panel->series[s].points[i];
            if (!point->label[0]) continue;
            draw_label(frame, point->label, plot_frame_x(frame, point->x), plot_frame_y(frame, point->y), 4,
                       &beside);
        }
    }
}

static void draw_ring(PlotFrame *frame) {
    const PlotPoint *ring = &frame->panel->ring;
    if (!(ring->x > 0)) return;
    double x = plot_frame_x(frame, ring->x), y = plot_frame_y(frame, ring->y);
    cairo_new_path(frame->cairo);
    cairo_arc(frame->cairo, x, y, ring_radius, 0, 2 * pi);
    cairo_set_source_rgb(frame->cairo, 0, 0, 0);
    cairo_set_line_width(frame->cairo, 2);
    cairo_stroke(frame->cairo);
    plot_frame_take(frame, (PlotBox){x - ring_radius, y - ring_radius, 2 * ring_radius, 2 * ring_radius});
    PlotBox label = draw_label(frame, frame->panel->ring_label, x, y, ring_radius + 1, &bold);
    /* If the label is not beside its ring, a line joins the two. */
    double to_x = fmin(fmax(x, label.x), label.x + label.width) - x;
    double to_y = fmin(fmax(y, label.y), label.y + label.height) - y, away = hypot(to_x, to_y);
    if (away < 2 * ring_radius) return;
    cairo_move_to(frame->cairo, x + to_x / away * ring_radius, y + to_y / away * ring_radius);
    cairo_line_to(frame->cairo, x + to_x * (1 - 2 / away), y + to_y * (1 - 2 / away));
    cairo_set_source_rgb(frame->cairo, 0, 0, 0);
    cairo_set_line_width(frame->cairo, 1);
    cairo_stroke(frame->cairo);
}

static PlotBox legend_size(const PlotFrame *frame) {
    const PlotPanel *panel = frame->panel;
    PlotBox box = {0};
    for (int i = 0; i < panel->series_count; i++) {
        box.width =
            fmax(box.width, swatch + 6 + plot_text_width(frame->cairo, panel->series[i].label, &small));
        if (panel->series[i].label[0]) box.height += row_height;
    }
    for (int i = 0; i < panel->note_count; i++)
        box.width = fmax(box.width, plot_text_width(frame->cairo, panel->notes[i], &small));
    if (panel->front_count)
        box.width = fmax(box.width, swatch + 6 + plot_text_width(frame->cairo, front_label, &small));
    box.height += row_height * (panel->note_count + (panel->front_count > 0));
    box.width += 12;
    box.height += 6;
    return box;
}

static PlotBox legend_place(const PlotFrame *frame) {
    PlotBox size = legend_size(frame), best = {0};
    int least = 1 << 30;
    for (int i = 0; i < 4; i++) {
        static const int right[] = {0, 1, 1, 0}, low[] = {1, 0, 1, 0};
        PlotBox place = size;
        place.x = frame->box.x + 6 + right[i] * (frame->box.width - size.width - 12);
        place.y = frame->box.y + 6 + low[i] * (frame->box.height - size.height - 12);
        int hidden = plot_frame_crowd(frame, place);
        if (hidden < least) least = hidden, best = place;
    }
    return best;
}

static void draw_swatch(const PlotFrame *frame, const PlotSeries *series, double x, double y) {
    const double *color = colors[series->color];
    cairo_set_source_rgb(frame->cairo, color[0], color[1], color[2]);
    use_line(frame->cairo, series->line);
    cairo_move_to(frame->cairo, x, y);
    cairo_line_to(frame->cairo, x + swatch, y);
    if (series->line == PLOT_NO_LINE) cairo_new_path(frame->cairo);
    cairo_stroke(frame->cairo);
    cairo_set_dash(frame->cairo, NULL, 0, 0);
    draw_marker(frame->cairo, series->marker, x + swatch / 2, y);
}

static void draw_legend(const PlotFrame *frame, PlotBox box) {
    const PlotPanel *panel = frame->panel;
    cairo_t *cairo = frame->cairo;
    if (box.height <= 6) return;
    cairo_rectangle(cairo, box.x, box.y, box.width, box.height);
    cairo_set_source_rgba(cairo, 1, 1, 1, 0.85);
    cairo_fill(cairo);
    double x = box.x + 6, y = box.y + 3 + row_height / 2;
    for (int i = 0; i < panel->series_count; i++) {
        if (!panel->series[i].label[0]) continue;
        draw_swatch(frame, &panel->series[i], x, y);
        plot_text(cairo, panel->series[i].label, x + swatch + 6, y + 3.5, &small);
        y += row_height;
    }
    if (panel->front_count) {
        cairo_save(cairo);
        use_halo(cairo);
        cairo_move_to(cairo, x + 4, y);
        cairo_line_to(cairo, x + swatch - 4, y);
        cairo_stroke(cairo);
        cairo_restore(cairo);
        plot_text(cairo, front_label, x + swatch + 6, y + 3.5, &small);
        y += row_height;
    }
    for (int i = 0; i < panel->note_count; i++, y += row_height)
        plot_text(cairo, panel->notes[i], x, y + 3.5, &(PlotText){.size = 10, .grey = true});
}

void plot_panel_draw(const PlotPanel *panel, cairo_t *cairo, const PlotPlace *place) {
    double top = panel->title[0] ? top_margin : 0;
    PlotBox box = {place->x + left_margin, place->y + top, place->width - left_margin - right_margin,
                   place->height - top - bottom_margin};
    PlotFrame frame = {.panel = panel, .cairo = cairo, .box = box, .across = place->across, .up = place->up};
    draw_axes(&frame);
    cairo_save(cairo);
    cairo_rectangle(cairo, box.x, box.y, box.width, box.height);
    cairo_clip(cairo);
    cairo_save(cairo);
    use_halo(cairo);
    draw_polyline(&frame, panel->front, panel->front_count);
    cairo_restore(cairo);
    for (int i = 0; i < panel->series_count; i++) draw_series(&frame, &panel->series[i]);
    cairo_restore(cairo);
    PlotBox legend = legend_place(&frame);
    draw_legend(&frame, legend);
    plot_frame_take(&frame, legend);
    draw_labels(&frame);
    draw_ring(&frame);
}
