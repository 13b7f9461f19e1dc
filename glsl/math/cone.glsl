#include "math/frame.glsl"

// The cone of directions in which a sphere is seen from outside.
struct Cone {
    vec3 axis;
    // 1 - cos(half angle), computed without cancellation. It is 0 if the point is inside the sphere.
    float one_less_cos;
};

Cone cone_toward(vec3 from, vec3 centre, float radius) {
    vec3 to_centre = centre - from;
    float squared = max(dot(to_centre, to_centre), 1.0e-30);
    float sine_squared = radius * radius / squared;
    float one_less_cos = sine_squared / (1.0 + sqrt(max(1.0 - sine_squared, 0.0)));
    return Cone(to_centre * inversesqrt(squared), sine_squared < 1.0 ? one_less_cos : 0.0);
}

// Draws a direction that is uniform by solid angle. u is in [0,1)^2.
vec3 cone_sample(Cone cone, vec2 u) {
    float less = u.x * cone.one_less_cos;
    float sine = sqrt(max(less * (2.0 - less), 0.0));
    float phi = 2.0 * PI * u.y;
    return normalize(in_frame(cone.axis, sine * cos(phi), sine * sin(phi), 1.0 - less));
}

bool cone_holds(Cone cone, vec3 direction) {
    // 1 - cos is computed from the chord between the two directions, which loses no digits.
    vec3 off = direction - cone.axis;
    return 0.5 * dot(off, off) < cone.one_less_cos;
}

float cone_pdf(Cone cone, vec3 direction) {
    float density = 1.0 / (2.0 * PI * cone.one_less_cos);
    return cone_holds(cone, direction) ? density : 0.0;
}
