/* What a page sets from its data: the uniforms of a picture and the sizes of its tables, as they are for each
 * position of the sun. */
#pragma once

#include "render/passes.h"

/* The uniforms of a frame and of each of its tables, in the order in which they are set, and the tables'
 * sizes. */
typedef struct PageFrame {
    Uniforms uniforms;
    /* By the tables' places in picture_tables: how many uniforms there are before the table's own and with
     * them, and its size. */
    int from[MOST_RESOURCES], upto[MOST_RESOURCES];
    int width[MOST_RESOURCES], height[MOST_RESOURCES];
} PageFrame;

/* Whether the page's script sets the uniform from the sun, the camera, the picture or the mist
 * (page_draw.js). A scene's own uniforms are the sliders, which it sets too. */
bool page_computes(const Uniform *uniform);

/* Frames with the sun at -90 degrees, at 90, and in steps of PAGE_STEP_DEG between. */
#define PAGE_STEP_DEG 0.25
enum { PAGE_FRAMES = 721 };

/* All frames of a plan. `coarse` is of a preview. */
typedef struct PageScan {
    const Plan *plan;
    const RenderParams *params;
    bool coarse;
    PageFrame *frames;
} PageScan;

PageScan page_scan(const Plan *plan, const RenderParams *params, bool coarse);
void page_scan_free(PageScan *scan);

/* The frame with the sun at one elevation; its uniforms are to be freed. */
PageFrame page_frame_at(const PageScan *scan, double elevation_deg);

/* Whether an entry, such as a uniform by its number, is the same in two frames. */
typedef bool PageSame(int entry, const PageFrame *a, const PageFrame *b);

/* A PageSame of a uniform by its number, to the bit. */
bool page_same_uniform(int entry, const PageFrame *a, const PageFrame *b);

/* Whether two values of uniforms are the same to the bit. */
bool page_same_values(const Uniform *a, const Uniform *b);

/* The elevations at which an entry changes, to a ten-thousandth of a degree, upward: fills `from` and
 * `frames` (the first is -90 degrees) and returns how many there are, or 0 if there are more than `most`. The
 * frames at these elevations are borrowed from the scan. */
int page_scan_steps(const PageScan *scan, int entry, PageSame *same, int most, double *from,
                    const PageFrame **frames);

/* The name of a uniform that the host would compute anew where a slider is moved, or NULL; `slider` is set to
 * its name. A page has its value as it is now. */
const char *page_scan_slider(const PageScan *scan, PageSame *same, const char **slider);
