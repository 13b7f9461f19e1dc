// --light cosine: Lambert's matte surfaces, bounced by the cosine; no light sampling.
#include "light/bounce_material.glsl"
#include "light/lambert.glsl"
#include "light/path.glsl"
