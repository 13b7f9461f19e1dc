/* What the scene's mist, or its air, puts into the programs' texts. */
#pragma once

#include "render/plan.h"
#include "scene/scene.h"
#include "source/glsl_slots.h"

/* Fills the slots of glsl/mist/. */
void mist_slots(SlotList *slots, const Plan *plan, const Scene *scene);
