// Lambert's surfaces under the paper's sky.
#include "../inputs.glsl"
#include "sequence/sobol.glsl"
#include "sun/off.glsl"
#include "emission/none.glsl"
#include "mist/none.glsl"
#include "light/cosine.glsl"
#include "../paper_sky.glsl"
#include "../crater.glsl"
