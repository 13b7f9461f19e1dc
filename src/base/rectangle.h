#pragma once

/* Pixels [x, x + width) x [y, y + height); empty where a side is 0. */
typedef struct Rectangle {
    int x, y, width, height;
} Rectangle;
