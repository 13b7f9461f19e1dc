/* What the scene's mist puts into the programs' texts. */
#pragma once

#include "scene/scene.h"
#include "source/glsl_slots.h"

/* Fills the slots of glsl/mist/. */
void mist_slots(SlotList *slots, const Scene *scene);
