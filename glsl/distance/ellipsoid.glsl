#include "math/dialect.glsl"

// Distance to an ellipsoid with its three radii along the axes, r below.
//
// The nearest point of the surface is x = r^2 p / (s + r^2) for the s that gives |x / r| = 1 (Eberly 2013, "Distance from a
// Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid"). 1 / |x / r| is nearly straight in s, and concave: Newton's steps on
// it from a smaller s come near in few steps and never pass the root (More and Sorensen 1983). So the distance outside,
// which grows with s, is never too large when they stop early. 8 steps are good to a millionth of the long radius up to 6:1.
float distance_ellipsoid(vec3 p, vec3 centre, vec3 radii) {
    vec3 q = abs(p - centre);
    vec3 r2 = radii * radii;
    vec3 scaled = q / radii;
    bool inside = dot(scaled, scaled) < 1.0;
    // One axis alone is past its radius below this s.
    vec3 least = radii * q - r2;
    float s = max(max(least.x, least.y), least.z);
    if (!inside) s = max(s, 0.0);
    float tiny = 1.0e-7 * min(min(r2.x, r2.y), r2.z);
    vec3 unit = vec3(0.0);
    for (int i = 0; i < 8; i++) {
        vec3 below = max(s + r2, vec3(tiny));
        unit = radii * q / below;
        float size2 = max(dot(unit, unit), 1.0e-30);
        float slope = max(dot(unit * unit / below, vec3(1.0)), 1.0e-30);
        s += max(sqrt(size2) - 1.0, 0.0) * size2 / slope;
    }
    vec3 below = max(s + r2, vec3(tiny));
    unit = radii * q / below;
    // Inside, in the plane of the two long radii, s ends at its least: what the point lacks lies along the short one.
    float least_radius = min(min(radii.x, radii.y), radii.z);
    bool x_short = radii.x == least_radius;
    bool y_short = !x_short && radii.y == least_radius;
    vec3 axis = vec3(x_short ? 1.0 : 0.0, y_short ? 1.0 : 0.0, x_short || y_short ? 0.0 : 1.0);
    unit = sqrt(unit * unit + max(1.0 - dot(unit, unit), 0.0) * axis);
    return (inside ? -1.0 : 1.0) * length(q - radii * unit);
}
