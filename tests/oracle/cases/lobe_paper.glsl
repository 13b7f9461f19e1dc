#include "../item.glsl"
#include "sequence/random.glsl"
#include "light/paper.glsl"
#include "../lobe.glsl"
