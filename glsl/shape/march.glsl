#include "math/finite.glsl"
#include "scene.glsl"
#include "shape/search.glsl"

// The surface where a distance field is 0. The scene defines the field, for instance with the functions of distance/, and calls march() among
// its hit_NAME():
//
//     float scene_distance(vec3 p)    the distance from p to the surface in metres, or less; negative inside the solid
//
// A ray that starts inside a solid finds its way out.
// The numbers in a field (a centre, a radius) should not be much larger than the distance from which the surface is seen, or than the sphere
// that is given to march(). The rounding errors of float grow with these numbers.
float scene_distance(vec3 p);

// One march evaluates the field up to MARCH_STEPS times, and 6 times more for the normal. Most rays are done after some twenty steps. Rays
// that pass a surface at a millionth of their length need a thousand.
const int MARCH_STEPS = 2048;
// The first steps of a march, which miss nothing. After them a ray is bold: its steps are at least MARCH_THIN of the coordinates, and may miss what
// is thinner.
const int MARCH_CAREFUL = 192;
const float MARCH_THIN = 3.0e-5;
// The last steps of a ray that would not end otherwise. Each of these leaps is twice as long as the one before.
const int MARCH_LEAPS = 32;
// March does not look for surfaces beyond this distance, in metres.
const float MARCH_FAR = 1.0e6;
// How near to the surface a march ends, as a share of the coordinates and the distance: 7 float roundings, a fifth of the lift of ray_from().
const float MARCH_PRECISION = 4.0e-7;
// The step of the differences that give the normal, as a share of the coordinates. At this step, rounding and curvature cost about the same.
const float MARCH_NORMAL_STEP = 2.44140625e-4;
// A field that changes by more than this, in metres a metre, is no distance.
const float MARCH_STEEP = 1.1;

float march_size(vec3 p) {
    vec3 size = abs(p);
    return max(max(size.x, size.y), size.z);
}

// Returns the field's gradient by central differences. The differences are divided by the distances that rounding leaves between the points p +- h.
// The loop makes the compiler inline the field once, not six times.
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

// Returns the length of the next step from the middle of an empty ball. If the surface is flat, the next empty ball touches this one.
// `fall` is how much the field fell per metre of the last step. From Balint and Valasek 2018, "Accelerating Sphere Tracing", after
// Hart 1996 and Keinert et al. 2014.
float march_step(float radius, float fall) {
    return radius * (1.0 + 0.9 * min((1.0 - fall) / max(1.0 + fall, 0.2), 4.0));
}

// Returns the first t in (start, end) on the surface, or INFINITY. Sets `field` to the field's value there, and `side` to 1 if the ray is outside the
// solid or -1 if it is inside. `size` is the least value that stands for the size of coordinates.
//
// The ray is known to be empty up to t, and so is a ball about the point at t with the field's value as radius. The empty ball after the next
// step must touch this ball. If it does not, there is a gap between them, and the step is taken again with the radius alone. A step that went
// beyond the surface is taken back, too.
float march_along(Ray ray, float start, float end, float size, OUT(float) field, OUT(float) side) {
    float t = start;
    // The field at t. It is positive on the ray's side of the surface.
    float value = 0.0;
    // 0 as long as the ray is on the surface that it leaves.
    side = 0.0;
    float step = 0.0;
    // The field's largest change per metre so far.
    float steepness = 1.0;
    // A place where the ray is known to be past a surface.
    float beyond = INFINITY;
    float found = INFINITY;
    float leap = 1.0;
    bool leaping = false;
    // Says whether the step is longer than the part of the ray that is known to be empty.
    bool bold = false;
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
                step = max(step, MARCH_THIN * (max(march_size(p), size) + t));
            }
            more = t + radius < end;
            step = beyond < INFINITY ? min(step, (bold ? 0.5 : 1.0) * (beyond - t)) : step;
        }
        more = more && t < end && found >= INFINITY;
    }
    search_rays += 1;
    search_steps += steps;
    // If the field is steeper than a distance, the march went on in shorter steps, but may have stepped over a surface before it knew. If the field
    // is not a number, the march ended there.
    if (steepness > 1.0 || !is_finite(vec3(field))) search_broken += 1;
    // The ray grazed a surface, took all of its steps, and ended in leaps. It may have missed what is thinner than a leap.
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
        // The distance that is left to the surface, by the field's slope along the ray. It is long where the ray grazes the surface.
        float slope = dot(gradient, ray.direction);
        float reach = 64.0 * MARCH_PRECISION * (near + t);
        float rest = abs(slope) > 1.0e-4 ? clamp(-field / slope, -reach, reach) : 0.0;
        hit.t = max(t + rest, 0.5 * t);
        vec3 normal = steepness > 0.0 ? gradient / steepness : -ray.direction;
        // On an edge the differences blend the normals of two sides. If the result faces away from the ray's origin, it is turned until the ray
        // grazes the surface; otherwise the path would go on within the solid.
        float facing = side * dot(normal, ray.direction);
        hit.normal = facing < 0.0 ? normal : normalize(normal - side * (facing + 1.0e-3) * ray.direction);
        hit.object = object;
    }
}

// Marches along the whole ray to the field's surface.
void march(Ray ray, int object, INOUT(Hit) hit) {
    march_between(ray, 0.0, INFINITY, 0.0, object, hit);
}

// Marches only inside a sphere, which must contain all of the surface. Rays that miss the sphere cost nothing.
void march(Ray ray, vec3 centre, float radius, int object, INOUT(Hit) hit) {
    vec3 to_centre = centre - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 miss = to_centre - middle * ray.direction;
    // The sphere is a little larger than given, so that a surface that touches it is found.
    float discriminant = 1.001 * radius * radius - dot(miss, miss);
    if (discriminant > 0.0) {
        float half_chord = sqrt(discriminant);
        float size = max(march_size(centre), radius);
        march_between(ray, max(middle - half_chord, 0.0), middle + half_chord, size, object, hit);
    }
}
