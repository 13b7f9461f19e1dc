// The functions by which a path gets light from surfaces that emit. The files of this folder define them: none, chance, sampled.
#include "scene.glsl"

// The radiance that a ray brings from its hit, if it has one: the given share of what is emitted there.
vec3 emission_met(Hit hit, vec3 incoming, float share);

// Whether rays are sent toward emitters. It is a constant, so that the two functions below cost nothing where they are not.
bool emission_sought();

// A direction from `hit` in which something may emit.
vec3 emission_direction(Hit hit, INOUT(Sequence) sequence);

// The radiance that `hit` reflects from that direction, without the share that is left to bounces. Bounces take the direction with
// the density `bounce_pdf`, 1/sr.
vec3 emission_reflected(Hit hit, Material material, vec3 incoming, vec3 direction, float bounce_pdf);

// The share of the emitted light that is left to a bounce.
float emission_share(Hit hit, Bounce bounce);
