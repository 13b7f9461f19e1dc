// Where light paths begin. They cross a plane that faces the sun and goes through the surfaces that throw light, and are dense where surfaces
// throw light into the picture. The density is constant in each leaf of a tree that halves the plane's rectangle again and again, and all leaves
// have the same share of the paths. A part of the paths is spread evenly over the rectangle. The host makes the tree (src/render/aim.c).
#include "sun/disk.glsl"
#include "math/frame.glsl"

// A node cuts its box in two, and each half in two again. Its texel holds the place of the first cut, those of the cuts of the lower and of the
// upper half, and the axes: 1 if the first cut is across the plane's second axis, plus 2 and 4 for the other two. The boxes of node i are the nodes
// 4 i + 1 to 4 i + 4; the root is 0.
vec4 aim_node(int i);
// The rectangle's least and largest coordinates.
vec4 aim_rectangle();
// The plane's distance from the origin toward the sun, and that of the places where light paths begin.
float aim_plane();
float aim_top();

// The leaves below five nodes. Loops over the five are written out, because some drivers limit loops (src/gl/loops.h).
const float AIM_LEAVES = 1024.0;
// The part of the paths that is spread evenly.
const float AIM_EVEN = 0.1;

struct AimWalk {
    int node;
    // The node's box: least and largest coordinates.
    vec4 box;
};

// Cuts the box and keeps one half.
vec4 aim_half(vec4 box, float cut, bool across, bool upper) {
    return vec4(upper && !across ? cut : box.x, upper && across ? cut : box.y, !upper && !across ? cut : box.z, !upper && across ? cut : box.w);
}

// The cuts of a node: the first, and the one of a half.
struct AimCut {
    float place;
    bool across;
};

AimCut aim_first(vec4 node) {
    int axes = int(node.w);
    return AimCut(node.x, axes - axes / 2 * 2 > 0);
}

AimCut aim_second(vec4 node, bool upper) {
    int axes = int(node.w);
    bool upper_across = axes >= 4;
    bool lower_across = axes - axes / 4 * 4 >= 2;
    return AimCut(upper ? node.z : node.y, upper ? upper_across : lower_across);
}

void aim_step(INOUT(AimWalk) walk, AimCut first, bool upper, AimCut second, bool upper_second) {
    walk.box = aim_half(aim_half(walk.box, first.place, first.across, upper), second.place, second.across, upper_second);
    walk.node = 4 * walk.node + 1 + (upper ? 2 : 0) + (upper_second ? 1 : 0);
}

// Goes to the box that holds the point.
void aim_find(INOUT(AimWalk) walk, vec2 at) {
    vec4 node = aim_node(walk.node);
    AimCut first = aim_first(node);
    bool upper = (first.across ? at.y : at.x) >= first.place;
    AimCut second = aim_second(node, upper);
    aim_step(walk, first, upper, second, (second.across ? at.y : at.x) >= second.place);
}

// Chooses a half by u, whose part is stretched to [0, 1) again.
bool aim_choose(INOUT(vec2) u, bool across) {
    float twice = 2.0 * (across ? u.y : u.x);
    bool upper = twice >= 1.0;
    float above = twice - 1.0;
    float rest = upper ? above : twice;
    u = vec2(across ? u.x : rest, across ? rest : u.y);
    return upper;
}

// Goes to a random box.
void aim_draw(INOUT(AimWalk) walk, INOUT(vec2) u) {
    vec4 node = aim_node(walk.node);
    AimCut first = aim_first(node);
    bool upper = aim_choose(u, first.across);
    AimCut second = aim_second(node, upper);
    aim_step(walk, first, upper, second, aim_choose(u, second.across));
}

float aim_area(vec4 box) {
    return max((box.z - box.x) * (box.w - box.y), 1.0e-30);
}

// The density of the paths on the plane, 1/m^2.
float aim_density_at(vec2 at) {
    vec4 all = aim_rectangle();
    AimWalk walk = AimWalk(0, all);
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
    AimWalk walk = AimWalk(0, aim_rectangle());
    vec2 v = u;
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

// The place where a light path begins that crosses the plane at these coordinates and comes from the direction `toward`.
vec3 aim_begin(vec2 at, vec3 toward) {
    vec3 crossing = in_frame(sun_middle(), at.x, at.y, aim_plane());
    return crossing + (aim_top() - aim_plane()) / dot(toward, sun_middle()) * toward;
}

// The density of light paths that come to `position` from the direction `toward`, per square metre across that direction and for paths of all
// directions of the disk. It is 0 beyond the places where they begin.
float aim_density(vec3 position, vec3 toward) {
    float cosine = max(dot(toward, sun_middle()), 1.0e-3);
    float height = dot(position, sun_middle());
    vec3 at = aim_coordinates(position + (aim_plane() - height) / cosine * toward);
    return height < aim_top() ? aim_density_at(vec2(at.x, at.y)) / cosine : 0.0;
}
