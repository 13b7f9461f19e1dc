#include "math/dialect.glsl"

// Solids that are deformed about the origin, as distance_box(op_twist(p, rate), ...). The field changes faster than the distance then. Divide it by
// the steepness, which is the most within `radius` of the axis: the radius has to reach over the solid and wherever rays are marched.
// march(ray, centre, radius, ...) keeps the march within reach.

// Turns each plane at right angles to the y axis about it, by `rate` radians for each metre of height, counter-clockwise as seen from above.
vec3 op_twist(vec3 p, float rate) {
    float c = cos(rate * p.y);
    float s = sin(rate * p.y);
    return vec3(c * p.x - s * p.z, p.y, s * p.x + c * p.z);
}

float op_twist_steepness(float rate, float radius) {
    float shear = 0.5 * abs(rate) * radius;
    return shear + sqrt(1.0 + shear * shear);
}

// Turns the place p about the z axis by `rate` radians for each metre of p.x: what lies along x bends toward y. `radius` counts from the z axis.
vec3 op_bend(vec3 p, float rate) {
    float c = cos(rate * p.x);
    float s = sin(rate * p.x);
    return vec3(c * p.x + s * p.y, c * p.y - s * p.x, p.z);
}

float op_bend_steepness(float rate, float radius) {
    return 1.0 + abs(rate) * radius;
}

// Widens or narrows about the y axis: as it was up to the height `low`, `factor` times as wide from the height `high` on, and steadily between.
// `radius` counts from the y axis.
vec3 op_taper(vec3 p, float low, float high, float factor) {
    float width = mix(1.0, factor, clamp((p.y - low) / (high - low), 0.0, 1.0));
    return vec3(p.x / width, p.y, p.z / width);
}

float op_taper_steepness(float low, float high, float factor, float radius) {
    float width = min(factor, 1.0);
    float across = 1.0 / width;
    float shear = radius * abs(factor - 1.0) / ((high - low) * width * width);
    float sum = across * across + shear * shear + 1.0;
    return sqrt(0.5 * (sum + sqrt(max(sum * sum - 4.0 * across * across, 0.0))));
}

// Raises a surface by a height that varies, such as a pattern of p. `slope` is how much the height changes in a metre, at most. The result changes by at
// most one metre a metre, but is less than the distance.
float op_displace(float d, float height, float slope) {
    return (d - height) / (1.0 + slope);
}

// The same by a height from 0 to `most`. The surface stays between those that are not raised and raised by `most`, so steps far from it need no slope.
float op_displace_within(float d, float height, float slope, float most) {
    return max(d - most, min(op_displace(d, height, slope), d));
}
