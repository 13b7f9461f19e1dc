// Which share of the sun's light a path counts itself, where light tracing counts the rest.
//
// Light that glass or metal throws on another surface is found in two ways: by a path from the camera that happens to meet the sun, and by a path
// from the sun that is joined to the camera (pass/photons.glsl). Each counts the share 1 / (1 + R) or R / (1 + R) of it, where R is how many light
// paths are expected there for each path from the camera: the balance heuristic (Veach 1997). The two shares add up to 1 for every path, so the
// picture is the same whatever the numbers are.
//
// R is a product over the path's hits that scatter. A path from the camera chooses a solid angle at each of them, a path from the sun chooses another
// one, and the two beams between neighbouring hits have the same etendue: area times cosine times solid angle. So the distances cancel, and so do
// mirrors and glass on the way. What is left of each hit is the density of the one bounce over that of the other, and two cosines.
#include "sun/ask.glsl"

// The share of the light that comes from the sun, in the direction `toward`, straight to a hit. `traced` is SunState.traced before the hit.
float sun_share_reflected(float traced, Hit hit, Material material, vec3 incoming, vec3 toward);

// The next value of SunState.traced.
float sun_traced(SunState state, Hit hit, Material material, vec3 incoming, Bounce bounce);
