// The extent of the table of the further light, for the passes that fill it and for those that read it.

// Texels across, and along in each half.
uniform vec3 further_size;
// The sines of elevation of the observer's visible horizon and of the air's limb, as for the sky's table.
uniform float further_horizon;
uniform float further_limb;
