#include "scene/toy_input.h"

static const ToyInput inputs[] = {
    {"iResolution", "vec3", NULL},
    {"iTime", "float", NULL},
    {"iTimeDelta", "float", NULL},
    {"iFrameRate", "float", NULL},
    {"iFrame", "int", NULL},
    {"iMouse", "vec4", NULL},
    {"iDate", "vec4", NULL},
    {"iSampleRate", "float", NULL},
    {"iChannelTime", "float", NULL},
    {"iChannelResolution", "vec3", NULL},
    {"iChannel0", "sampler2D", NULL},
    {"iChannel1", "sampler2D", NULL},
    {"iChannel2", "sampler2D", NULL},
    {"iChannel3", "sampler2D", NULL},
    /* What iTime was called before 2017. */
    {"iGlobalTime", "float", "iTime"},
    /* The Book of Shaders and its editors. */
    {"u_time", "float", "iTime"},
    {"u_resolution", "vec2", "iResolution"},
    {"u_mouse", "vec2", "iMouse"},
    {"u_delta", "float", "iTimeDelta"},
    {"u_frame", "int", "iFrame"},
    {"u_date", "vec4", "iDate"},
    /* GLSL Sandbox, where the pointer goes from 0 to 1. */
    {"time", "float", "iTime"},
    {"resolution", "vec2", "iResolution"},
    {"mouse", "vec2", "iMouse.xy / iResolution.xy"},
    {"backbuffer", "sampler2D", NULL},
};

const ToyInput *toy_input_find(const GlslTokens *tokens, int i) {
    for (size_t k = 0; k < sizeof inputs / sizeof *inputs; k++) {
        if (glsl_token_is(tokens, i, inputs[k].name)) return &inputs[k];
    }
    return NULL;
}
