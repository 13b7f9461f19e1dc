#pragma once

#include <stdbool.h>

/* The pixels [x, x + width) x [y, y + height). A rectangle is empty if its width or height is 0. */
typedef struct Rectangle {
    int x, y, width, height;
} Rectangle;

static inline bool rectangle_holds(const Rectangle *r, int x, int y) {
    return x >= r->x && x < r->x + r->width && y >= r->y && y < r->y + r->height;
}

/* The pixels that both have; its width and height are 0 if there are none. */
static inline Rectangle rectangle_overlap(const Rectangle *a, const Rectangle *b) {
    int x = a->x > b->x ? a->x : b->x, y = a->y > b->y ? a->y : b->y;
    int right = a->x + a->width < b->x + b->width ? a->x + a->width : b->x + b->width;
    int bottom = a->y + a->height < b->y + b->height ? a->y + a->height : b->y + b->height;
    return right > x && bottom > y ? (Rectangle){x, y, right - x, bottom - y} : (Rectangle){x, y, 0, 0};
}

static inline bool rectangle_same(const Rectangle *a, const Rectangle *b) {
    return a->x == b->x && a->y == b->y && a->width == b->width && a->height == b->height;
}
