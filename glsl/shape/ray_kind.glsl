// What a path tells the searches of its next ray. Rays that nobody speaks of, such as those of the camera and those toward lamps and the sun, have the values
// below.

// Half the angle in which the rays of similar paths lie, in radians, from 0 to 1. What such a ray finds is averaged over the whole cone.
float ray_spread = 0.0;
// The object whose outer side the ray leaves, or -1. The ray cannot begin within this object.
int ray_leaves = -1;
