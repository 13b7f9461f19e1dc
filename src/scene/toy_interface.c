#include "scene/toy_interface.h"

#include "scene/toy_input.h"

#include <stdio.h>
#include <string.h>

/* A declaration outside of functions: `uniform highp vec3 a, b[2] = ...;`. */
typedef struct Declaration {
    /* Its first token, that of its kind (`uniform`, `in`, `out`, ...; -1 where there is none), of its type,
     * of its first name, and the semicolon. */
    int start, kind, type, name, end;
} Declaration;

static const char *const kinds[] = {"uniform", "in", "out", "varying", "attribute", NULL};
static const char *const other_words[] = {"const",  "highp",    "mediump",       "lowp",      "flat",
                                          "smooth", "centroid", "noperspective", "invariant", NULL};

static const char *word_at(const ToyInterface *interface, int i) {
    return interface->tokens->text + interface->tokens->list[i].at;
}

static int size_at(const ToyInterface *interface, int i) {
    return (int)interface->tokens->list[i].size;
}

static bool is(const ToyInterface *interface, int i, const char *word) {
    return glsl_token_is(interface->tokens, i, word);
}

static void take(ToyInterface *interface, int i) {
    text_edits_add(interface->edits, interface->tokens->list[i].at, interface->tokens->list[i].size, "%s",
                   "");
}

/* Takes tokens away one by one, so that lines and comments stay. */
static void take_all(ToyInterface *interface, int from, int to) {
    for (int i = from; i <= to; i++) {
        if (!interface->tokens->list[i].directive) take(interface, i);
    }
}

static void put(ToyInterface *interface, int i, const char *words) {
    text_edits_add(interface->edits, interface->tokens->list[i].at, 0, "%s", words);
}

static void note(ToyInterface *interface, int i, const char *words) {
    enum { MOST_NOTES = 20 };
    if (interface->note_count++ >= MOST_NOTES) return;
    text_print(&interface->notes, "%s:%d: %.*s %s\n",
               glsl_source_file(interface->source, interface->tokens->list[i].file),
               glsl_token_line(interface->tokens, i), size_at(interface, i), word_at(interface, i), words);
}

static bool refuse(const ToyInterface *interface, int i, const char *words, Error *error) {
    return error_set(error, STATUS_SCENE, "%s:%d: %.*s %s",
                     glsl_source_file(interface->source, interface->tokens->list[i].file),
                     glsl_token_line(interface->tokens, i), size_at(interface, i), word_at(interface, i),
                     words);
}

static bool is_parameter(const ToyInterface *interface, int name) {
    for (int i = 0; i < interface->file->parameter_count; i++) {
        if (is(interface, name, interface->file->parameters[i].name)) return true;
    }
    return false;
}

/* The name of one of Shadertoy's inputs is for the file's own variable. */
static void take_name(ToyInterface *interface, int name) {
    names_add(&interface->taken, word_at(interface, name), (size_t)size_at(interface, name));
}

static bool is_sampler(const ToyInterface *interface, int type) {
    return strncmp(word_at(interface, type), "sampler", 7) == 0;
}

/* Writes the declaration of one of a declaration's names anew. `behind` is the token behind the name and what
 * belongs to it. */
static void declare(const ToyInterface *interface, const Declaration *declaration, int name, int behind,
                    Text *words) {
    const ToyInput *input = toy_input_find(interface->tokens, name);
    int type = declaration->type, length = size_at(interface, type);
    bool same = input && is(interface, type, input->type);
    if (input && !input->value && same) return;
    if (!input || is_sampler(interface, type)) {
        size_t from = interface->tokens->list[name].at, to = interface->tokens->list[behind].at;
        text_print(words, " uniform %.*s %.*s;", length, word_at(interface, type), (int)(to - from),
                   interface->tokens->text + from);
        return;
    }
    bool standard = !input->value;
    text_print(words, " %.*s %s%s = %.*s(%s);", length, word_at(interface, type), standard ? "own_" : "",
               input->name, length, word_at(interface, type), standard ? input->name : input->value);
}

/* Uniforms that have the name of an input get its value, in the type that the file wants. */
static bool read_uniforms(ToyInterface *interface, const Declaration *declaration, Error *error) {
    const GlslTokens *tokens = interface->tokens;
    Text words = {0};
    for (int name = declaration->name; name < declaration->end;) {
        const ToyInput *input = toy_input_find(tokens, name);
        int behind = glsl_token_comma(tokens, name, declaration->end), next = glsl_token_next(tokens, name);
        if (input && is_sampler(interface, declaration->type) &&
            !is(interface, declaration->type, input->type)) {
            text_free(&words);
            return refuse(interface, name, "is a texture of two dimensions here (sampler2D)", error);
        }
        if (input && !input->value && !is(interface, declaration->type, input->type))
            take_name(interface, name);
        bool array = is(interface, next, "[");
        if (!input && !is_parameter(interface, name) &&
            !is(interface, array ? glsl_token_skip(tokens, next) : next, "="))
            note(interface, name,
                 is_sampler(interface, declaration->type) ? "is black: no texture of that name is known"
                                                          : "stays 0: no input of that name is known");
        declare(interface, declaration, name, behind, &words);
        name = behind < declaration->end ? glsl_token_next(tokens, behind) : declaration->end;
    }
    put(interface, declaration->start, text_string(&words));
    take_all(interface, declaration->start, declaration->end);
    text_free(&words);
    return true;
}

/* An output becomes a variable. The first one is the colour, or the one that is said to be. */
static void read_output(ToyInterface *interface, const Declaration *declaration) {
    bool first = !interface->output[0], chosen = false;
    for (int i = declaration->start; i < declaration->type; i++) {
        chosen |= is(interface, i, "location") && is(interface, i + 2, "0");
        take(interface, i);
    }
    if (!first && !chosen) return;
    snprintf(interface->output, sizeof interface->output, "%.*s", size_at(interface, declaration->name),
             word_at(interface, declaration->name));
    snprintf(interface->output_type, sizeof interface->output_type, "%.*s",
             size_at(interface, declaration->type), word_at(interface, declaration->type));
}

static bool read_declaration(ToyInterface *interface, const Declaration *declaration, Error *error) {
    if (is(interface, declaration->kind, "uniform")) return read_uniforms(interface, declaration, error);
    if (is(interface, declaration->kind, "out")) {
        read_output(interface, declaration);
        return true;
    }
    /* Such as `layout(origin_upper_left) in vec4 gl_FragCoord;`. */
    bool built_in = strncmp(word_at(interface, declaration->name), "gl_", 3) == 0;
    if (declaration->kind >= 0 && built_in) {
        take_all(interface, declaration->start, declaration->end);
        return true;
    }
    if (declaration->kind >= 0) {
        return refuse(
            interface, declaration->name,
            "would come from a vertex shader, and there is none: take gl_FragCoord.xy / iResolution.xy "
            "for a place in the picture from 0 to 1",
            error);
    }
    return true;
}

/* A variable or a function may have the name of one of Shadertoy's inputs. */
static void read_name(ToyInterface *interface, const Declaration *declaration) {
    const ToyInput *input = toy_input_find(interface->tokens, declaration->name);
    if (input && !input->value && glsl_token_is_word(interface->tokens, declaration->type))
        take_name(interface, declaration->name);
}

/* Reads what stands outside of functions from token `i` on, and returns the token behind it. */
static int read_outside(const ToyInterface *interface, int i, Declaration *declaration) {
    const GlslTokens *tokens = interface->tokens;
    *declaration = (Declaration){.start = i, .kind = -1, .end = -1};
    for (bool qualifies = true; qualifies;) {
        bool layout = is(interface, i, "layout"), kind = glsl_token_among(tokens, i, kinds);
        qualifies = layout || kind || glsl_token_among(tokens, i, other_words);
        if (kind) declaration->kind = i;
        if (qualifies) i = glsl_token_next(tokens, i);
        if (layout && i < tokens->count) i = glsl_token_skip(tokens, i);
    }
    declaration->type = i;
    declaration->name = i < tokens->count ? glsl_token_next(tokens, i) : i;
    while (i < tokens->count && !is(interface, i, ";") && !is(interface, i, "{"))
        i = glsl_token_next(tokens, i);
    if (i < tokens->count && is(interface, i, ";")) {
        int name = glsl_token_next(tokens, declaration->type),
            behind = name < i ? glsl_token_next(tokens, name) : i;
        if (glsl_token_is_word(tokens, declaration->type) && glsl_token_is_word(tokens, name) &&
            !is(interface, behind, "("))
            declaration->end = i;
        return glsl_token_next(tokens, i);
    }
    return i < tokens->count ? glsl_token_skip(tokens, i) : i;
}

/* What has another name in GLSL 3.30, or is this program's. */
static const char *new_name(const ToyInterface *interface, int i) {
    static const char *const names[][2] = {
        {"gl_FragColor", "shadertoy_color"}, {"gl_FragCoord", "shadertoy_coord"},
        {"main", "shadertoy_main"},          {"texture2D", "texture"},
        {"texture2DLod", "textureLod"},      {"texture2DLodEXT", "textureLod"},
        {"texture2DGradEXT", "textureGrad"}, {"texture2DProj", "textureProj"},
        {"backbuffer", "iChannel0"}};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        if (is(interface, i, names[k][0])) return names[k][1];
    }
    return is(interface, i, "iGlobalTime") && interface->renames_time ? "iTime" : NULL;
}

static bool is_taken(const ToyInterface *interface, int i) {
    return names_find(&interface->taken, word_at(interface, i), (size_t)size_at(interface, i)) >= 0;
}

static bool is_own(const ToyInterface *interface, int i) {
    return glsl_source_is_own(interface->source, interface->tokens->list[i].file,
                              interface->file->sources->folder);
}

static void rename_words(ToyInterface *interface) {
    static const char *const black[] = {"iChannel1", "iChannel2", "iChannel3", NULL};
    bool noted = false;
    for (int i = 0; i < interface->tokens->count; i++) {
        const GlslToken *token = &interface->tokens->list[i];
        if (token->kind != GLSL_WORD || !is_own(interface, i)) continue;
        const char *name = new_name(interface, i);
        if (name)
            text_edits_add(interface->edits, token->at, token->size, "%s", name);
        else if (is_taken(interface, i))
            put(interface, i, "own_");
        if (!noted && !is(interface, i - 1, "#") && glsl_token_among(interface->tokens, i, black))
            note(interface, i, "is black: iChannel0 is the frame before, and there are no other channels"),
                noted = true;
    }
}

static void write_call(ToyInterface *interface) {
    Text *call = &interface->call;
    if (!interface->has_main) {
        text_print(call, "mainImage(shadertoy_color, shadertoy_coord.xy);");
        return;
    }
    text_print(call, "shadertoy_main();");
    if (!interface->output[0]) return;
    bool three = strcmp(interface->output_type, "vec3") == 0;
    text_print(call, " shadertoy_color = vec4(%s%s);", interface->output, three ? ", 1.0" : "");
}

bool toy_interface_read(ToyInterface *interface, Error *error) {
    const GlslTokens *tokens = interface->tokens;
    bool declares_time = false;
    for (int i = 0; i < tokens->count;) {
        if (tokens->list[i].directive || !is_own(interface, i)) {
            i++;
            continue;
        }
        Declaration declaration;
        int next = read_outside(interface, i, &declaration);
        interface->has_main |=
            is(interface, declaration.type, "void") && is(interface, declaration.type + 1, "main");
        declares_time |= declaration.end >= 0 && is(interface, declaration.name, "iGlobalTime");
        if (declaration.kind < 0) read_name(interface, &declaration);
        if (declaration.end >= 0 && !read_declaration(interface, &declaration, error)) return false;
        i = next;
    }
    interface->renames_time = !declares_time;
    rename_words(interface);
    write_call(interface);
    return true;
}

void toy_interface_free(ToyInterface *interface) {
    text_free(&interface->call);
    text_free(&interface->notes);
    names_free(&interface->taken);
}
