// The extent of the table of the further light, for the passes that fill it and for those that read it.

// Texels across, and along in each half.
uniform vec3 further_size;
// The sines of elevation of the observer's visible horizon and of the air's limb, as for the sky's table.
uniform float further_horizon;
uniform float further_limb;

// Returns the place in the sky's table (sky/table.glsl) of a texel.
vec3 further_position(vec2 texel) {
    float below = texel.y >= further_size.y ? 1.0 : 0.0;
    return vec3(texel.x / (further_size.x - 1.0), (texel.y - below * further_size.y) / (further_size.y - 1.0), below);
}
