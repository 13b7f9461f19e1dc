#include "scene/mist.h"

#include <string.h>

static void write_function(Text *text, const char *type, const char *name, const char *const *words,
                           int count) {
    text_print(text, "%s %s() {\n    return %s(", type, name, type);
    for (int i = 0; i < count; i++) text_print(text, "%sfloat(%s)", i ? ", " : "", words[i]);
    text_print(text, ");\n}\n");
}

static void write_one(Text *text, const Mist *mist, const char *name, MistWord word) {
    const char *value = mist->words[word][0] ? mist->words[word] : "0.0";
    write_function(text, "float", name, &value, 1);
}

static void write_three(Text *text, const Mist *mist, const char *name, const int *words) {
    const char *values[3];
    for (int i = 0; i < 3; i++) {
        bool there = words[i] >= 0 && mist->words[words[i]][0];
        values[i] = there ? mist->words[words[i]] : "0.0";
    }
    write_function(text, "vec3", name, values, 3);
}

bool mist_is_coloured(const Mist *mist) {
    const char(*words)[64] = &mist->words[MIST_EXTINCTION];
    return words[1][0] && !(strcmp(words[0], words[1]) == 0 && strcmp(words[1], words[2]) == 0);
}

/* The largest of the three extinctions, and their shares of it. Without a colour the second is 1. */
static void write_extinction(Text *text, const Mist *mist) {
    static const int words[] = {MIST_EXTINCTION, MIST_EXTINCTION + 1, MIST_EXTINCTION + 2};
    if (!mist_is_coloured(mist)) {
        write_one(text, mist, "mist_extinction", MIST_EXTINCTION);
        text_print(text, "vec3 mist_tint() {\n    return vec3(1.0);\n}\n");
        return;
    }
    write_three(text, mist, "mist_extinctions", words);
    text_print(text,
               "float mist_extinction() {\n    vec3 e = mist_extinctions();\n"
               "    return max(max(e.x, e.y), e.z);\n}\n"
               "vec3 mist_tint() {\n    return mist_extinctions() / max(mist_extinction(), 1.0e-30);\n}\n");
}

void mist_write(const Mist *mist, Text *text) {
    static const int albedo[] = {MIST_ALBEDO, MIST_ALBEDO + 1, MIST_ALBEDO + 2};
    static const int none[] = {-1, -1, -1}, height[] = {-1, MIST_REGION, -1};
    static const int centre[] = {MIST_REGION, MIST_REGION + 1, MIST_REGION + 2};
    static const int radius[] = {MIST_REGION + 3, MIST_REGION + 3, MIST_REGION + 3};
    static const int half_size[] = {MIST_REGION + 3, MIST_REGION + 4, MIST_REGION + 5};
    static const int *const middles[] = {none, centre, centre, height};
    static const int *const reaches[] = {none, radius, half_size, none};
    write_extinction(text, mist);
    write_three(text, mist, "mist_albedo", albedo);
    write_one(text, mist, "mist_forward", MIST_FORWARD);
    write_one(text, mist, "mist_falloff", MIST_FALLOFF);
    write_one(text, mist, "mist_base", MIST_BASE);
    write_three(text, mist, "mist_middle", middles[mist->shape]);
    write_three(text, mist, "mist_reach", reaches[mist->shape]);
}

/* A key and its words, those that are there. */
static void describe(const Mist *mist, Text *text, const char *key, int first, int count) {
    text_print(text, " %s", key);
    for (int i = first; i < first + count; i++)
        text_print(text, " %s", mist->words[i][0] ? mist->words[i] : "0");
}

void mist_describe(const Mist *mist, Text *text) {
    static const struct {
        const char *key;
        int count;
    } shapes[] = {[MIST_SPHERE] = {"sphere", 4}, [MIST_BOX] = {"box", 6}, [MIST_BELOW] = {"below", 1}};
    text_print(text, "mist");
    describe(mist, text, "extinction", MIST_EXTINCTION, mist->words[MIST_EXTINCTION + 1][0] ? 3 : 1);
    describe(mist, text, "albedo", MIST_ALBEDO, 3);
    describe(mist, text, "g", MIST_FORWARD, 1);
    if (mist->shanks) text_print(text, " phase shanks");
    if (mist->falls) describe(mist, text, "falloff", MIST_FALLOFF, 1);
    if (mist->falls) describe(mist, text, "base", MIST_BASE, 1);
    if (mist->shape) describe(mist, text, shapes[mist->shape].key, MIST_REGION, shapes[mist->shape].count);
}
