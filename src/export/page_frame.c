#include "export/page_frame.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

/* The tables' uniforms are collected as resources_uniforms() would, before there are tables. */
static PageFrame frame_at(const PageScan *scan, double elevation_deg) {
    RenderParams params = *scan->params;
    Scene scene = *params.scene;
    PageFrame out = {0};
    scene_set_sun(&scene, elevation_deg, scene.values.sun.azimuth_deg);
    params.scene = &scene;
    params.use = scan->coarse ? PICTURE_PREVIEW : PICTURE_FILE;
    Camera camera = camera_of(&scene, plan_width(&params), plan_height(&params));
    Frame frame = frame_of(scan->plan, &params, &camera);
    frame_uniforms(&frame, scan->plan, params.seed, &out.uniforms);
    for (int i = 0; picture_tables[i]; i++) {
        const ResourceKind *kind = picture_tables[i];
        out.from[i] = out.upto[i] = out.uniforms.count;
        if (!resource_is_needed(kind, picture_tables, &frame)) continue;
        if (kind->uniforms) kind->uniforms(NULL, &frame, &out.uniforms);
        if (kind->size) kind->size(&frame, &out.width[i], &out.height[i]);
        out.upto[i] = out.uniforms.count;
    }
    return out;
}

PageScan page_scan(const Plan *plan, const RenderParams *params, bool coarse) {
    PageScan scan = {plan, params, coarse, memory_get(PAGE_FRAMES, sizeof(PageFrame))};
    for (int i = 0; i < PAGE_FRAMES; i++) scan.frames[i] = frame_at(&scan, -90 + i * PAGE_STEP_DEG);
    return scan;
}

void page_scan_free(PageScan *scan) {
    for (int i = 0; i < PAGE_FRAMES; i++) uniforms_free(&scan->frames[i].uniforms);
    free(scan->frames);
    *scan = (PageScan){0};
}

/* The lowest elevation, above that of frame i - 1, at which the entry is as in frame i. */
static double change_before(const PageScan *scan, int i, int entry, PageSame *same) {
    double low = -90 + (i - 1) * PAGE_STEP_DEG, high = low + PAGE_STEP_DEG;
    while (high - low > 1e-4) {
        double middle = (low + high) / 2;
        PageFrame frame = frame_at(scan, middle);
        *(same(entry, &frame, &scan->frames[i]) ? &high : &low) = middle;
        uniforms_free(&frame.uniforms);
    }
    return high;
}

int page_scan_steps(const PageScan *scan, int entry, PageSame *same, int most, double *from,
                    const PageFrame **frames) {
    int count = 1;
    from[0] = -90;
    frames[0] = &scan->frames[0];
    for (int i = 1; i < PAGE_FRAMES; i++) {
        if (same(entry, &scan->frames[i - 1], &scan->frames[i])) continue;
        if (count == most) return 0;
        from[count] = change_before(scan, i, entry, same);
        frames[count++] = &scan->frames[i];
    }
    return count;
}
