#include "scene.glsl"

// What the two loops of march() share: the quick one (shape/march_quick.glsl) and the careful one (shape/march_careful.glsl).
float scene_distance(vec3 p);

// One march evaluates the field up to MARCH_STEPS times, and 6 times more for the normal. Most rays are done after some twenty steps. Rays
// that pass a surface at a millionth of their length need a thousand.
const int MARCH_STEPS = 2048;
// The first steps of a march, which miss nothing. After them a ray is bold: its steps are at least MARCH_THIN of the coordinates, and may miss what
// is thinner. They grow with the square of the steps taken so far, so that a ray beside a long flat side passes twice the coordinates before it has
// taken all.
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

// The thinnest solid and the narrowest gap between solids, in metres; 0 is unknown. A scene that knows it may say so before it calls march(). Then the
// rays of later bounces take longer steps, and no step is longer than the thinnest solid bears.
float march_thinnest = 0.0;

float march_size(vec3 p) {
    vec3 size = abs(p);
    return max(max(size.x, size.y), size.z);
}

// Where a march stands.
struct March {
    // The ray is known to be empty up to here.
    float t;
    // The field at t, positive on the ray's side of the surface, and 0 as long as the ray is on the surface that it leaves.
    float value;
    // The next step.
    float step;
    // 1 if the ray is outside of the solid, -1 if it is inside, and 0 as long as it is on the surface that it leaves.
    float side;
    // The field at the place that was looked at last.
    float field;
    // The place of the surface, or INFINITY.
    float found;
    // Whether the march goes on.
    bool more;
    int steps;
};
