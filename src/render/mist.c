#include "render/mist.h"

#include "sky/scattered.h"

#include <stdio.h>

static const char *const regions[] = {
    [MIST_EVERYWHERE] = "mist/region_everywhere.glsl",
    [MIST_SPHERE] = "mist/region_sphere.glsl",
    [MIST_BOX] = "mist/region_box.glsl",
    [MIST_BELOW] = "mist/region_below.glsl",
};

/* Air that the sky's own light comes from is lit by the sun, and scatters light as often as the sky's air.
 * With any other sky it is lit by that, and by the sun if its disk shines. */
static void air_slots(SlotList *slots, const Plan *plan, const Scene *scene) {
    char light[96];
    bool of_sky = plan->sky.method->integrates;
    bool again = !of_sky || scene->values.atmosphere.orders > 1;
    bool sunlit = of_sky || plan->sun.method->has_disk;
    snprintf(light, sizeof light, "const bool AIR_SCATTERS_AGAIN = %s;\nconst bool AIR_SUNLIT = %s;",
             again ? "true" : "false", sunlit ? "true" : "false");
    slot_text(slots, "air-light", light);
    slot_file(slots, "mist", "pass/air.glsl");
}

void mist_slots(SlotList *slots, const Plan *plan, const Scene *scene) {
    const Mist *mist = &scene->file->mist;
    Text values = {0};
    if (plan->air) {
        air_slots(slots, plan, scene);
        return;
    }
    if (!scene_has_mist(scene)) {
        slot_file(slots, "mist", "mist/none.glsl");
        return;
    }
    mist_write(mist, &values);
    slot_text(slots, "mist-values", text_string(&values));
    text_free(&values);
    slot_file(slots, "mist", "pass/mist.glsl");
    slot_file(slots, "mist-density", mist->falls ? "mist/height.glsl" : "mist/homogeneous.glsl");
    static const char *const tracks[2][2] = {{"mist/closed.glsl", "mist/coloured.glsl"},
                                             {"mist/function.glsl", "mist/function_coloured.glsl"}};
    slot_file(slots, "mist-tracks", tracks[scene->file->facts.makes_mist][mist_is_coloured(mist)]);
    slot_file(slots, "mist-region", regions[mist->shape]);
    /* A method that takes the open sky as known is for open scenes. */
    slot_text(slots, "mist-open",
              plan->light.method->needs_irradiance ? "const bool MIST_IN_OPEN = true;"
                                                   : "const bool MIST_IN_OPEN = false;");
    slot_file(slots, "mist-sky",
              sky_is_scattered(&plan->sky, scene) ? "pass/mist_sky.glsl" : "mist/sky_none.glsl");
    slot_file(slots, "mist-phase", mist->shanks ? "mist/phase_shanks.glsl" : "mist/phase_henyey.glsl");
}
