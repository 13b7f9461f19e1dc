#include "math/dialect.glsl"

// `count` copies of a solid around the y axis. The solid itself lies toward x, and must stay within the angle PI / count to each side. Take the least of
// i = 0 and i = 1, which are the copy in the sector of p and the one on the side of the sector where p is:
//
//     min(distance_box(repeat_polar(p, 7.0, 0), ...), distance_box(repeat_polar(p, 7.0, 1), ...))
//
// The result is as exact as the distance of the solid.
vec3 repeat_polar(vec3 p, float count, int i) {
    float sector = 2.0 * PI / count;
    // On the axis every angle is right.
    float place = atan(p.z, abs(p.x) + abs(p.z) > 0.0 ? p.x : 1.0) / sector;
    float copy = floor(place + 0.5);
    float aside = place < copy ? -1.0 : 1.0;
    float angle = (copy + float(i) * aside) * sector;
    float c = cos(angle);
    float s = sin(angle);
    return vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
}
