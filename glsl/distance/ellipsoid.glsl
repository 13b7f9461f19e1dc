#include "math/dialect.glsl"

// Distance to an ellipsoid with its three radii along the axes, r below.
//
// The nearest point of the surface is x = r^2 p / (s + r^2) for the s that gives |x / r| = 1 (Eberly 2013, "Distance from a
// Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid"). 1 / |x / r| is nearly straight in s, and concave: Newton's steps on
// it from a smaller s come near in few steps and never pass the root (More and Sorensen 1983). So the distance outside,
// which grows with s, is never too large when they stop early. 8 steps are good to a millionth of the long radius up to 6:1.
//
// s counts from where the short axis has its pole, so that no rounding is lost there.
float distance_ellipsoid(vec3 p, vec3 centre, vec3 radii) {
    float least_radius = min(min(radii.x, radii.y), radii.z);
    vec3 to_pole = (radii - least_radius) * (radii + least_radius);
    vec3 q = max(abs(p - centre), vec3(1.0e-7 * least_radius)); // off the planes where the nearest point is one of two
    vec3 scaled = q / radii;
    bool inside = dot(scaled, scaled) < 1.0;
    // One axis alone is past its radius below this s.
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
