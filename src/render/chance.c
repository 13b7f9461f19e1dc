#include "render/chance.h"

#include <stdio.h>
#include <string.h>

/* A bit for each (gl/film.h). */
enum { MOST_MATERIALS = 32 };

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

void chance_throwers(const FilmChance *chance, const SceneFacts *facts, char *text, size_t size) {
    int left = 0;
    size_t used = 0;
    for (int i = 0; i < facts->material_count && i < MOST_MATERIALS; i++)
        left += (int)(chance->materials >> i & 1);
    text[0] = 0;
    for (int i = 0; i < facts->material_count && i < MOST_MATERIALS && used < size; i++) {
        char name[80];
        if (!(chance->materials >> i & 1)) continue;
        write_name(facts->materials[i], name, sizeof name);
        const char *comma = !used ? "" : left == 1 ? " and " : ", ";
        used += (size_t)snprintf(text + used, size - used, "%s%s", comma, name);
        left--;
    }
}
