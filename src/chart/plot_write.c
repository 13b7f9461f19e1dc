#include "chart/plot_write.h"

#include "base/file.h"
#include "chart/plot_panel.h"
#include "chart/plot_text.h"

#include <cairo-svg.h>

enum { WIDTH = 800, PANEL_HEIGHT = 372, LOW_PANEL_HEIGHT = 270, TITLE_HEIGHT = 46, PIXELS_A_UNIT = 2 };

static int columns_of(const Plot *plot) {
    return plot->panel_count > 1 ? 2 : 1;
}

/* Returns the height of a panel. Panels in two rows are flatter than panels in one. */
static int panel_height_of(const Plot *plot) {
    return plot->panel_count > 2 ? LOW_PANEL_HEIGHT : PANEL_HEIGHT;
}

static int height_of(const Plot *plot) {
    int rows = (plot->panel_count + columns_of(plot) - 1) / columns_of(plot);
    return TITLE_HEIGHT + (rows > 0 ? rows : 1) * panel_height_of(plot);
}

static void draw(const Plot *plot, cairo_t *cairo) {
    int columns = columns_of(plot);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_paint(cairo);
    plot_text(cairo, plot->title, 12, 20, &(PlotText){.size = 14, .bold = true});
    plot_text(cairo, plot->subtitle, 12, 37, &(PlotText){.size = 10.5, .grey = true});
    for (int i = 0; i < plot->panel_count; i++) {
        PlotPlace place = {.x = WIDTH / columns * (i % columns),
                           .y = TITLE_HEIGHT + panel_height_of(plot) * (i / columns),
                           .width = WIDTH / columns,
                           .height = panel_height_of(plot)};
        for (int k = 0; k < plot->panel_count; k++) {
            if (plot->same_axes || k == i) plot_panel_include(&plot->panels[k], &place.across, &place.up);
        }
        plot_axis_finish(&place.across);
        plot_axis_finish(&place.up);
        plot_panel_draw(&plot->panels[i], cairo, &place);
    }
}

static cairo_status_t append(void *text, const unsigned char *data, unsigned size) {
    text_append(text, data, size);
    return CAIRO_STATUS_SUCCESS;
}

static cairo_status_t draw_svg(const Plot *plot, Text *out) {
    cairo_surface_t *surface = cairo_svg_surface_create_for_stream(append, out, WIDTH, height_of(plot));
    cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
    cairo_t *cairo = cairo_create(surface);
    draw(plot, cairo);
    cairo_surface_finish(surface);
    cairo_status_t status = cairo_surface_status(surface);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    return status;
}

static cairo_status_t draw_png(const Plot *plot, Text *out) {
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, PIXELS_A_UNIT * WIDTH,
                                                          PIXELS_A_UNIT * height_of(plot));
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, PIXELS_A_UNIT, PIXELS_A_UNIT);
    draw(plot, cairo);
    cairo_status_t status = cairo_surface_write_to_png_stream(surface, append, out);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    return status;
}

bool plot_write(const Plot *plot, const char *path, Error *error) {
    static const struct {
        const char *extension;
        cairo_status_t (*draw)(const Plot *plot, Text *out);
    } formats[] = {{"svg", draw_svg}, {"png", draw_png}};
    bool ok = true;
    for (int i = 0; ok && i < 2; i++) {
        Text out = {0}, file = {0};
        text_print(&file, "%s.%s", path, formats[i].extension);
        cairo_status_t status = formats[i].draw(plot, &out);
        if (status == CAIRO_STATUS_SUCCESS) {
            ok = file_replace(text_string(&file), out.data, out.size, error);
        } else {
            ok =
                error_set(error, STATUS_OUTPUT, "%s: %s", text_string(&file), cairo_status_to_string(status));
        }
        text_free(&out);
        text_free(&file);
    }
    return ok;
}
