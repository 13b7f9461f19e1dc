// Where light paths begin. They begin on a plane that faces the sun and lies before the scene, and are dense where surfaces throw light into the picture. The density is
// constant in each leaf of a tree that halves the plane's rectangle again and again, and all leaves have the same share of the paths. A part of the
// paths is spread evenly over the rectangle. The host makes the tree from surfaces that a few paths have met (src/render/aim.c).
#include "sun/disk.glsl"
#include "math/frame.glsl"

// The node's texel: x is where the halves meet, and y is 0 if the cut is across the plane's first axis, 1 across its second. The two nodes below
// node i are 2 i and 2 i + 1; the root is 1.
vec2 aim_node(int i);
// The rectangle's least and largest coordinates.
vec4 aim_rectangle();
// The plane's distance from the origin toward the sun.
float aim_top();

// Halvings from the root to a leaf. The loop over them is written out, because some drivers limit loops (src/gl/loops.h).
const int AIM_LEVELS = 10;
const float AIM_LEAVES = 1024.0;
// The part of the paths that is spread evenly.
const float AIM_EVEN = 0.1;

struct AimWalk {
    int node;
    // The node's rectangle: least and largest coordinates.
    vec4 box;
};

// Goes down to the first or the second half.
void aim_step(INOUT(AimWalk) walk, vec2 cut, bool second) {
    bool across = cut.y > 0.5;
    float low = second ? cut.x : walk.box.x;
    float high = second ? walk.box.z : cut.x;
    if (across) {
        walk.box.y = second ? cut.x : walk.box.y;
        walk.box.w = second ? walk.box.w : cut.x;
    } else {
        walk.box.x = low;
        walk.box.z = high;
    }
    walk.node = 2 * walk.node + (second ? 1 : 0);
}

// Goes down to the half that holds the point.
void aim_find(INOUT(AimWalk) walk, vec2 at) {
    vec2 cut = aim_node(walk.node);
    aim_step(walk, cut, (cut.y > 0.5 ? at.y : at.x) >= cut.x);
}

// Goes down to a random half. The number that chose is stretched to [0, 1) again.
void aim_draw(INOUT(AimWalk) walk, INOUT(vec2) u) {
    vec2 cut = aim_node(walk.node);
    bool across = cut.y > 0.5;
    float twice = 2.0 * (across ? u.y : u.x);
    bool second = twice >= 1.0;
    float rest = second ? twice - 1.0 : twice;
    u = vec2(across ? u.x : rest, across ? rest : u.y);
    aim_step(walk, cut, second);
}

float aim_area(vec4 box) {
    return max((box.z - box.x) * (box.w - box.y), 1.0e-30);
}

// The density of the paths on the plane, 1/m^2.
float aim_density_at(vec2 at) {
    vec4 all = aim_rectangle();
    AimWalk walk = AimWalk(1, all);
    aim_find(walk, at);
    aim_find(walk, at);
    aim_find(walk, at);
    aim_find(walk, at);
    aim_find(walk, at);
    aim_find(walk, at);
    aim_find(walk, at);
    aim_find(walk, at);
    aim_find(walk, at);
    aim_find(walk, at);
    bool there = at.x >= all.x && at.y >= all.y && at.x < all.z && at.y < all.w;
    float density = AIM_EVEN / aim_area(all) + (1.0 - AIM_EVEN) / (AIM_LEAVES * aim_area(walk.box));
    return there ? density : 0.0;
}

// Draws a point of the plane from u and choice in [0, 1).
vec2 aim_sample(vec2 u, float choice) {
    AimWalk walk = AimWalk(1, aim_rectangle());
    vec2 v = u;
    aim_draw(walk, v);
    aim_draw(walk, v);
    aim_draw(walk, v);
    aim_draw(walk, v);
    aim_draw(walk, v);
    aim_draw(walk, v);
    aim_draw(walk, v);
    aim_draw(walk, v);
    aim_draw(walk, v);
    aim_draw(walk, v);
    vec4 box = choice < AIM_EVEN ? aim_rectangle() : walk.box;
    v = choice < AIM_EVEN ? u : v;
    return vec2(box.x + v.x * (box.z - box.x), box.y + v.y * (box.w - box.y));
}

// The coordinates of a position: across the sun's direction twice, and toward the sun.
vec3 aim_coordinates(vec3 position) {
    vec3 middle = sun_middle();
    return vec3(dot(position, in_frame(middle, 1.0, 0.0, 0.0)), dot(position, in_frame(middle, 0.0, 1.0, 0.0)), dot(position, middle));
}

// The point of the plane with these coordinates.
vec3 aim_position(vec2 at) {
    return in_frame(sun_middle(), at.x, at.y, aim_top());
}

// The density of light paths that come to `position` from the direction `toward`, per square metre across that direction and for paths of all
// directions of the disk. It is 0 beyond the plane.
float aim_density(vec3 position, vec3 toward) {
    float cosine = max(dot(toward, sun_middle()), 1.0e-3);
    float distance = (aim_top() - dot(position, sun_middle())) / cosine;
    vec3 at = aim_coordinates(position + distance * toward);
    return distance > 0.0 ? aim_density_at(vec2(at.x, at.y)) / cosine : 0.0;
}
