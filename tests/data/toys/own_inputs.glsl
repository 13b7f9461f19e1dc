// expect 30 15: 204 102 51
// expect 10 3: 51 102 51
uniform vec3 iResolution; // in pixels
uniform highp float iTime;
uniform sampler2D iChannel0, iChannel1;
uniform vec3 iChannelResolution[4];
uniform int iFrame;
void mainImage(out vec4 o, in vec2 p) { o = vec4(p.x > 0.5 * iResolution.x ? 0.8 : 0.2, 0.2 * iTime, 0.2, 1.0); }
// warns own_inputs.glsl:5: iChannel1 is black
