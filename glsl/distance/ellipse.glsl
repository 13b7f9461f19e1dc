#include "math/dialect.glsl"

// Distance in a plane to an ellipse with two radii along the axes. The nearest point is found by the steps that distance_ellipsoid() explains. Up to
// a ratio of radii of 6:1 they are accurate to a millionth of the longer radius.
float distance_ellipse(vec2 p, vec2 centre, vec2 radii) {
    float least_radius = min(radii.x, radii.y);
    vec2 to_pole = (radii - least_radius) * (radii + least_radius);
    vec2 q = max(abs(p - centre), vec2(1.0e-7 * least_radius));
    vec2 scaled = q / radii;
    bool inside = dot(scaled, scaled) < 1.0;
    vec2 least = radii * q - to_pole;
    float s = max(least.x, least.y);
    if (!inside) s = max(s, least_radius * least_radius);
    vec2 unit = vec2(0.0);
    for (int i = 0; i < 9; i++) {
        vec2 below = s + to_pole;
        unit = radii * q / below;
        float size2 = dot(unit, unit);
        float slope = dot(unit, unit / below);
        s += max(sqrt(size2) - 1.0, 0.0) * size2 / slope;
    }
    return (inside ? -1.0 : 1.0) * length(q - radii * unit);
}
