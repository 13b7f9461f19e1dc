#include "export/page_stand.h"

#include "render/spheres.h"
#include "sky/sky_sampler.h"
#include "sky/sun.h"

const PageStand *page_stand_of(const ResourceKind *kind) {
    static const PageStand stands[] = {
        {.kind = &sun_table, .entry = "pass/fill_sun.glsl", .width = 256, .height = 1},
        {.kind = &sun_cover, .entry = "pass/fill_cover.glsl", .sized = "cover"},
        {.kind = &sky_sampler, .maker = "sky_sampler"},
        {.kind = &drawn_spheres, .entry = "pass/fill_spheres.glsl", .sized = "spheres"},
        {.kind = &scene_spheres, .maker = "sphere_tree"}};
    for (size_t i = 0; i < sizeof stands / sizeof *stands; i++)
        if (stands[i].kind == kind) return &stands[i];
    return NULL;
}
