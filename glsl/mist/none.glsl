// For a scene without mist.
#include "mist/air_none.glsl"
#include "mist/sky_none.glsl"

bool mist_here() {
    return false;
}

void mist_begin(vec2 numbers) {
}

MistWay mist_way(Ray ray, float distance) {
    return MistWay(ray, 0.0, 0.0, 0.0, 0.0, 0.0);
}

vec3 mist_kept(MistWay way) {
    return vec3(1.0);
}

MistEvent mist_event(MistWay way, vec3 throughput, float u) {
    return MistEvent(INFINITY, vec3(1.0));
}

MistPoint mist_point(MistWay way, vec3 throughput, float u) {
    return MistPoint(0.0, vec3(0.0));
}

float mist_excess(Ray ray, float distance, float u) {
    return 0.0;
}

float mist_overrun(Ray ray, float distance) {
    return 0.0;
}

Material mist_material(vec3 position) {
    return material_new(-1, vec3(0.0));
}
