#include "shape/march_field.glsl"

// The first steps of a march, which are all that most rays need.
const int MARCH_QUICK = 128;
// How wide a gap between two empty balls may be, as a share of the coordinates and the distance. Near a surface, a gap lets the ray reach it in one
// step. What is thinner may be missed where a ray only grazes it.
const float MARCH_SLACK = 3.0e-5;
// How many times as wide the gap may be for a ray after a bounce in all directions, in a scene that says how thin its solids are: the light of such
// a ray is one part of an average over the whole sky, where a ray that passes an outline by less than a pixel's width does not show.
const float MARCH_WIDE = 30.0;
// In such a scene the gap is at most this share of the thinnest solid. Only rays that run through less than a tenth of it, along its outline, may then
// miss it.
const float MARCH_THINNEST_SHARE = 0.08;

// How wide a gap may be, in metres, where the coordinates and the distance sum to `scale`.
float march_slack(float scale) {
    float safe = MARCH_SLACK * scale;
    float known = min(safe * mix(1.0, MARCH_WIDE, ray_spread), MARCH_THINNEST_SHARE * march_thinnest);
    return march_thinnest > 0.0 ? known : safe;
}

// Marches by a loop without branches, because graphics hardware and llvmpipe execute both sides of a branch. The steps are those of
// march_careful(), and two more: a step to where the field would be 0 if it went on falling as it did, and a step back to that place from beyond a surface.
// What is left when the steps are used up, or when the field changes faster than a distance, is for march_careful().
March march_quick(Ray ray, float start, float end, float size) {
    float t = start;
    float value = 0.0;
    float side = 0.0;
    float step = 0.0;
    bool hit = false;
    bool quick = start < end;
    int steps = 0;
    while (steps < MARCH_QUICK && quick) {
        steps += 1;
        float next = min(t + step, end);
        float moved = next - t;
        vec3 p = ray.origin + next * ray.direction;
        float coordinates = march_size(p);
        float tolerance = MARCH_PRECISION * (max(coordinates, size) + next);
        float slack = march_slack(coordinates + next);
        float field = scene_distance(p);
        bool started = side != 0.0;
        float sign_here = field < 0.0 ? -1.0 : 1.0;
        side = !started && (abs(field) > tolerance || start > 0.0) ? sign_here : side;
        bool leaving = side == 0.0;
        float d = side * field;
        float drop = value - d;
        // Whether the balls about both ends of the step touch, but for the slack. The tolerance is there because t is rounded.
        bool touching = !started || moved <= max(1.001 * value + 0.5 * tolerance, value + abs(d) + 1.2 * slack);
        bool broken = (started && abs(drop) > MARCH_STEEP * moved + 5.0 * tolerance) || !(abs(field) < INFINITY);
        bool past = d < 0.0;
        hit = touching && !leaving && !broken && abs(d) <= tolerance;
        bool accepted = hit || leaving || (touching && !past && !broken);
        // Where the field would be 0, counted from t if the ray is past it, and from the next t if not.
        float from = past ? value : d;
        float root = drop > 0.0 ? from * moved / max(drop, 1.0e-30) : INFINITY;
        // How much longer the next step may be than the ball's radius; see march_careful().
        float longer = started ? min((moved - drop) / max(moved + drop, 0.2 * moved), 4.0) : 0.0;
        float ball = d * (1.0 + 0.8 * longer) + slack * 0.5 * (1.0 + longer);
        float creep = max(2.0 * step, tolerance);
        // A first step from afar is short, so that it shows how steep the field is before anything thin can be missed.
        float first = d > 100.0 * tolerance ? 0.5 * d : d;
        float forward = started ? min(ball, root) : (leaving ? creep : first);
        float back = past && root < 0.9 * moved ? max(root, value) : value;
        step = accepted ? forward : back;
        quick = !hit && !broken && !(accepted && next + d >= end);
        t = accepted ? next : t;
        value = accepted ? d : value;
    }
    // A short step shows how steep the field is.
    step = side == 0.0 ? step : 0.25 * value;
    float found = hit ? t : INFINITY;
    return March(t, value, step, side, side * value, found, !hit && t + value < end, steps);
}
