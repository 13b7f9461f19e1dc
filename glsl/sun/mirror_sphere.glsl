// Distant light that a mirror sphere reflects to a point outside of it: Alhazen's problem. There is one reflection point, in the
// plane of the point and the light, at the angle phi from the light: r sin(2 phi - theta) = sin phi. Here r is the point's distance
// from the centre in radii, and theta its angle from the light. Newton's steps turn a unit vector, so no angle is ever computed.
#include "math/dialect.glsl"

struct SphereReflection {
    // The unit normal of the sphere at the reflection point, away from the centre.
    vec3 normal;
    // The direction of the reflected light, toward the point.
    vec3 direction;
    // The irradiance across the reflected light divided by that across the incoming light; at most 1.
    float focus;
};

// The angle's error is 1e-6 if the point is a twentieth of a radius off the sphere, and 1e-5 at a thousandth.
const int SPHERE_REFLECTION_STEPS = 6;

// `point` is in radii from the sphere's centre. `light` is a unit vector toward the light. The focus is 0 inside of the sphere and
// in its shadow.
SphereReflection sphere_reflection(vec3 point, vec3 light) {
    float r = length(point);
    float cos_theta = clamp(dot(point, light) / max(r, 1.0e-20), -1.0, 1.0);
    vec3 aside = point - dot(point, light) * light;
    float off = length(aside);
    float sin_theta = min(off / max(r, 1.0e-20), 1.0);
    // Any direction will do if the point lies exactly in the direction of the light.
    vec3 across = aside / max(off, 1.0e-20);
    bool outside = r > 1.0 && (cos_theta > 0.0 || off > 1.0);

    // The start is theta / 2 + asin(sin(theta / 2) / r) / 2, computed by half angles.
    float cos_half = sqrt(max(0.5 + 0.5 * cos_theta, 0.0));
    float sin_half = sqrt(max(0.5 - 0.5 * cos_theta, 0.0));
    float sine = min(sin_half / max(r, 1.0), 1.0);
    float turn_cos = sqrt(0.5 + 0.5 * sqrt(1.0 - sine * sine));
    float turn_sin = 0.5 * sine / turn_cos;
    float c = max(cos_half * turn_cos - sin_half * turn_sin, 0.0);
    float s = c > 0.0 ? sin_half * turn_cos + cos_half * turn_sin : 1.0;
    for (int i = 0; i < SPHERE_REFLECTION_STEPS; i++) {
        float sin_double = 2.0 * s * c;
        float cos_double = (c - s) * (c + s);
        float value = r * (sin_double * cos_theta - cos_double * sin_theta) - s;
        float slope = 2.0 * r * (cos_double * cos_theta + sin_double * sin_theta) - c;
        float turn = clamp(-value / max(slope, 0.05), -0.5, 0.5);
        vec2 turned = normalize(vec2(max(c - s * turn, 0.0), s + c * turn));
        c = turned.x;
        s = turned.y;
    }

    vec3 normal = c * light + s * across;
    vec3 direction = (c - s) * (c + s) * light + 2.0 * s * c * across;
    // The distance from the reflection point, in radii.
    float t = dot(point - normal, direction);
    bool lit = outside && t > 0.0;
    float focus = lit ? c / ((c + 2.0 * t) * (1.0 + 2.0 * t * c)) : 0.0;
    return SphereReflection(normal, direction, focus);
}
