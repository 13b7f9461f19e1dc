#include "view/figures.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

void curve_extend(ErrorCurve *curve, double seconds, double percent) {
    /* The estimate is 0 for a constant picture, and a logarithmic axis has no place for it. */
    if (!(percent > 0) || !isfinite(percent)) return;
    bool near = curve->count && seconds < 1.05 * curve->seconds[curve->count - 1];
    if (near) return;
    /* Every other point is enough for the past. */
    if (curve->count == MOST_CURVE) {
        for (int i = 0; i < MOST_CURVE / 2; i++) {
            curve->seconds[i] = curve->seconds[2 * i];
            curve->percent[i] = curve->percent[2 * i];
        }
        curve->count = MOST_CURVE / 2;
    }
    curve->seconds[curve->count] = seconds;
    curve->percent[curve->count++] = percent;
}

void curve_place(const ErrorCurve *curve, int point, double place[2]) {
    double first = log(curve->seconds[0]), last = log(curve->seconds[curve->count - 1]);
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < curve->count; i++) {
        low = fmin(low, log(curve->percent[i]));
        high = fmax(high, log(curve->percent[i]));
    }
    place[0] = (log(curve->seconds[point]) - first) / fmax(last - first, 1e-3);
    place[1] = (high - log(curve->percent[point])) / fmax(high - low, 1e-3);
}

void figures_progress(const SideFigures *side, char *text, size_t size) {
    if (side->prepared < 1)
        snprintf(text, size, "computing the sky, %.0f %%", floor(100 * side->prepared));
    else if (side->coarseness > 1)
        snprintf(text, size, "preview, 1/%d of the size", side->coarseness);
    else if (!side->samples)
        snprintf(text, size, "first samples, %.1f s", side->seconds);
    else
        snprintf(text, size, "%" PRIu64 " samples in %.1f s", side->samples, side->seconds);
}

void figures_error(const SideFigures *side, char *text, size_t size) {
    if (isfinite(side->error_percent))
        snprintf(text, size, "error about %.2f %%", side->error_percent);
    else
        snprintf(text, size, "error not yet known");
}

void figures_levels(const SideFigures *side, char *text, size_t size) {
    *text = 0;
    if (isfinite(side->error_levels))
        snprintf(text, size, "%.2g of 255 levels, %.2g in the worst tile", side->error_levels,
                 side->worst_levels);
}

void figures_side(const SideFigures *side, char *text, size_t size) {
    char progress[64], error[64], levels[64];
    figures_progress(side, progress, sizeof progress);
    figures_error(side, error, sizeof error);
    figures_levels(side, levels, sizeof levels);
    snprintf(text, size, "%s\n%s, %.1f Mpaths/s\n%s%s%s", side->methods, progress,
             1e-6 * side->paths_per_second, error, *levels ? "\n" : "", levels);
}

/* What a Shadertoy program has: no error, and no sun. */
static int bar_parts(const ViewFigures *figures, const Sun *sun, char parts[4][64]) {
    const SideFigures *side = &figures->sides[0];
    const size_t size = sizeof parts[0];
    double fps = figures->frame_mean_s > 0 ? 1 / figures->frame_mean_s : 0;
    snprintf(parts[3], size, "%.0f fps", fps);
    if (!figures->scene) {
        snprintf(parts[0], size, "frame %" PRIu64, side->samples);
        memcpy(parts[1], parts[3], size);
        return 2;
    }
    figures_progress(side, parts[0], size);
    if (isfinite(side->error_percent))
        snprintf(parts[1], size, "error %.2f %%", side->error_percent);
    else
        snprintf(parts[1], size, "error -");
    snprintf(parts[2], size, "sun %.4g %.4g", sun->elevation_deg, sun->azimuth_deg);
    return 4;
}

void figures_bar(const ViewFigures *figures, const Sun *sun, int most, char *text, size_t size) {
    char parts[4][64];
    int count = bar_parts(figures, sun, parts), length = 0;
    *text = 0;
    for (int i = 0; i < count; i++) {
        int more = (int)strlen(parts[i]) + (i ? 3 : 0);
        if (length + more > most || length + more >= (int)size) continue;
        length += snprintf(text + length, size - (size_t)length, "%s%s", i ? "   " : "", parts[i]);
    }
}

void figures_pixel(const PixelFigures *pixel, char *text, size_t size) {
    static const char *const places[] = {"", ", left side", ", right side"};
    char depth[32] = "none";
    if (pixel->hits > 0) snprintf(depth, sizeof depth, "%.4g m", pixel->depth);
    snprintf(text, size,
             "pixel %d %d%s\n"
             "radiance  %.4g  %.4g  %.4g\n"
             "error     %.2g %% of it, %.0f samples\n"
             "albedo    %.3f  %.3f  %.3f\n"
             "depth     %s",
             pixel->x, pixel->y, places[pixel->place], pixel->radiance[0], pixel->radiance[1],
             pixel->radiance[2], pixel->error_percent, pixel->samples, pixel->albedo[0], pixel->albedo[1],
             pixel->albedo[2], depth);
}
