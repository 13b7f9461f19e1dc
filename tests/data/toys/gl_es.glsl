// expect 3 4: 102 0 255
#ifdef GL_ES
precision mediump float;
#endif
precision mediump float;
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#endif
void mainImage(out mediump vec4 o, in highp vec2 p) { lowp float x = 0.4; o = vec4(x, 0.0, 1.0, 1.0); }
