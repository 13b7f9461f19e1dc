#version 330 core
// WebGL 2 has packHalf2x16() and its like without an extension.
#extension GL_ARB_shading_language_packing : enable
// A fragment shader that paints a picture by itself. It defines mainImage(), as Shadertoy's programs do, or main(). iChannel0 is
// the picture before this one, or what its Buffer A draws, and the other channels are black. iFrame is the picture's number. Row 0 is the bottom, as in
// Shadertoy. The host changes the text of the scene's file (src/scene/toy_source.h).
#include "pass/shadertoy_uniforms.glsl"

// These stand for gl_FragColor and gl_FragCoord.
vec4 shadertoy_color = vec4(0.0);
vec4 shadertoy_coord = vec4(0.0);

#include <common>
#include <scene>

layout(location = 0) out vec4 shadertoy_next;
layout(location = 1) out vec4 shadertoy_cut;

// The host puts the call of the file's function here.
void shadertoy_run() {
}

// Whether the driver has ended the loops of this pixel. llvmpipe does so without an error after 65,535 iterations of all loops
// together, and then ends any further loop in its first iteration. The compiler must not know how often this loop turns.
bool shadertoy_was_cut() {
    int turns = 0;
    int most = shadertoy_turns + min(int(gl_FragCoord.x), 0);
    do {
        turns += 1;
    } while (turns < most);
    return turns < most;
}

void main() {
    shadertoy_coord = gl_FragCoord + vec4(shadertoy_shift.xy, 0.0, 0.0);
    shadertoy_run();
    shadertoy_next = shadertoy_color;
    shadertoy_cut = vec4(shadertoy_was_cut() ? 1.0 : 0.0);
}
