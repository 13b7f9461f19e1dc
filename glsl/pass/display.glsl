#version 330 core
// The window's picture, drawn straight from the textures of its films.
#include <shown>

layout(location = 0) out vec4 shown;

// `pixel` counts from the picture's top left corner, as films do.
uniform vec3 window_size;

void main() {
    shown = vec4(shown_color(vec2(gl_FragCoord.x, window_size.y - gl_FragCoord.y), window_size.xy), 1.0);
}
