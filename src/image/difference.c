#include "image/difference.h"

#include "image/label.h"
#include "image/levels.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* In pixels: between panels, the width of the scale's bar, and the room of its labels "+255". */
enum { GAP = 8, BAR = 16, TEXT_SCALE = 2, LABELS = 4 * LABEL_ADVANCE * TEXT_SCALE };

/* The line of titles above the panels. */
enum { TITLE = LABEL_HEIGHT * TEXT_SCALE + GAP };

/* So high is the picture at least, that the scale's labels do not touch. */
enum { HEIGHT_LEAST = 64 };

static const double range_steps[] = {1, 2, 5, 10, 20, 50, 100, 255};

double difference_at(const DifferenceParams *params, int x, int y) {
    size_t i = 4 * ((size_t)y * (size_t)params->b->width + (size_t)x);
    double squares = 0, sum = 0;
    for (size_t c = 0; c < 3; c++) {
        double difference = image_level(params->a, i + c, params->tone, params->exposure_ev) -
                            image_level(params->b, i + c, params->tone, params->exposure_ev);
        squares += difference * difference;
        sum += difference;
    }
    double size = sqrt(squares / 3);
    return sum < 0 ? -size : size;
}

static bool is_compared(const DifferenceParams *params, int x, int y) {
    return params->compared[(size_t)y * (size_t)params->b->width + (size_t)x];
}

double difference_range(const DifferenceParams *params) {
    enum { STEPS = sizeof range_steps / sizeof *range_steps };
    long above[STEPS] = {0}, count = 0;
    for (int y = 0; y < params->b->height; y++) {
        for (int x = 0; x < params->b->width; x++) {
            if (!is_compared(params, x, y)) continue;
            double size = fabs(difference_at(params, x, y));
            for (int i = 0; i < STEPS; i++) above[i] += size > range_steps[i];
            count++;
        }
    }
    int i = 0;
    while (i < STEPS - 1 && (double)above[i] > 0.01 * (double)count) i++;
    return range_steps[i];
}

/* Moreland's diverging colours, at -1 to 1. */
static void colour_fill(double t, float *pixel) {
    static const double ends[2][3] = {{0.230, 0.299, 0.754}, {0.706, 0.016, 0.150}};
    t = fmin(fmax(t, -1), 1);
    for (int c = 0; c < 3; c++) {
        double coded = 0.865 + fabs(t) * (ends[t > 0][c] - 0.865);
        pixel[c] = (float)tone_light_of_level(255 * coded);
    }
}

static float *pixel_at(Image *image, int x, int y) {
    return image->rgba + 4 * ((size_t)y * (size_t)image->width + (size_t)x);
}

static bool is_finite(const Image *image, int x, int y) {
    const float *pixel = image->rgba + 4 * ((size_t)y * (size_t)image->width + (size_t)x);
    return isfinite(pixel[0]) && isfinite(pixel[1]) && isfinite(pixel[2]);
}

static void difference_draw(const DifferenceParams *params, double range, Image *image, int left, int top) {
    for (int y = 0; y < params->b->height; y++) {
        for (int x = 0; x < params->b->width; x++) {
            float *pixel = pixel_at(image, left + x, top + y);
            if (is_compared(params, x, y)) {
                colour_fill(difference_at(params, x, y) / range, pixel);
            } else {
                float yellow = is_finite(params->a, x, y) && is_finite(params->b, x, y) ? 0 : 1;
                pixel[0] = pixel[1] = yellow;
                pixel[2] = 0;
            }
        }
    }
}

/* The bar, as high as the picture is at least, with the differences at its ends and in its middle. */
static void scale_draw(double range, int height, Image *image, int left, int top) {
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < BAR; x++)
            colour_fill(1 - 2 * (y + 0.5) / height, pixel_at(image, left + x, top + y));
    }
    for (int i = 0; i < 3; i++) {
        char text[16];
        snprintf(text, sizeof text, i == 1 ? "0" : "%+.0f", range * (1 - i));
        label_draw(image, text, left + BAR + GAP / 2, top + i * (height - LABEL_HEIGHT * TEXT_SCALE) / 2,
                   TEXT_SCALE, 0);
    }
}

static void picture_draw(const DifferenceParams *params, const Image *from, Image *image, int left, int top) {
    for (int y = 0; y < from->height; y++) {
        for (int x = 0; x < from->width; x++) {
            size_t i = 4 * ((size_t)y * (size_t)from->width + (size_t)x);
            for (size_t c = 0; c < 3; c++) {
                double level = image_level(from, i + c, params->tone, params->exposure_ev);
                pixel_at(image, left + x, top + y)[c] = (float)tone_light_of_level(level);
            }
        }
    }
}

enum { PANEL_A, PANEL_B, PANEL_DIFFERENCE, PANELS };

/* The panels from `first` on with their titles, and the scale behind the last, which is the difference. */
static Image panels_draw(const DifferenceParams *params, int first) {
    static const char *const titles[PANELS] = {"A", "B", "A-B LEVELS"};
    int width = params->b->width,
        height = params->b->height > HEIGHT_LEAST ? params->b->height : HEIGHT_LEAST;
    int titled = (int)strlen(titles[PANEL_DIFFERENCE]) * LABEL_ADVANCE * TEXT_SCALE, step = width + GAP;
    int scaled = width + GAP + BAR + GAP / 2 + LABELS, last = GAP + (PANEL_DIFFERENCE - first) * step;
    Image image = image_create(last + (scaled > titled ? scaled : titled) + GAP, GAP + TITLE + height + GAP);
    image.shown = true;
    size_t values = 4 * (size_t)image.width * (size_t)image.height;
    for (size_t i = 0; i < values; i++) image.rgba[i] = 1;
    double range = difference_range(params);
    for (int panel = first; panel < PANELS; panel++) {
        int left = GAP + (panel - first) * step;
        label_draw(&image, titles[panel], left, GAP, TEXT_SCALE, 0);
        if (panel == PANEL_DIFFERENCE)
            difference_draw(params, range, &image, left, GAP + TITLE);
        else
            picture_draw(params, panel == PANEL_A ? params->a : params->b, &image, left, GAP + TITLE);
    }
    scale_draw(range, height, &image, last + width + GAP, GAP + TITLE);
    return image;
}

Image difference_picture(const DifferenceParams *params) {
    return panels_draw(params, PANEL_DIFFERENCE);
}

Image difference_side_by_side(const DifferenceParams *params) {
    return panels_draw(params, PANEL_A);
}
