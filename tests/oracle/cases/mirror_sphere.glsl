// a: a point in radii from the sphere's centre, its distance less 1; b: toward the light. c: the reflected direction, the focus; d: the
// normal there, and the condition.
#include "../item.glsl"
#include "sun/mirror_sphere.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    SphereReflection r = sphere_reflection(vec3(a), vec3(b));
    // Close to the sphere the distance to the reflection point is a difference of near numbers.
    float t = length(vec3(a) - r.normal);
    c = vec4(r.direction, r.focus);
    d = vec4(r.normal, 1.0 + 1.0 / max(t, 1.0e-6));
}
