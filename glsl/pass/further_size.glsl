// The extent of the table of the further light, for the passes that fill it and for those that read it.

// Texels across and along in each half, and how far right of the half above the horizon the half below begins. The gap between them is not used: renderers on the
// CPU share their work by tiles of 64 pixels, so that each half is a tile of its own.
uniform vec3 further_size;
// The sines of elevation of the observer's visible horizon and of the air's limb, as for the sky's table.
uniform float further_horizon;
uniform float further_limb;

// Returns the place in the sky's table (sky/table.glsl) of a texel of a half; `below` is 1 in that below the horizon, else 0.
vec3 further_position(vec2 texel, float below) {
    return vec3(texel.x / (further_size.x - 1.0), texel.y / (further_size.y - 1.0), below);
}
