#include "render/mist.h"

static const char *const regions[] = {
    [MIST_EVERYWHERE] = "mist/region_everywhere.glsl",
    [MIST_SPHERE] = "mist/region_sphere.glsl",
    [MIST_BOX] = "mist/region_box.glsl",
    [MIST_BELOW] = "mist/region_below.glsl",
};

void mist_slots(SlotList *slots, const Scene *scene) {
    const Mist *mist = &scene->file->mist;
    Text values = {0};
    if (!scene_has_mist(scene)) {
        slot_file(slots, "mist", "mist/none.glsl");
        return;
    }
    mist_write(mist, &values);
    slot_text(slots, "mist-values", text_string(&values));
    text_free(&values);
    slot_file(slots, "mist", "pass/mist.glsl");
    slot_file(slots, "mist-density", mist->falls ? "mist/height.glsl" : "mist/homogeneous.glsl");
    slot_file(slots, "mist-tracks",
              scene->file->facts.makes_mist ? "mist/function.glsl" : "mist/closed.glsl");
    slot_file(slots, "mist-region", regions[mist->shape]);
    slot_file(slots, "mist-phase", mist->shanks ? "mist/phase_shanks.glsl" : "mist/phase_henyey.glsl");
}
