// For a scene that does not name its emitters: only the bounces find them.
#include "emission/met.glsl"
#include "emission/unsought.glsl"
