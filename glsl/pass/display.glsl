#version 330 core
// What the window shows of its films, drawn straight from their textures.
#include <shown>

layout(location = 0) out vec4 shown;

// `pixel` counts from the picture's top left corner, as films do.
uniform vec3 window_size;

void main() {
    shown = vec4(shown_color(vec2(gl_FragCoord.x, window_size.y - gl_FragCoord.y), window_size.xy), 1.0);
}
