#include "image/label.h"

#include <stddef.h>
#include <string.h>

/* The rows of a letter, each of 3 points. */
typedef struct Glyph {
    char letter;
    const char *rows[LABEL_HEIGHT];
} Glyph;

static const Glyph glyphs[] = {
    {'0', {"###", "# #", "# #", "# #", "###"}}, {'1', {" # ", "## ", " # ", " # ", "###"}},
    {'2', {"###", "  #", "###", "#  ", "###"}}, {'3', {"###", "  #", "###", "  #", "###"}},
    {'4', {"# #", "# #", "###", "  #", "  #"}}, {'5', {"###", "#  ", "###", "  #", "###"}},
    {'6', {"###", "#  ", "###", "# #", "###"}}, {'7', {"###", "  #", "  #", "  #", "  #"}},
    {'8', {"###", "# #", "###", "# #", "###"}}, {'9', {"###", "# #", "###", "  #", "###"}},
    {'+', {"   ", " # ", "###", " # ", "   "}}, {'-', {"   ", "   ", "###", "   ", "   "}},
    {'.', {"   ", "   ", "   ", "   ", " # "}}, {'A', {" # ", "# #", "###", "# #", "# #"}},
    {'B', {"## ", "# #", "## ", "# #", "## "}}, {'E', {"###", "#  ", "## ", "#  ", "###"}},
    {'L', {"#  ", "#  ", "#  ", "#  ", "###"}}, {'S', {" ##", "#  ", " # ", "  #", "## "}},
    {'V', {"# #", "# #", "# #", "# #", " # "}},
};

static void point_draw(Image *image, int left, int top, int scale, float grey) {
    for (int y = top; y < top + scale; y++) {
        for (int x = left; x < left + scale; x++) {
            if (x < 0 || y < 0 || x >= image->width || y >= image->height) continue;
            float *pixel = image->rgba + 4 * ((size_t)y * (size_t)image->width + (size_t)x);
            pixel[0] = pixel[1] = pixel[2] = grey;
        }
    }
}

static void glyph_draw(Image *image, const Glyph *glyph, int left, int top, int scale, float grey) {
    for (int y = 0; y < LABEL_HEIGHT; y++) {
        for (int x = 0; x < 3; x++) {
            if (glyph->rows[y][x] == '#') point_draw(image, left + x * scale, top + y * scale, scale, grey);
        }
    }
}

void label_draw(Image *image, const char *text, int left, int top, int scale, float grey) {
    for (; *text; text++, left += LABEL_ADVANCE * scale) {
        for (size_t i = 0; i < sizeof glyphs / sizeof *glyphs; i++) {
            if (glyphs[i].letter == *text) glyph_draw(image, &glyphs[i], left, top, scale, grey);
        }
    }
}
