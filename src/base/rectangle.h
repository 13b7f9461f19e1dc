#pragma once

/* The pixels [x, x + width) x [y, y + height). A rectangle is empty if its width or height is 0. */
typedef struct Rectangle {
    int x, y, width, height;
} Rectangle;
