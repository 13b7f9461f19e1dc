// The author's bounce under the paper's sky.
#include "../inputs.glsl"
#include "sequence/random.glsl"
#include "sun/off.glsl"
#include "emission/none.glsl"
#include "mist/none.glsl"
#include "light/paper.glsl"
#include "../paper_sky.glsl"
#include "../crater.glsl"
