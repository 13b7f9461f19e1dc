#include "math/finite.glsl"
#include "scene.glsl"
#include "shape/search.glsl"

// The surface where a distance field is 0. The scene defines
//
//     float scene_distance(vec3 p)    how far p is from the surface, m; negative inside the solid. Never more than that.
//
// for instance of distance/, and calls march() among its hit_NAME(). A ray that starts inside a solid finds its way out.
// The numbers in a field (a centre, a radius) should not be far larger than the distances looked from, or than the sphere
// that march() is told: float's roundings grow with them.
float scene_distance(vec3 p);

// One march asks the field MARCH_STEPS times at most, and 6 times for the normal; most rays are done after some twenty, those
// that pass a surface by a millionth of their length need a thousand.
const int MARCH_STEPS = 2048;
const int MARCH_CAREFUL = 192;          // of these: the first ones, which miss nothing. Then a ray along a surface takes steps of at least
const float MARCH_THIN = 3.0e-5;        // of the coordinates, and may miss what is thinner;
const int MARCH_LEAPS = 32;             // and the last ones of a ray that would not end otherwise are leaps.
const float MARCH_FAR = 1.0e6;          // m; no surface is sought farther
const float MARCH_PRECISION = 4.0e-7;   // of the coordinates and the distance: 7 float roundings, a fifth of ray_from()'s lift
const float MARCH_NORMAL_STEP = 2.44140625e-4; // of the coordinates: roundings and curvature cost a normal about as much
const float MARCH_STEEP = 1.1;          // metres a metre; a field that changes faster is no distance

float march_size(vec3 p) {
    vec3 size = abs(p);
    return max(max(size.x, size.y), size.z);
}

// The field's gradient by central differences, over the points that rounding leaves at p +- h. In a loop, so that the field
// is compiled once for it.
vec3 march_gradient(vec3 p, float h) {
    vec3 high = p + h;
    vec3 low = p - h;
    vec3 change = vec3(0.0);
    for (int i = 0; i < 6; i++) {
        vec3 q = vec3(i == 0 ? high.x : (i == 3 ? low.x : p.x), i == 1 ? high.y : (i == 4 ? low.y : p.y),
                      i == 2 ? high.z : (i == 5 ? low.z : p.z));
        vec3 axis = vec3(i % 3 == 0 ? 1.0 : 0.0, i % 3 == 1 ? 1.0 : 0.0, i % 3 == 2 ? 1.0 : 0.0);
        change += (i < 3 ? scene_distance(q) : -scene_distance(q)) * axis;
    }
    return change / (high - low);
}

// How far to go from the middle of an empty ball: to where the next ball touches this one, if the surface is flat. `fall` is
// what the field lost by a metre on the last step. Balint and Valasek 2018, "Accelerating Sphere Tracing", after Hart 1996
// and Keinert et al. 2014.
float march_step(float radius, float fall) {
    return radius * (1.0 + 0.9 * min((1.0 - fall) / max(1.0 + fall, 0.2), 4.0));
}

// The first t in (start, end) on the surface, or INFINITY. `size` is the least that coordinates near there count as; `field` is
// what the field gave there.
//
// At t, where all is empty up to, a ball of `radius` is empty too. The next ball must touch it, or there is a gap, and the step
// is taken again at the radius alone. A step back from beyond the surface, too.
float march_along(Ray ray, float start, float end, float size, OUT(float) field, OUT(float) side) {
    float t = start;
    float value = 0.0;     // the field at t, positive on the ray's side
    side = 0.0;            // while the ray is on the surface that it leaves
    float step = 0.0;
    float steepness = 1.0; // the field's largest change by a metre so far
    float beyond = INFINITY; // where the ray is known to be past a surface
    float found = INFINITY;
    float leap = 1.0;
    bool leaping = false;
    bool bold = false; // whether the step is longer than what is known to be empty
    bool more = start < end;
    int steps = 0;
    while (steps < MARCH_STEPS && more) {
        leaping = steps >= MARCH_STEPS - MARCH_LEAPS;
        steps += 1;
        float next = min(t + step, end);
        float moved = next - t;
        vec3 p = ray.origin + next * ray.direction;
        float tolerance = MARCH_PRECISION * (max(march_size(p), size) + next);
        field = scene_distance(p);
        bool started = side != 0.0;
        if (!started && (abs(field) > tolerance || start > 0.0)) side = field < 0.0 ? -1.0 : 1.0;
        float d = side * field;
        float change = abs(d - value);
        if (started && change > MARCH_STEEP * moved + 5.0 * tolerance) steepness = max(steepness, change / moved);
        float plain = value / steepness;
        bool relaxed = moved > 1.001 * plain + 0.5 * tolerance; // t is rounded
        bool touching = !started || !relaxed || moved * steepness <= value + abs(d) || bold;

        if (side == 0.0) { // along the surface that it leaves
            t = next;
            step = max(2.0 * step, tolerance);
        } else if (touching && abs(d) <= tolerance) {
            found = next;
        } else if (d < 0.0) {
            beyond = next;
            found = moved <= tolerance ? next : INFINITY;
            step = relaxed && !bold ? plain : 0.5 * moved;
        } else if (!touching) {
            step = plain;
        } else {
            t = next;
            float fall = started ? (value - d) / (steepness * max(moved, 1.0e-30)) : 1.0;
            value = d;
            float radius = value / steepness;
            // A short first step shows how steep the field is.
            step = started ? march_step(radius, clamp(fall, -1.0, 1.0)) : 0.25 * radius;
            bold = steps > MARCH_CAREFUL;
            if (leaping) {
                leap *= 2.0;
                step = leap * radius;
            } else if (bold) {
                step = max(step, MARCH_THIN * (max(march_size(p), size) + t));
            }
            more = t + radius < end;
            step = beyond < INFINITY ? min(step, (bold ? 0.5 : 1.0) * (beyond - t)) : step;
        }
        more = more && t < end && found >= INFINITY;
    }
    search_rays += 1;
    search_steps += steps;
    // In a field steeper than the distance it went on in shorter steps, but may have leapt over something; and a field that is
    // no number ends a march.
    if (steepness > 1.0 || !is_finite(vec3(field))) search_broken += 1;
    // By grazing a surface it took all its steps, and ended in leaps: it may have missed what is thinner than a leap.
    if (leaping) search_cut += 1;
    return found < INFINITY || !more ? found : beyond;
}

void march_between(Ray ray, float start, float end, float size, int object, INOUT(Hit) hit) {
    float field = 0.0;
    float side = 0.0;
    int broken = search_broken;
    float t = march_along(ray, start, min(min(end, hit.t), MARCH_FAR), size, field, side);
    if (t < INFINITY) {
        vec3 p = ray.origin + t * ray.direction;
        float near = max(march_size(p), size);
        vec3 gradient = march_gradient(p, MARCH_NORMAL_STEP * max(near, 0.25 * t));
        float steepness = length(gradient);
        if (steepness > MARCH_STEEP) search_broken = broken + 1;
        // What is left to the surface, along the tangent: much at grazing incidence.
        float slope = dot(gradient, ray.direction);
        float reach = 64.0 * MARCH_PRECISION * (near + t);
        float rest = abs(slope) > 1.0e-4 ? clamp(-field / slope, -reach, reach) : 0.0;
        hit.t = max(t + rest, 0.5 * t);
        vec3 normal = steepness > 0.0 ? gradient / steepness : -ray.direction;
        // On an edge the differences blend two sides: what then faces away from where the ray came from is turned until it
        // grazes, or the path would go on within the solid.
        float facing = side * dot(normal, ray.direction);
        hit.normal = facing < 0.0 ? normal : normalize(normal - side * (facing + 1.0e-3) * ray.direction);
        hit.object = object;
    }
}

// Marches to the field's surface.
void march(Ray ray, int object, INOUT(Hit) hit) {
    march_between(ray, 0.0, INFINITY, 0.0, object, hit);
}

// Marches only where the ray crosses a sphere, which contains all of the surface: rays that miss it cost nothing.
void march(Ray ray, vec3 centre, float radius, int object, INOUT(Hit) hit) {
    vec3 to_centre = centre - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 miss = to_centre - middle * ray.direction;
    // A little more, for what touches the sphere.
    float discriminant = 1.001 * radius * radius - dot(miss, miss);
    if (discriminant > 0.0) {
        float half_chord = sqrt(discriminant);
        float size = max(march_size(centre), radius);
        march_between(ray, max(middle - half_chord, 0.0), middle + half_chord, size, object, hit);
    }
}
