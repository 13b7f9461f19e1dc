#include "distance/quadrilateral.glsl"

// Straight lines from point to point, as many as wanted, in a plane or in space:
//
//     Polyline line = polyline_start(p, vec3(0.0, 0.0, 0.0));
//     polyline_to(line, vec3(1.0, 0.0, 0.0));
//     polyline_to(line, vec3(1.0, 2.0, 0.0));
//     return op_round(distance_polyline(line), 0.1);
//
// op_round() makes a tube of it, which is exact outside.
struct Polyline {
    // Where the distance is asked for.
    vec3 p;
    vec3 first;
    vec3 last;
    // The square of the least distance so far.
    float square;
    // Whether a ray from p along x meets an odd number of the lines so far.
    bool odd;
};

Polyline polyline_start(vec3 p, vec3 first) {
    vec3 off = p - first;
    return Polyline(p, first, first, dot(off, off), false);
}

Polyline polyline_start(vec2 p, vec2 first) {
    return polyline_start(vec3(p, 0.0), vec3(first, 0.0));
}

// The square of the distance to a line between two points, which may be one.
float polyline_square(vec3 p, vec3 end, vec3 other_end) {
    vec3 along = other_end - end;
    vec3 off = p - end;
    off -= clamp(dot(off, along) / max(dot(along, along), 1.0e-30), 0.0, 1.0) * along;
    return dot(off, off);
}

// Goes on to the point `next`, which may be the last one again.
void polyline_to(INOUT(Polyline) line, vec3 next) {
    line.square = min(line.square, polyline_square(line.p, line.last, next));
    bool crosses = quadrilateral_crosses(vec2(line.p.x, line.p.y), vec2(line.last.x, line.last.y), vec2(next.x, next.y));
    line.odd = line.odd != crosses;
    line.last = next;
}

void polyline_to(INOUT(Polyline) line, vec2 next) {
    polyline_to(line, vec3(next, 0.0));
}

// The distance to the lines. It has no inside.
float distance_polyline(Polyline line) {
    return sqrt(line.square);
}

// The distance to the polygon in the plane whose corners are the points so far. They go around either way. Where the sides cross, what they go around
// twice is outside.
float distance_polygon(Polyline line) {
    polyline_to(line, line.first);
    return (line.odd ? -1.0 : 1.0) * sqrt(line.square);
}
