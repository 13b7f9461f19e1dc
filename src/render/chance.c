#include "render/chance.h"

#include <stdio.h>
#include <string.h>

bool chance_matters(const FilmChance *chance) {
    return chance->light >= 1e-3;
}

/* Writes a material's name. For mirrors it says which ones, because only some leave light to chance. */
static void write_name(const char *name, char *text, size_t size) {
    bool mirror = strcmp(name, "mirror") == 0;
    snprintf(text, size, "%s", mirror ? "mirrors that the scene does not name or that stand in a row" : name);
    for (char *c = text; *c; c++) {
        if (*c == '_') *c = ' ';
    }
}

void chance_throwers(const FilmChance *chance, const SceneNeeds *needs, char *text, size_t size) {
    enum { MOST = sizeof needs->materials / sizeof *needs->materials };
    int left = 0;
    size_t used = 0;
    for (int i = 0; i < MOST; i++) left += (int)(chance->materials >> i & 1);
    text[0] = 0;
    for (int i = 0; i < MOST && used < size; i++) {
        char name[80];
        if (!(chance->materials >> i & 1)) continue;
        write_name(needs->materials[i], name, sizeof name);
        const char *comma = !used ? "" : left == 1 ? " and " : ", ";
        used += (size_t)snprintf(text + used, size - used, "%s%s", comma, name);
        left--;
    }
}
