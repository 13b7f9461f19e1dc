#include "math/dialect.glsl"

// Distance to a solid cone from the middle of its base to its tip, with `radius` at the base. In a half-plane through the axis the
// cone is a triangle, and the distance is that to the nearer of its slanted side and its base. After Quilez, "Distance functions".
float distance_cone(vec3 p, vec3 base, vec3 tip, float radius) {
    float height = length(base - tip);
    vec3 axis = (base - tip) / height;
    float down = dot(p - tip, axis);
    vec2 q = vec2(length(p - tip - down * axis), down);
    vec2 slant = vec2(radius, height);
    vec2 to_side = q - clamp(dot(q, slant) / dot(slant, slant), 0.0, 1.0) * slant;
    vec2 to_base = vec2(max(q.x - radius, 0.0), q.y - height);
    bool inside = q.y < height && q.x * height < radius * q.y;
    float reach = sqrt(min(dot(to_side, to_side), dot(to_base, to_base)));
    return inside ? -reach : reach;
}
