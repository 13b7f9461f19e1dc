// What a case is given: a texture of the results' size, texel by texel.
uniform sampler2D inputs;

// From here on uniforms are plain globals, which the case sets itself: the values of a scene or of a pass are then the
// same for all three compilers.
#define uniform
