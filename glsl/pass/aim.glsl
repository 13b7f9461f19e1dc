// Where light paths begin, and how many there are. See sun/aim.glsl.
#include "math/dialect.glsl"

// One texel for each node of the tree.
uniform sampler2D aim_tree;
// The rectangle's least and largest coordinates.
uniform vec4 aim_box;
// The distances from the origin toward the sun of the plane, and of the places where light paths begin.
uniform float aim_middle;
uniform float aim_highest;
// The number of light paths for each sample of a pixel. It is 0 if none are traced.
uniform float aim_paths;

vec4 aim_node(int i) {
    return texelFetch(aim_tree, ivec2(i, 0), 0);
}

vec4 aim_rectangle() {
    return aim_box;
}

float aim_plane() {
    return aim_middle;
}

float aim_top() {
    return aim_highest;
}

float light_paths_a_sample() {
    return aim_paths;
}
