// Where the sun stands.
uniform vec3 sun_direction; // toward the sun, unit length
uniform vec3 sun_level;     // toward the sun's azimuth, level, unit length
