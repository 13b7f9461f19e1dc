#include "image/sun_pixels.h"

#include "base/rectangle.h"

#include <ctype.h>
#include <stddef.h>
#include <string.h>

/* The length of the run of pixels that begins at x; 0 if none begins there. */
static int run_length(const unsigned char *row, int width, int x) {
    if (x > 0 && row[x - 1]) return 0;
    int end = x;
    while (end < width && row[end]) end++;
    return end - x;
}

void sun_pixels_print(const unsigned char *mask, int width, int height, Text *text) {
    const char *blank = "";
    for (int y = 0; y < height; y++) {
        const unsigned char *row = mask + (size_t)y * (size_t)width;
        for (int x = 0; x < width; x++) {
            int length = run_length(row, width, x);
            if (!length) continue;
            /* A run that is equal to the one above belongs to the rectangle of that one. */
            if (y > 0 && run_length(row - width, width, x) == length) continue;
            int rows = 1;
            while (y + rows < height && run_length(row + (ptrdiff_t)rows * width, width, x) == length) rows++;
            text_print(text, "%s%d,%d,%d,%d", blank, x, y, length, rows);
            blank = " ";
        }
    }
}

/* Reads a whole number and the character behind it, which may be the text's end. */
static bool take_number(const char **text, char behind, int *value) {
    enum { MOST = 99999999 };
    const char *c = *text;
    if (!isdigit((unsigned char)*c)) return false;
    for (*value = 0; isdigit((unsigned char)*c); c++) {
        if (*value > MOST) return false;
        *value = 10 * *value + (*c - '0');
    }
    if (*c != behind) return false;
    *text = behind ? c + 1 : c;
    return true;
}

static bool take_rectangle(const char **text, char behind, Rectangle *r) {
    return take_number(text, ',', &r->x) && take_number(text, ',', &r->y) &&
           take_number(text, ',', &r->width) && take_number(text, behind, &r->height);
}

bool sun_pixels_parse(const char *text, unsigned char *mask, int width, int height, Error *error) {
    for (const char *rest = text; *rest;) {
        Rectangle r = {0};
        const char *word = rest;
        size_t length = strcspn(word, " ");
        /* A blank has another rectangle behind it. */
        if (!take_rectangle(&rest, word[length], &r) || (word[length] && !*rest))
            return error_set(error, STATUS_FAILURE, "sun pixels: '%.*s' is not 'X,Y,WIDTH,HEIGHT'",
                             (int)(length < 60 ? length : 60), word);
        if (!r.width || !r.height || r.width > width - r.x || r.height > height - r.y)
            return error_set(error, STATUS_FAILURE,
                             "sun pixels: '%.*s' is not inside of the picture of %dx%d", (int)length, word,
                             width, height);
        for (int y = r.y; y < r.y + r.height; y++)
            memset(mask + (size_t)y * (size_t)width + r.x, 1, (size_t)r.width);
    }
    return true;
}

void sun_pixels_describe(const unsigned char *mask, int width, int height, AttributeList *list) {
    Text text = {0};
    sun_pixels_print(mask, width, height, &text);
    if (*text_string(&text)) attribute_add(list, SUN_PIXELS_ATTRIBUTE, "%s", text_string(&text));
    text_free(&text);
}
