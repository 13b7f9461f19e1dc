#include "scene.glsl"
#include "shape/search.glsl"

// A plain sphere tracer with fixed parameters, as in Fragmentarium's DE-Raytracer.frag. tools/march_peer.sh puts it in the place of the library's
// shape/march.glsl, and writes other values of these three constants into it.
float scene_distance(vec3 p);

// A ray has met the surface where the field is less than this share of the ray's length: 10 to the power of `Detail`, which is -2.3 by default.
const float PLAIN_DETAIL = 1.0e-3;
// Each step is the field times this: `FudgeFactor`.
const float PLAIN_FUDGE = 1.0;
// The step of the differences that give the normal, in metres. 0 stands for half the threshold, which is Fragmentarium's choice.
const float PLAIN_NORMAL_STEP = 0.0;
// `MaxRaySteps`, of which Fragmentarium takes 56 by default. Here the steps end no ray.
const int PLAIN_STEPS = 2000;

vec3 plain_gradient(vec3 p, float h) {
    vec3 change = vec3(0.0);
    for (int i = 0; i < 6; i++) {
        vec3 axis = vec3(i % 3 == 0 ? 1.0 : 0.0, i % 3 == 1 ? 1.0 : 0.0, i % 3 == 2 ? 1.0 : 0.0);
        vec3 signed_axis = i < 3 ? axis : -axis;
        change += scene_distance(p + h * signed_axis) * signed_axis;
    }
    return change / (2.0 * h);
}

// A ray that starts on the surface begins with two thresholds of a metre, as Fragmentarium's shadow rays do. Otherwise it would end where it starts.
void plain_between(Ray ray, float start, float end, int object, INOUT(Hit) hit) {
    float t = start > 0.0 ? start : 2.0 * PLAIN_DETAIL;
    float last = min(end, hit.t);
    float threshold = 0.0;
    float field = INFINITY;
    int steps = 0;
    while (steps < PLAIN_STEPS && t < last && field >= threshold) {
        steps += 1;
        field = max(scene_distance(ray.origin + t * ray.direction), 0.0) * PLAIN_FUDGE;
        t += field;
        threshold = PLAIN_DETAIL * t;
    }
    search_rays += 1;
    search_steps += steps;
    if (field < threshold && t < last) {
        // The place where the field is the threshold, if it falls as fast as the ray comes nearer.
        t = max(t - (threshold - field), 0.5 * t);
        vec3 back = ray.origin + (t - threshold) * ray.direction;
        vec3 gradient = plain_gradient(back, max(0.5 * threshold, 1.0e-7));
        if (PLAIN_NORMAL_STEP > 0.0) {
            // The error of central differences is taken away to the second order.
            vec3 p = ray.origin + t * ray.direction;
            gradient = (4.0 * plain_gradient(p, 0.5 * PLAIN_NORMAL_STEP) - plain_gradient(p, PLAIN_NORMAL_STEP)) / 3.0;
        }
        float steepness = length(gradient);
        hit.t = t;
        hit.normal = steepness > 0.0 ? gradient / steepness : -ray.direction;
        hit.object = object;
    }
}

void march(Ray ray, int object, INOUT(Hit) hit) {
    plain_between(ray, 0.0, INFINITY, object, hit);
}

// Marches only inside a sphere, with the bounds of the library's march().
void march(Ray ray, vec3 centre, float radius, int object, INOUT(Hit) hit) {
    vec3 to_centre = centre - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 miss = to_centre - middle * ray.direction;
    float discriminant = 1.001 * radius * radius - dot(miss, miss);
    if (discriminant > 0.0) {
        float half_chord = sqrt(discriminant);
        plain_between(ray, max(middle - half_chord, 0.0), middle + half_chord, object, hit);
    }
}
