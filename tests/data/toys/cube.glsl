// refused cube.glsl:2: iChannel1 is a texture of two dimensions
uniform samplerCube iChannel1;
void mainImage(out vec4 O, in vec2 I) { O = texture(iChannel1, vec3(I, 0.0)); }
