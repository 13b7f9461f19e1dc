// expect 3 4: 51 204 102
#version 150
out vec3 paint;
void main() {
    paint = vec3(0.2, 0.0, 0.4);
    if (gl_FragCoord.x > 0.0) paint.g = 0.8;
}
