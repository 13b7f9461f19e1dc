#include "gl/strips.h"

#include "base/clock.h"

#include <math.h>
#include <stddef.h>

enum {
    /* Pictures with fewer pixels are not probed: their pieces begin small. */
    PROBED_PIXELS = 1 << 16,
    FIRST_PIXELS = 1 << 10,
    /* The side of a block that is timed, and how far such blocks are apart. */
    PROBE = 16,
    PROBE_DISTANCE = 192,
    /* A piece has at most this many times the pixels of the piece before it, in a picture that is not known.
     */
    GROWTH = 4,
    /* Columns of a part of a row: llvmpipe shades blocks of them together. */
    COLUMNS_STEP = 64
};

/* The time of a piece, and the most that it may take if all of it is like its worst part. */
static const double piece_s = 0.06, worst_piece_s = 0.12;
/* The time from which a piece says what the worst is. */
static const double large_s = 0.02;

static int smaller(int a, int b) {
    return a < b ? a : b;
}

static int larger(int a, int b) {
    return a > b ? a : b;
}

static int band_of(const Pace *pace, int row) {
    return smaller(row * PACE_BANDS / larger(pace->height, 1), PACE_BANDS - 1);
}

static double draw_timed(const Program *program, Pace *pace, int x, int y, int width, int height) {
    double start = clock_seconds();
    program_draw(program, x, y, width, height);
    program->gl->Finish();
    double taken = clock_seconds() - start;
    pace->longest_s = fmax(pace->longest_s, taken);
    pace->draws++;
    return taken;
}

/* Times small blocks all over the picture. Each band of rows takes over the figures of the nearest row of
 * blocks. Only one processor works on a block, so that the figures are rather too long. */
static bool probe(const Strips *strips, Pace *pace) {
    int columns = larger(pace->width / PROBE_DISTANCE, 1), rows = larger(pace->height / PROBE_DISTANCE, 1);
    double unit = (double)PROBE * PROBE * strips->samples, least = 0;
    /* The first draw waits for what was asked for before it, such as emptying the textures. */
    draw_timed(strips->program, pace, 0, 0, PROBE, PROBE);
    for (int r = 0; r < rows; r++) {
        double sum = 0, worst = 0;
        int y = (int)((r + 0.5) * pace->height / rows) - PROBE / 2;
        for (int c = 0; c < columns; c++) {
            int x = (int)((c + 0.5) * pace->width / columns) - PROBE / 2;
            double taken = draw_timed(strips->program, pace, larger(x, 0), larger(y, 0), PROBE, PROBE) / unit;
            /* Another process may have had the processor. */
            for (int again = 0; again < 2 && taken > 2 * least && least > 0; again++)
                taken =
                    fmin(taken,
                         draw_timed(strips->program, pace, larger(x, 0), larger(y, 0), PROBE, PROBE) / unit);
            least = least > 0 ? fmin(least, taken) : taken;
            sum += taken / columns;
            worst = fmax(worst, taken);
            if (strips->stop && strips->stop()) return false;
        }
        for (int b = r * PACE_BANDS / rows; b < (r + 1) * PACE_BANDS / rows; b++)
            pace->mean[b] = sum, pace->worst[b] = worst;
    }
    return true;
}

/* What is known of the rows from this one on. */
typedef struct Speed {
    double mean, worst;
} Speed;

static Speed speed_at(const Pace *pace, int row) {
    int band = band_of(pace, row);
    Speed speed = {pace->mean[band], pace->worst[band]};
    for (int b = larger(band - 1, 0); b <= smaller(band + 1, PACE_BANDS - 1); b++) {
        speed.mean = fmax(speed.mean, pace->mean[b]);
        speed.worst = fmax(speed.worst, pace->worst[b]);
    }
    return speed;
}

/* Notes what a piece took. Its part of a band counts by its size. */
static void note(Pace *pace, const Rectangle *r, double seconds_a_sample, bool large) {
    for (int b = band_of(pace, r->y); b <= band_of(pace, r->y + r->height - 1); b++) {
        double band_pixels = (double)pace->width * pace->height / PACE_BANDS,
               weight = fmin((double)r->width * r->height / band_pixels, 1);
        pace->mean[b] += weight * (seconds_a_sample - pace->mean[b]);
        /* In a short time another process may have had the processor. */
        pace->worst[b] = fmax(large ? seconds_a_sample : pace->mean[b], (1 - 0.5 * weight) * pace->worst[b]);
    }
}

/* The state of a pass. */
typedef struct Progress {
    const Strips *strips;
    Pace *pace;
    /* Whether the pace is that of an earlier pass or of blocks, and else the pixels of the last piece. */
    bool known;
    double last;
} Progress;

/* The next piece of a region, from pixel (x, y) of it on. */
static Rectangle next_piece(const Progress *progress, const Rectangle *region, int x, int y) {
    const Pace *pace = progress->pace;
    Speed speed = speed_at(pace, region->y + y);
    /* The mean of a band is that of whole rows. */
    double a_sample = region->width < pace->width ? speed.worst : speed.mean;
    double samples = (double)progress->strips->samples;
    double pixels =
        fmin(piece_s / fmax(a_sample * samples, 1e-12), worst_piece_s / fmax(speed.worst * samples, 1e-12));
    if (!progress->known) pixels = fmin(pixels, progress->last > 0 ? GROWTH * progress->last : FIRST_PIXELS);
    double rows = floor(pixels / region->width);
    if (x == 0 && (rows >= 1 || region->width <= COLUMNS_STEP)) {
        /* A power of two suits the tiles of drivers. */
        int wanted = 1;
        while (2.0 * wanted <= rows && wanted < region->height) wanted *= 2;
        return (Rectangle){region->x, region->y + y, region->width, smaller(wanted, region->height - y)};
    }
    int columns = (int)fmin(fmax(floor(pixels / COLUMNS_STEP), 1) * COLUMNS_STEP, region->width - x);
    return (Rectangle){region->x + x, region->y + y, columns, 1};
}

static bool draw_region(Progress *progress, const Rectangle *region) {
    const Strips *strips = progress->strips;
    for (int x = 0, y = 0; y < region->height;) {
        Rectangle r = next_piece(progress, region, x, y);
        double pixels = (double)r.width * r.height,
               taken = draw_timed(strips->program, progress->pace, r.x, r.y, r.width, r.height);
        note(progress->pace, &r, taken / (pixels * strips->samples), taken > large_s);
        progress->last = pixels;
        x = x + r.width < region->width ? x + r.width : 0;
        y += x ? 0 : r.height;
        if (y < region->height && strips->stop && strips->stop()) return false;
    }
    return true;
}

/* Regions that are drawn in one go, because each alone is a small piece. Returns their number. */
static int draw_small(Progress *progress, int first) {
    const Strips *strips = progress->strips;
    double due = 0;
    int count = 0;
    for (int i = first; i < strips->count; i++) {
        const Rectangle *r = &strips->regions[i];
        double pixels = (double)r->width * r->height;
        due += speed_at(progress->pace, r->y).worst * strips->samples * pixels;
        if (due > piece_s) break;
        count++;
    }
    if (count < 2 || !progress->known) return 0;
    double start = clock_seconds(), pixels = 0;
    for (int i = first; i < first + count; i++) {
        const Rectangle *r = &strips->regions[i];
        program_draw(strips->program, r->x, r->y, r->width, r->height);
        pixels += (double)r->width * r->height;
    }
    strips->program->gl->Finish();
    double taken = clock_seconds() - start;
    progress->pace->longest_s = fmax(progress->pace->longest_s, taken);
    for (int i = first; i < first + count; i++)
        note(progress->pace, &strips->regions[i], taken / (pixels * strips->samples), taken > large_s);
    progress->pace->draws += count;
    return count;
}

void pace_set(Pace *pace, int width, int height, double seconds) {
    *pace = (Pace){.width = width, .height = height};
    for (int b = 0; b < PACE_BANDS; b++) pace->mean[b] = pace->worst[b] = seconds;
}

bool strips_draw(const Strips *strips, Pace *pace) {
    const Rectangle *all = &strips->picture;
    bool known = pace->width == all->width && pace->height == all->height;
    Progress progress = {.strips = strips, .pace = pace, .known = known};
    if (!known) {
        *pace = (Pace){.longest_s = pace->longest_s, .draws = pace->draws};
        Pace next = *pace;
        next.width = all->width, next.height = all->height;
        /* Outside of its regions, a pass leaves the picture as it is. */
        bool whole = strips->count == 1 && strips->regions[0].width == all->width &&
                     strips->regions[0].height == all->height;
        progress.known = whole && (double)all->width * all->height >= PROBED_PIXELS;
        if (progress.known && !probe(strips, &next)) return false;
        *pace = next;
    }
    for (int i = 0; i < strips->count;) {
        int small = draw_small(&progress, i);
        if (!small && !draw_region(&progress, &strips->regions[i])) return false;
        i += small ? small : 1;
        if (i < strips->count && strips->stop && strips->stop()) return false;
    }
    return true;
}

/* Rows that are shaded together: llvmpipe shades blocks of two rows, and of four. */
static int whole_blocks(double wanted, int rows_left) {
    double rows = wanted < 4 ? 2 : 4 * floor(wanted / 4);
    return rows < rows_left ? (int)rows : rows_left;
}

void strips_draw_for(const Program *program, int width, int height, int *row, double *pixels_per_second,
                     double seconds, bool (*stop)(void)) {
    double end = clock_seconds() + seconds, left = seconds;
    do {
        double start = clock_seconds(),
               wanted = *pixels_per_second * fmin(fmin(left, seconds / 3), 0.1) / width;
        int rows = whole_blocks(wanted, height - *row);
        /* Two rows may take long. */
        int columns = (int)fmin(fmax(0.1 * *pixels_per_second / rows, COLUMNS_STEP), width);
        for (int x = 0; x < width; x += columns) {
            program_draw(program, x, *row, smaller(columns, width - x), rows);
            program->gl->Finish();
        }
        *pixels_per_second = (double)rows * width / fmax(clock_seconds() - start, 1e-6);
        *row += rows;
        left = end - clock_seconds();
    } while (*row < height && left > 0.1 * seconds && !(stop && stop()));
}
