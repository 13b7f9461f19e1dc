#include "chart/plot_text.h"

static void use_font(cairo_t *cairo, const PlotText *style) {
    cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           style->bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, style->size);
}

double plot_text_width(cairo_t *cairo, const char *text, const PlotText *style) {
    cairo_text_extents_t extents;
    use_font(cairo, style);
    cairo_text_extents(cairo, text, &extents);
    return extents.x_advance;
}

void plot_text(cairo_t *cairo, const char *text, double x, double y, const PlotText *style) {
    double grey = style->grey ? 0.35 : 0.1, width = plot_text_width(cairo, text, style);
    double start = x - style->align * width;
    if (style->backed) {
        cairo_rectangle(cairo, start - 1, y - 0.8 * style->size, width + 2, style->size);
        cairo_set_source_rgba(cairo, 1, 1, 1, 0.75);
        cairo_fill(cairo);
    }
    cairo_set_source_rgb(cairo, grey, grey, grey);
    cairo_move_to(cairo, start, y);
    cairo_show_text(cairo, text);
    cairo_new_path(cairo);
}
