#include "export/page_frame.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool page_computes(const Uniform *uniform) {
    static const char *const names[] = {"sun_direction",
                                        "sun_level",
                                        "sun_disk_middle",
                                        "sun_disk_heights",
                                        "sun_image_corner",
                                        "sun_image_heart",
                                        "camera_eye",
                                        "camera_forward",
                                        "camera_right",
                                        "camera_up",
                                        "picture_size",
                                        "iResolution",
                                        "seed",
                                        "film_first",
                                        "scattered_forward",
                                        "scattered_share",
                                        "spheres_count",
                                        "fill_count"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(uniform->name, names[i]) == 0) return true;
    return !uniform->file;
}

/* The tables' uniforms are collected as resources_uniforms() would, before there are tables. */
static PageFrame frame_of_scene(const PageScan *scan, const Scene *of) {
    RenderParams params = *scan->params;
    Scene scene = *of;
    PageFrame out = {0};
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

PageFrame page_frame_at(const PageScan *scan, double elevation_deg) {
    Scene scene = *scan->params->scene;
    scene_set_sun(&scene, elevation_deg, scene.values.sun.azimuth_deg);
    return frame_of_scene(scan, &scene);
}

PageScan page_scan(const Plan *plan, const RenderParams *params, bool coarse) {
    PageScan scan = {plan, params, coarse, memory_get(PAGE_FRAMES, sizeof(PageFrame))};
    for (int i = 0; i < PAGE_FRAMES; i++) scan.frames[i] = page_frame_at(&scan, -90 + i * PAGE_STEP_DEG);
    return scan;
}

void page_scan_free(PageScan *scan) {
    for (int i = 0; i < PAGE_FRAMES; i++) uniforms_free(&scan->frames[i].uniforms);
    free(scan->frames);
    *scan = (PageScan){0};
}

bool page_same_values(const Uniform *p, const Uniform *q) {
    if (p->count != q->count || memcmp(p->values, q->values, sizeof p->values) != 0) return false;
    return p->type != UNIFORM_FLOATS || memcmp(p->many, q->many, (size_t)p->count * sizeof *p->many) == 0;
}

bool page_same_uniform(int entry, const PageFrame *a, const PageFrame *b) {
    return page_same_values(&a->uniforms.items[entry], &b->uniforms.items[entry]);
}

/* The lowest elevation, above that of frame i - 1, at which the entry is as in frame i. */
static double change_before(const PageScan *scan, int i, int entry, PageSame *same) {
    double low = -90 + (i - 1) * PAGE_STEP_DEG, high = low + PAGE_STEP_DEG;
    while (high - low > 1e-4) {
        double middle = (low + high) / 2;
        PageFrame frame = page_frame_at(scan, middle);
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

/* The first uniform of the library's that has other values in the scene than in `frame`. */
static const char *other_uniform(const PageScan *scan, const Scene *scene, const PageFrame *frame,
                                 PageSame *same) {
    PageFrame moved = frame_of_scene(scan, scene);
    const char *name = NULL;
    for (int i = 0; i < frame->uniforms.count && !name; i++)
        if (!same(i, frame, &moved)) name = frame->uniforms.items[i].name;
    uniforms_free(&moved.uniforms);
    return name;
}

const char *page_scan_slider(const PageScan *scan, PageSame *same, const char **slider) {
    const Scene *scene = scan->params->scene;
    PageFrame frame = frame_of_scene(scan, scene);
    const char *name = NULL;
    for (int i = 0; i < scene->file->parameter_count && !name; i++) {
        const Parameter *parameter = &scene->file->parameters[i];
        Scene moved = *scene;
        double *value = moved.values.parameters[i];
        if (parameter->type != PARAMETER_SLIDER) continue;
        *slider = parameter->name;
        *value = *value < parameter->max ? parameter->max : parameter->min;
        name = other_uniform(scan, &moved, &frame, same);
    }
    uniforms_free(&frame.uniforms);
    return name;
}
