// expect 3 4: 0 102 204
#version 450
layout(location = 1) out vec4 other;
layout(location = 0) out vec4 shown;
void main() { other = vec4(1.0); shown = vec4(0.0, 0.4, 0.8, 1.0); }
