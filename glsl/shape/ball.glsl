#include "shape/sphere.glsl"
void hit_ball(Ray ray, vec3 foot, float radius, int object, INOUT(Hit) hit) {
    hit_sphere(ray, foot + vec3(0.0, radius, 0.0), radius, object, hit);
}
