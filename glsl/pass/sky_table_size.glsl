// The extent of the sky's table, for the pass that fills it and for those that look it up.
uniform vec3 sky_table_size; // texels across, and along in each half
uniform float sky_horizon;   // sine of the elevation of the observer's visible horizon
uniform float sky_limb;      // and of the highest direction in which there is air: 1 from within the atmosphere
