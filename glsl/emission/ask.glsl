// What a path asks about surfaces that emit. The files beside this one answer: none, chance, sampled.
#include "scene.glsl"

// Radiance that a ray brings from its hit, if there is one: the given share of what is emitted there.
vec3 emission_met(Hit hit, vec3 incoming, float share);

// A direction from `hit` in which something may emit.
vec3 emission_direction(Hit hit, INOUT(Sequence) sequence);

// Radiance that `hit` reflects from that direction, the share of it that is not left to bounces; these take the direction with the
// density `bounce_pdf`, 1/sr.
vec3 emission_reflected(Hit hit, Material material, vec3 incoming, vec3 direction, float bounce_pdf);

// The share that is left to a bounce.
float emission_share(Hit hit, Bounce bounce);
