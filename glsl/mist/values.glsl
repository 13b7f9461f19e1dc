// What the scene's annotation says of its mist. The host writes these functions (src/scene/mist.h); they read the scene's sliders.
#include "math/dialect.glsl"

// 1/m; where the mist thins with height, the extinction at the height mist_base().
float mist_extinction();

// The extinction of each channel over that, which is the largest. 1 where the extinction has no colour.
vec3 mist_tint();

// The share of the light that is scattered, of the light that is scattered or absorbed.
vec3 mist_albedo();

// The mean cosine of the angle by which light is turned: above 0, most of it goes on forward.
float mist_forward();

// The height in metres in which the mist thins to 1/e, and the height at which it has the extinction that is stated.
float mist_falloff();
float mist_base();

// The region: a sphere's centre, and its radius in each component; a box's centre and half size; a height below which the mist lies, as y.
vec3 mist_middle();
vec3 mist_reach();
