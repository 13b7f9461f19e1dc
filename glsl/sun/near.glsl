// Counts the sunlight that is left to chance, for the methods of the sun's disk.
//
// The number of paths that find the sun says nothing about light that few paths can find. So the sun is spread over a wide cone
// with the same irradiance. The light that the paths would bring from there is about the light that is left to chance, and to count
// it takes no luck.
#include "sun/ask.glsl"
#include "sun/count.glsl"
#include "sun/disk.glsl"
#include "sun/share.glsl"

// The largest density, 1/sr, with which a path can find the disk: no light is narrower than the disk itself.
float sun_peak(float pdf) {
    return min(pdf, 1.0 / sun_solid_angle());
}

vec3 chance_slot(int material) {
    int slot = material - material / 3 * 3;
    return vec3(slot == 0 ? 1.0 : 0.0, slot == 1 ? 1.0 : 0.0, slot == 2 ? 1.0 : 0.0);
}

// Counts a path that has left the scene. A path that finds the disk brings the disk's irradiance times the density of its lobe. Of
// the paths that meet the cone, so many find the disk that the mean stays the same.
//
// A path that has not been scattered sees the sun itself, in mirrors or glass. These pixels hold the sun's own image.
//
// What light tracing counts is not left to chance.
void sun_count(SunState state, vec3 throughput, Ray ray, vec3 disk) {
    bool counts = state.chance > 0.0;
    bool near = counts && sun_is_near(ray.direction);
    float share = near ? sun_share(state.traced * state.peak, ray) : 1.0;
    bool met = max(disk.x, max(disk.y, disk.z)) > 0.0;
    chance_paths += counts ? 1.0 : 0.0;
    chance_near += near ? share * state.chance * throughput : vec3(0.0);
    chance_found += counts ? throughput * disk : vec3(0.0);
    chance_materials |= near ? chance_bit(state.thrower) : 0;
    vec3 brought = share * throughput * sun_irradiance();
    float square = state.chance * state.peak * dot(brought, brought) / (3.0 * sun_near_solid_angle());
    if (near && state.scattered) chance_squares += square * chance_slot(state.thrower);
    if (met && counts && state.scattered) chance_met |= chance_bit(state.thrower);
    if (met && !state.scattered) chance_materials |= 1 << CHANCE_IMAGE;
}
