// A point of light that is added to one pixel of the picture's second sum (src/gl/film_light.h).
#include "math/dialect.glsl"

// The pixel at a place, in pixels from the picture's top left corner. The bits are the column and, from bit 14 on, the row. With the bit above them they are
// those of a float that no processor takes for zero or for no number.
float light_point_pixel(vec2 place) {
    return uintBitsToFloat(0x40000000u | (uint(place.y) << 14u) | uint(place.x));
}
