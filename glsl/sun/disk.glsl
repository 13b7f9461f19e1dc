// The sun's disk as the files beside this one ask for it. pass/sun_disk.glsl knows where it stands and how bright it is.

// Radiance along a direction; 0 off the disk and below the horizon.
vec3 sun_radiance(vec3 direction);

// A direction uniform in the disk, from u in [0,1)^2.
vec3 sun_point(vec2 u);

// The disk's, sr: one over the density of those directions.
float sun_solid_angle();

// Radiance along a direction if the disk's light came evenly from a wide cone about it.
vec3 sun_spread(vec3 direction);
