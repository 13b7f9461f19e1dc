// The extent of the sky's table, for the pass that fills it and for those that read it.

// Texels across, and along in each half.
uniform vec3 sky_table_size;
// The sine of the elevation of the observer's visible horizon.
uniform float sky_horizon;
// The sine of the elevation of the highest direction that passes through air: 1 from within the atmosphere.
uniform float sky_limb;
