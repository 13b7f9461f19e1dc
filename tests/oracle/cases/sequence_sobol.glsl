#include "../item.glsl"
#include "sequence/sobol.glsl"
#include "../sequence.glsl"
