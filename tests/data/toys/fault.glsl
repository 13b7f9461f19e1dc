#version 300 es
// refused fault.glsl:7:
precision highp float;
uniform vec3 iResolution;
void mainImage(out vec4 O, in vec2 I) {
    float a, b;
    O = vec4(a, b, undeclared, 1.0);
}
