// The sun's position.

// Toward the sun, a unit vector.
uniform vec3 sun_direction;
// Toward the sun's azimuth, a horizontal unit vector.
uniform vec3 sun_level;
