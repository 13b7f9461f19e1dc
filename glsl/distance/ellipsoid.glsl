#include "math/dialect.glsl"

// Distance to an ellipsoid with three radii along the axes. The text below writes r for the radii.
//
// The nearest point of the surface is x = r^2 p / (s + r^2), where s is such that |x / r| = 1 (Eberly 2013, "Distance from a
// Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid"). The function 1 / |x / r| of s is nearly straight, and concave. Newton's steps
// from a smaller s therefore come near the root in few steps, and never pass it (More and Sorensen 1983). The distance outside
// grows with s, so it is never too large if the steps stop early. Up to a ratio of radii of 6:1, 8 steps are accurate to a millionth of the
// longest radius.
//
// s is counted from the pole of the shortest axis, so that no digits are lost there.
float distance_ellipsoid(vec3 p, vec3 centre, vec3 radii) {
    float least_radius = min(min(radii.x, radii.y), radii.z);
    vec3 to_pole = (radii - least_radius) * (radii + least_radius);
    // Keeps q away from the planes on which two points of the surface are nearest.
    vec3 q = max(abs(p - centre), vec3(1.0e-7 * least_radius));
    vec3 scaled = q / radii;
    bool inside = dot(scaled, scaled) < 1.0;
    // Below this s, one coordinate alone makes |x / r| larger than 1.
    vec3 least = radii * q - to_pole;
    float s = max(max(least.x, least.y), least.z);
    if (!inside) s = max(s, least_radius * least_radius);
    vec3 unit = vec3(0.0);
    for (int i = 0; i < 9; i++) {
        vec3 below = s + to_pole;
        unit = radii * q / below;
        float size2 = dot(unit, unit);
        float slope = dot(unit, unit / below);
        s += max(sqrt(size2) - 1.0, 0.0) * size2 / slope;
    }
    return (inside ? -1.0 : 1.0) * length(q - radii * unit);
}
