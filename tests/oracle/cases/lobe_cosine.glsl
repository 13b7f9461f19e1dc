#include "../item.glsl"
#include "sequence/random.glsl"
#include "light/cosine.glsl"
#include "../lobe.glsl"
