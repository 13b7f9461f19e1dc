#include "math/dialect.glsl"

// A rectangle as a point before it sees it. Its directions are drawn uniformly by solid angle (Urena, Fajardo and King 2013, "An
// Area-Preserving Parametrization for Spherical Rectangles"). A small one is drawn uniformly by area instead, which is nearly the same
// there: the solid angle is a sum of four angles, and float has too few digits for a small sum.
struct RectangleView {
    // Unit vectors along the edges, and the one that the rectangle faces.
    vec3 along;
    vec3 up;
    vec3 facing;
    // How far the point is in front of the rectangle's plane. It is 0 or less if the rectangle is not seen.
    float depth;
    // The corners in the plane, along the two edges, from the point's foot.
    vec2 low;
    vec2 high;
    // In sr; 0 if the rectangle is not seen.
    float solid_angle;
};

// Below this solid angle, sr, the rectangle is drawn by area.
const float RECTANGLE_SMALL = 0.03;

// The solid angle of the rectangle between the foot of a point and a corner, with the sign of x y.
float rectangle_corner(float x, float y, float depth) {
    return atan(x * y / (depth * sqrt(x * x + y * y + depth * depth)));
}

// The solid angle of a strip of the rectangle, from the point's foot to x.
float rectangle_strip(RectangleView view, float x) {
    return rectangle_corner(x, view.high.y, view.depth) - rectangle_corner(x, view.low.y, view.depth);
}

// A rectangle that faces a direction given by azimuth and elevation, degrees. Its width is level. The columns are its centre and two half
// edges, whose cross product is where it faces.
mat3 rectangle_facing(float x, float y, float z, float azimuth, float elevation, float width, float height) {
    float a = radians(azimuth);
    float e = radians(elevation);
    vec3 along = vec3(cos(a), 0.0, -sin(a));
    vec3 up = vec3(-sin(e) * sin(a), cos(e), -sin(e) * cos(a));
    return mat3(vec3(x, y, z), 0.5 * width * along, 0.5 * height * up);
}

// What a point sees of a rectangle, whose columns are those of rectangle_facing(). Only the part of the second edge
// that is perpendicular to the first one counts.
RectangleView rectangle_seen(mat3 rectangle, vec3 from) {
    vec3 across = cross(rectangle[1], rectangle[2]);
    vec3 facing = across * inversesqrt(max(dot(across, across), 1.0e-30));
    float half_width = length(rectangle[1]);
    vec3 along = rectangle[1] / max(half_width, 1.0e-15);
    vec3 up = cross(facing, along);
    vec3 centre = rectangle[0] - from;
    vec2 middle = vec2(dot(centre, along), dot(centre, up));
    vec2 reach = vec2(half_width, dot(rectangle[2], up));
    RectangleView view = RectangleView(along, up, facing, -dot(centre, facing), middle - reach, middle + reach, 0.0);
    if (view.depth > 0.0) view.solid_angle = max(rectangle_strip(view, view.high.x) - rectangle_strip(view, view.low.x), 0.0);
    return view;
}

float rectangle_area(RectangleView view) {
    return (view.high.x - view.low.x) * (view.high.y - view.low.y);
}

// The place in the plane that a direction of a uniform solid angle has. With c = x / sqrt(x^2 + depth^2) and s of y likewise, a corner's
// solid angle is asin(c s), and the strip's is strip = asin(c s_high) - asin(c s_low), which is solved for c.
vec2 rectangle_place(RectangleView view, vec2 u) {
    float depth2 = view.depth * view.depth;
    float start = rectangle_strip(view, view.low.x);
    float strip = start + u.x * view.solid_angle;
    float s_low = view.low.y * inversesqrt(view.low.y * view.low.y + depth2);
    float s_high = view.high.y * inversesqrt(view.high.y * view.high.y + depth2);
    float upper = s_high - s_low * cos(strip);
    float lower = s_low * sin(strip);
    float c = sin(strip) * inversesqrt(max(upper * upper + lower * lower, 1.0e-30));
    float x = clamp(view.depth * c * inversesqrt(max(1.0 - c * c, 1.0e-12)), view.low.x, view.high.x);
    float row2 = x * x + depth2;
    float h_low = view.low.y * inversesqrt(view.low.y * view.low.y + row2);
    float h_high = view.high.y * inversesqrt(view.high.y * view.high.y + row2);
    float h = mix(h_low, h_high, u.y);
    float y = h * sqrt(row2) * inversesqrt(max(1.0 - h * h, 1.0e-12));
    return vec2(x, clamp(y, view.low.y, view.high.y));
}

// A direction toward the rectangle, which has to be seen, from u in [0,1)^2.
vec3 rectangle_sample(RectangleView view, vec2 u) {
    vec2 place = vec2(mix(view.low.x, view.high.x, u.x), mix(view.low.y, view.high.y, u.y));
    if (view.solid_angle >= RECTANGLE_SMALL) place = rectangle_place(view, u);
    return normalize(place.x * view.along + place.y * view.up - view.depth * view.facing);
}

// The density of rectangle_sample() at a direction, 1/sr.
float rectangle_pdf(RectangleView view, vec3 direction) {
    float toward = -dot(direction, view.facing);
    // Distance along the direction.
    float far = view.depth / max(toward, 1.0e-20);
    vec2 place = far * vec2(dot(direction, view.along), dot(direction, view.up));
    bool inside = place.x >= view.low.x && place.x <= view.high.x && place.y >= view.low.y && place.y <= view.high.y;
    if (!(view.solid_angle > 0.0 && toward > 0.0 && inside)) return 0.0;
    return view.solid_angle >= RECTANGLE_SMALL ? 1.0 / view.solid_angle : far * far / (rectangle_area(view) * toward);
}
