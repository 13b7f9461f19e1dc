// expect 10 20: 51 153 0
//@ size 40 30
//@ preset strong level 1
uniform float level; //@ slider 0.6  min 0  max 1  label "green"
uniform float strength = 0.2;
uniform float nothing;
void mainImage(out vec4 O, in vec2 I) { O = vec4(strength, level, nothing, 1.0); }
// warns slider.glsl:6: nothing stays 0
