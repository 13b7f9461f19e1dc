// The size of the table of the further light and the directions of its texels, for the passes that fill it and for those that read it. Directions are
// mapped as in the sky's table (sky/table.glsl).

// The texels across and along in each half, and the column in which the half below the horizon begins. The gap between the halves is not used.
// Renderers on the CPU share their work by tiles of 64 pixels, so that the gap makes each half a tile of its own.
uniform vec3 further_size;
// The sines of elevation of the observer's visible horizon and of the air's limb, as for the sky's table.
uniform float further_horizon;
uniform float further_limb;

// Returns a texel's place in the sense of sky/table.glsl. `below` is 1 in the half below the horizon, and 0 in the other.
vec3 further_position(vec2 texel, float below) {
    return vec3(texel.x / (further_size.x - 1.0), texel.y / (further_size.y - 1.0), below);
}
