// expect 30 15: 191 128 102
uniform vec2 iResolution;
uniform float iFrame;
uniform vec3 iMouse;
uniform
  vec2 // of the picture
  u_resolution;
void mainImage(out vec4 o, in vec2 p) {
    vec2 uv = floor(p) / iResolution;
    vec2 other = floor(p) / u_resolution;
    o = vec4(uv.x, other.y, 0.4 + iFrame * 0.0 + iMouse.z * 0.0, 1.0);
}
