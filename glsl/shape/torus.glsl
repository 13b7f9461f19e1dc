#include "scene.glsl"

// Returns the distance to a torus and its derivative along the ray. `p` is relative to the torus's centre.
vec2 torus_distance(vec3 p, vec3 direction, vec3 axis, float major, float minor) {
    float height = dot(p, axis);
    vec3 across = p - height * axis;
    float radius = max(length(across), 1.0e-30);
    float reach = max(length(vec2(radius - major, height)), 1.0e-30);
    float change = (radius - major) * dot(across, direction) / radius + height * dot(axis, direction);
    return vec2(reach - minor, change / reach);
}

// Returns the root of 4 t^3 + 2 c t + d between low and high, or high if there is none. A rough root is enough: see hit_torus().
float torus_turn(float c, float d, float low, float high) {
    float at_low = (4.0 * low * low + 2.0 * c) * low + d;
    float at_high = (4.0 * high * high + 2.0 * c) * high + d;
    if (at_low * at_high > 0.0) return high;
    float t = 0.5 * (low + high);
    for (int i = 0; i < 10; i++) {
        float value = (4.0 * t * t + 2.0 * c) * t + d;
        bool before = value * at_low > 0.0;
        low = before ? t : low;
        high = before ? high : t;
        float slope = 12.0 * t * t + 2.0 * c;
        float step = t - value / slope;
        float newton = slope != 0.0 ? step : low;
        float middle = 0.5 * (low + high);
        t = newton > low && newton < high ? newton : middle;
    }
    return t;
}

// Returns the place of the surface between low and high, which are on two sides of it. It takes Newton's steps on the distance, and halves the
// bracket where a step would leave it.
float torus_meet(vec3 near, vec3 direction, vec3 axis, float major, float minor, float low, float high, float side) {
    float t = 0.5 * (low + high);
    for (int i = 0; i < 24; i++) {
        vec2 d = torus_distance(near + t * direction, direction, axis, major, minor);
        bool before = d.x * side > 0.0;
        low = before ? t : low;
        high = before ? high : t;
        float step = t - d.x / d.y;
        float newton = d.y != 0.0 ? step : low;
        float middle = 0.5 * (low + high);
        float next = newton > low && newton < high ? newton : middle;
        if (abs(d.x) <= 1.2e-7 * minor || abs(next - t) <= 3.0e-8 * major) break;
        t = next;
    }
    return t;
}

// A ring about `axis`, which goes through `centre` and may have any length. The ring is a circle of the radius `major`, and all points within `minor`
// of it. `minor` is the smaller radius. The ring is seen from outside and from inside.
//
// A torus is the quartic t^4 + c t^2 + d t + e, if t counts from the ray's closest approach to the centre. Rounding spoils Ferrari's formula for
// the quartic's roots. Only its turning points are therefore computed. Between two of them the distance to the torus has one root or none,
// and the distance has lost no digits. A turning point with a small error makes a ray miss only what is thinner than that error squared.
void hit_torus(Ray ray, vec3 centre, vec3 axis, float major, float minor, int object, INOUT(Hit) hit) {
    axis = normalize(axis);
    vec3 to_centre = centre - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 near = middle * ray.direction - to_centre;
    // The sphere about the ring is a little larger than the ring, so that a ray leaves the ring before it leaves the sphere, also by rounding.
    float outer = 1.0001 * (major + minor);
    float miss = dot(near, near);
    if (miss >= outer * outer) return;
    float end = sqrt(outer * outer - miss);
    float start = max(-middle, -end);
    if (start >= end) return;

    float height = dot(near, axis);
    float climb = dot(ray.direction, axis);
    float c = 2.0 * (miss + major * major - minor * minor) - 4.0 * major * major * (1.0 - climb * climb);
    float d = 8.0 * major * major * height * climb;
    float bend = min(sqrt(max(-c / 6.0, 0.0)), end);
    float turn0 = torus_turn(c, d, -end, -bend);
    float turn1 = torus_turn(c, d, -bend, bend);
    float turn2 = torus_turn(c, d, bend, end);

    float low = start;
    float side = torus_distance(near + start * ray.direction, ray.direction, axis, major, minor).x < 0.0 ? -1.0 : 1.0;
    bool found = false;
    float high = end;
    for (int i = 0; i < 4 && !found; i++) {
        high = i == 0 ? turn0 : (i == 1 ? turn1 : (i == 2 ? turn2 : end));
        if (high > low) {
            found = side * torus_distance(near + high * ray.direction, ray.direction, axis, major, minor).x < 0.0;
            low = found ? low : high;
        }
    }
    if (!found) return;
    float meet = torus_meet(near, ray.direction, axis, major, minor, low, high, side);
    float t = middle + meet;
    if (t > 0.0 && t < hit.t) {
        vec3 p = near + meet * ray.direction;
        vec3 across = p - dot(p, axis) * axis;
        hit.t = t;
        hit.normal = normalize(p - major * normalize(across));
        hit.object = object;
    }
}
