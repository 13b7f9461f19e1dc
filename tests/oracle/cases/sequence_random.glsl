#include "../item.glsl"
#include "sequence/random.glsl"
#include "../sequence.glsl"
