#include "math/finite.glsl"
#include "shape/march_field.glsl"
#include "shape/search.glsl"

// Returns the length of the next step from the middle of an empty ball. If the surface is flat, the next empty ball touches this one.
// `fall` is how much the field fell per metre of the last step. From Balint and Valasek 2018, "Accelerating Sphere Tracing", after
// Hart 1996 and Keinert et al. 2014.
float march_step(float radius, float fall) {
    return radius * (1.0 + 0.9 * min((1.0 - fall) / max(1.0 + fall, 0.2), 4.0));
}

// Takes the steps of a march that are left, until it is on the surface or at the end. `size` is the least value that stands for the size of coordinates.
//
// The ray is known to be empty up to t, and so is a ball about the point at t with the field's value as radius. The empty ball after the next
// step must touch this ball. If it does not, there is a gap between them, and the step is taken again with the radius alone. A step that went
// beyond the surface is taken back, too.
March march_careful(Ray ray, March march, float start, float end, float size) {
    float t = march.t;
    float value = march.value;
    float side = march.side;
    float step = march.step;
    float field = march.field;
    float found = march.found;
    // The field's largest change per metre so far.
    float steepness = 1.0;
    // A place where the ray is known to be past a surface.
    float beyond = INFINITY;
    float leap = 1.0;
    bool leaping = false;
    // Says whether the step is longer than the part of the ray that is known to be empty.
    bool bold = false;
    bool more = march.more;
    int steps = march.steps;
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
        // The tolerance is there because t is rounded.
        bool relaxed = moved > 1.001 * plain + 0.5 * tolerance;
        bool touching = !started || !relaxed || moved * steepness <= value + abs(d) || bold;

        if (side == 0.0) {
            // The ray still runs along the surface that it leaves.
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
                float late = float(steps) / float(MARCH_CAREFUL);
                step = max(step, MARCH_THIN * late * late * (max(march_size(p), size) + t));
            }
            more = t + radius < end;
            step = beyond < INFINITY ? min(step, (bold ? 0.5 : 1.0) * (beyond - t)) : step;
        }
        more = more && t < end && found >= INFINITY;
    }
    // If the field is steeper than a distance, the march went on in shorter steps, but may have stepped over a surface before it knew. If the field
    // is not a number, the march ended there.
    if (steepness > 1.0 || !is_finite(vec3(field))) search_broken += 1;
    // The ray grazed a surface, took all of its steps, and ended in leaps. It may have missed what is thinner than a leap.
    if (leaping) search_cut += 1;
    found = found < INFINITY || !more ? found : beyond;
    return March(t, value, step, side, field, found, more, steps);
}
