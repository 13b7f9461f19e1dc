// Where light paths begin, and how many there are. See sun/aim.glsl.
#include "math/dialect.glsl"

// One texel for each node of the tree.
uniform sampler2D aim_tree;
// The rectangle's least and largest coordinates.
uniform vec4 aim_box;
// The plane's distance from the origin toward the sun.
uniform float aim_distance;
// The number of light paths for each sample of a pixel. It is 0 if none are traced.
uniform float aim_paths;

vec4 aim_node(int i) {
    return texelFetch(aim_tree, ivec2(i, 0), 0);
}

vec4 aim_rectangle() {
    return aim_box;
}

float aim_top() {
    return aim_distance;
}

float light_paths_a_sample() {
    return aim_paths;
}
