// expect 3 4: 255 153 0
#define PAINT gl_FragColor
void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0, 0.6, 0.0, 1.0); }
void main() { mainImage(PAINT, gl_FragCoord.xy); }
