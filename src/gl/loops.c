#include "gl/loops.h"

#include "gl/texture.h"

#include <stddef.h>

/* More than the smallest limit known, and still done at once. */
enum { WANTED = 70000 };

static const char vertex_source[] =
    "#version 330 core\n"
    "void main() {\n"
    "    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);\n"
    "}\n";

/* The compiler must not know how often the loop turns. It knows uniforms in a loop's condition, but not where
 * a pixel lies. */
static const char fragment_source[] = "#version 330 core\n"
                                      "uniform int wanted;\n"
                                      "out vec4 result;\n"
                                      "void main() {\n"
                                      "    int turns = 0, most = wanted + min(int(gl_FragCoord.x), 0);\n"
                                      "    float counted = 0.0;\n"
                                      "    do {\n"
                                      "        turns += 1;\n"
                                      "        counted += 1.0;\n"
                                      "    } while (turns < most);\n"
                                      "    result = vec4(counted);\n"
                                      "}\n";

static void attach(const GlApi *gl, GLuint program, GLenum stage, const char *source) {
    GLuint shader = gl->CreateShader(stage);
    gl->ShaderSource(shader, 1, &source, NULL);
    gl->CompileShader(shader);
    gl->AttachShader(program, shader);
    /* It lives on until the program is deleted. */
    gl->DeleteShader(shader);
}

bool loops_probe(const GlApi *gl, long *limit, Error *error) {
    float counted[4] = {0};
    GLint linked = 0;
    GLuint framebuffer = 0, texture = texture_create(gl, 1, 1, GL_NEAREST, NULL);
    GLuint program = gl->CreateProgram();
    attach(gl, program, GL_VERTEX_SHADER, vertex_source);
    attach(gl, program, GL_FRAGMENT_SHADER, fragment_source);
    gl->LinkProgram(program);
    gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) {
        gl->GenFramebuffers(1, &framebuffer);
        gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
        gl->Viewport(0, 0, 1, 1);
        gl->UseProgram(program);
        gl->Uniform1i(gl->GetUniformLocation(program, "wanted"), WANTED);
        gl->DrawArrays(GL_TRIANGLES, 0, 3);
        gl->ReadBuffer(GL_COLOR_ATTACHMENT0);
        gl->ReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, counted);
        gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl->UseProgram(0);
        gl->DeleteFramebuffers(1, &framebuffer);
    }
    gl->DeleteProgram(program);
    gl->DeleteTextures(1, &texture);
    /* The last turn that it counted may be one that it did not let come to its end. */
    *limit = counted[0] < (float)WANTED ? (long)counted[0] - 1 : 0;
    if (!gl_check(gl, "counting a loop's turns", error)) return false;
    return linked || error_set(error, STATUS_NO_GL, "a small shader does not link");
}
