#include "scene/toy_source.h"

#include "scene/toy_interface.h"
#include "source/glsl_tokens.h"
#include "source/glsl_zero.h"
#include "source/text_edits.h"

#include <stdlib.h>
#include <string.h>

static const char entry[] = "pass/shadertoy.glsl";
/* The function of the entry file that calls the file's own. */
static const char runner[] = "shadertoy_run";

/* Whether the text begins with a comment that holds an ISF file's JSON. */
static bool is_isf(const char *text) {
    const char *comment = strstr(text, "/*"), *end = comment ? strstr(comment, "*/") : NULL;
    const char *mark = comment ? strstr(comment, "\"ISFVSN\"") : NULL;
    if (!comment || !end) return false;
    if (mark) return mark < end;
    return comment[2 + strspn(comment + 2, " \t\r\n")] == '{' && strstr(end, "RENDERSIZE");
}

/* An extension of WebGL that is a part of GLSL 3.30. */
static bool is_core(const GlslTokens *tokens, int name) {
    static const char *const known[] = {"GL_EXT_shader_texture_lod", "GL_EXT_frag_depth",
                                        "GL_EXT_draw_buffers", NULL};
    return glsl_token_among(tokens, name, known) ||
           (name < tokens->count && strncmp(tokens->text + tokens->list[name].at, "GL_OES_", 7) == 0);
}

/* Takes the directive away whose `#` is at `i`. #extension moves behind the text's #version. */
static void take_directive(const GlslTokens *tokens, int i, TextEdits *edits) {
    const char *hash = tokens->text + tokens->list[i].at;
    size_t size = strcspn(hash, "\r\n"), head = strcspn(tokens->text, "\n") + 1;
    int word = glsl_token_next(tokens, i);
    text_edits_add(edits, tokens->list[i].at, size, "%s", "");
    if (!glsl_token_is(tokens, word, "extension") || is_core(tokens, glsl_token_next(tokens, word))) return;
    text_edits_add(edits, head, 0, "#line %d %d\n%.*s\n", glsl_token_line(tokens, i), tokens->list[i].file,
                   (int)size, hash);
}

static void take_directives(const GlslTokens *tokens, const GlslSource *source, const char *library,
                            TextEdits *edits) {
    /* The last ones are lines for editors. */
    static const char *const taken[] = {"extension", "iChannel0", "iChannel1",
                                        "iChannel2", "iChannel3", NULL};
    for (int i = 0; i + 1 < tokens->count; i++) {
        bool begins =
            tokens->list[i].directive && (!i || tokens->list[i - 1].directive != tokens->list[i].directive);
        if (begins && glsl_token_among(tokens, i + 1, taken) &&
            glsl_source_is_own(source, tokens->list[i].file, library))
            take_directive(tokens, i, edits);
    }
}

/* Gives the runner its body. */
static void put_call(const GlslTokens *tokens, const ToyInterface *interface, TextEdits *edits) {
    for (int i = 0; i < tokens->count; i++) {
        if (!glsl_token_is(tokens, i, runner) || !glsl_token_is(tokens, i + 3, "{")) continue;
        text_edits_add(edits, tokens->list[i + 3].at + 1, 0, " %s", text_string(&interface->call));
        return;
    }
}

/* Joins lines that a backslash continues, which GLSL 3.30 has not. The lines' ends stand behind the last of
 * them, so that no other line changes its number. */
static void join_lines(GlslSource *source) {
    Text joined = {0};
    int owed = 0;
    for (const char *at = text_string(&source->text); *at;) {
        size_t end = at[0] == '\\' ? 1 + (at[1] == '\r') : 0;
        if (end && at[end] == '\n') {
            text_append(&joined, " ", 1);
            owed++;
            at += end + 1;
            continue;
        }
        text_append(&joined, at, 1);
        for (; *at == '\n' && owed; owed--) text_append(&joined, "\n", 1);
        at++;
    }
    text_free(&source->text);
    source->text = joined;
}

static bool rewrite(GlslSource *source, Text *notes, const ToyParams *params, Error *error) {
    const char *library = params->file->sources->folder;
    join_lines(source);
    GlslTokens tokens = glsl_tokens(text_string(&source->text));
    TextEdits edits = {0};
    ToyInterface interface = {.file = params->file, .source = source, .tokens = &tokens, .edits = &edits};
    bool ok = toy_interface_read(&interface, error);
    take_directives(&tokens, source, library, &edits);
    put_call(&tokens, &interface, &edits);
    Text text = text_edits_apply(&edits, text_string(&source->text));
    text_print(notes, "%s", text_string(&interface.notes));
    toy_interface_free(&interface);
    glsl_tokens_free(&tokens);
    text_free(&source->text);
    source->text = text;
    if (ok && !params->without_zero) glsl_zero(source, library, runner);
    return ok;
}

bool toy_source_create(GlslSource *source, Text *notes, const ToyParams *params, Error *error) {
    const SceneFile *file = params->file;
    const char *path = params->buffer ? file->buffer : file->path;
    const GlslSlot slots[] = {
        {"common", file->common, file->common ? NULL : ""}, {"scene", path, NULL}, {NULL, NULL, NULL}};
    const SourceFile *read;
    if (!source_store_read(file->sources, path, &read, error)) return false;
    if (is_isf(text_string(&read->text))) {
        return error_set(
            error, STATUS_SCENE,
            "%s:1: this is an ISF file (Interactive Shader Format), and not a Shadertoy program: write "
            "`void mainImage(out vec4 color, in vec2 at)` in place of main(), color for gl_FragColor, "
            "at / iResolution.xy for isf_FragNormCoord, iResolution.xy for RENDERSIZE, iTime for TIME, "
            "and a constant for each of its INPUTS",
            path);
    }
    if (!glsl_source_create(source, file->sources, entry, slots, error)) return false;
    if (rewrite(source, notes, params, error)) return true;
    glsl_source_destroy(source);
    return false;
}
