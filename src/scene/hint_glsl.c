#include "scene/hint_glsl.h"

#include "source/glsl_log.h"
#include "source/glsl_scan.h"

/* Puts the place of a line of the text in front of the error. */
static bool fail_at(const GlslSource *source, int line, Error *error) {
    int file, number;
    if (!glsl_source_place(source, line, &file, &number)) return false;
    return error_prefix(error, "%s:%d: ", glsl_source_file(source, file), number);
}

static bool find_kind(SceneFile *file, const GlslSource *source, const GlslScan *scan, HintKind kind,
                      Error *error) {
    const HintInfo *info = hint_info(kind);
    HintList *hints = &file->hints[kind];
    int count = 0;
    int function = glsl_scan_definition_line(scan, info->function);
    int constant = glsl_scan_constant(scan, info->constant, &count);
    if (!function && !constant) return true;
    if (!constant) {
        error_set(error, STATUS_SCENE, "%s() needs `const int %s = NUMBER;`", info->function, info->constant);
        return fail_at(source, function, error);
    }
    if (!function) {
        error_set(error, STATUS_SCENE, "%s needs `%s %s(int i)`", info->constant, info->type, info->function);
        return fail_at(source, constant, error);
    }
    if (count < 0 || count > MOST_HINTS) {
        error_set(error, STATUS_SCENE, "%s is not a whole number in digits, from 0 to %d", info->constant,
                  MOST_HINTS);
        return fail_at(source, constant, error);
    }
    if (hints->count) {
        return error_set(error, STATUS_SCENE, "%s:%d: %s: the scene defines %s() itself: one of the two",
                         file->path, hints->list[0].line, info->key, info->function);
    }
    hints->count = count;
    hints->in_glsl = true;
    return true;
}

bool hint_glsl_find(SceneFile *file, const GlslSource *source, Error *error) {
    GlslScan scan = glsl_scan(text_string(&source->text));
    bool ok = true;
    for (int kind = 0; ok && kind < HINT_KINDS; kind++)
        ok = find_kind(file, source, &scan, (HintKind)kind, error);
    glsl_scan_free(&scan);
    return ok;
}
