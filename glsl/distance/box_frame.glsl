#include "math/dialect.glsl"

// Distance to the twelve edges of a box along the axes, as bars with a square section. `half_size` reaches from the centre to the outer faces, and
// a bar is `thickness` wide. The distance is exact outside; inside, where three bars meet, it may be less. After Quilez, "Distance functions".
float distance_box_frame(vec3 p, vec3 centre, vec3 half_size, float thickness) {
    float half_bar = 0.5 * thickness;
    vec3 past = abs(p - centre) - half_size;
    vec3 bar = abs(past + half_bar) - half_bar;
    vec3 x = vec3(past.x, bar.y, bar.z);
    vec3 y = vec3(bar.x, past.y, bar.z);
    vec3 z = vec3(bar.x, bar.y, past.z);
    float to_x = length(max(x, vec3(0.0))) + min(max(max(x.x, x.y), x.z), 0.0);
    float to_y = length(max(y, vec3(0.0))) + min(max(max(y.x, y.y), y.z), 0.0);
    float to_z = length(max(z, vec3(0.0))) + min(max(max(z.x, z.y), z.z), 0.0);
    return min(min(to_x, to_y), to_z);
}
