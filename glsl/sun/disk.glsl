// The sun's disk, as the files of this folder use it. pass/sun_disk.glsl defines its position and brightness.

// The radiance along a direction. It is 0 off the disk and below the horizon.
vec3 sun_radiance(vec3 direction);

// A direction uniform in the disk, from u in [0,1)^2.
vec3 sun_point(vec2 u);

// The disk's solid angle, sr. It is one over the density of the directions of sun_point().
float sun_solid_angle();

// Toward the disk's middle, a unit vector.
vec3 sun_middle();

// The irradiance of a surface that faces the disk.
vec3 sun_irradiance();

// The solid angle, sr, of the wide cone around the disk that stands for the disk where light is left to chance.
float sun_near_solid_angle();

// Whether a direction is in that cone.
bool sun_is_near(vec3 direction);
