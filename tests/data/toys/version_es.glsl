// expect 3 4: 0 51 204
/* A comment may stand before it. */
  #  version 300 es
precision highp float;
precision mediump int;
out vec4 outColor;
void main() { outColor = vec4(0.0, 0.2, 0.8, 1.0); }
