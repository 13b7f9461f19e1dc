// Counts the sunlight that is left to chance, for the methods of the sun's disk.
//
// The number of paths that find the sun says nothing about light that few paths can find. So the sun is spread over a wide cone
// with the same irradiance. The light that the paths would bring from there is about the light that is left to chance, and to count
// it takes no luck.
#include "sun/ask.glsl"
#include "sun/count.glsl"
#include "sun/disk.glsl"

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
void sun_count(SunState state, vec3 worth, vec3 direction, vec3 brought) {
    bool counts = state.chance > 0.0;
    bool near = counts && sun_is_near(direction);
    bool met = max(brought.x, max(brought.y, brought.z)) > 0.0;
    chance_paths += counts ? 1.0 : 0.0;
    vec3 share = state.chance * worth;
    chance_near += near ? share : vec3(0.0);
    chance_found += counts ? brought : vec3(0.0);
    int thrower = chance_bit(state.thrower);
    chance_materials |= near ? thrower : 0;
    vec3 found = worth * sun_irradiance();
    float square = state.chance * state.peak * dot(found, found) / (3.0 * sun_near_solid_angle());
    if (near && state.scattered) chance_squares += square * chance_slot(state.thrower);
    if (met && counts && state.scattered) chance_met |= thrower;
    if (met && !state.scattered) chance_materials |= 1 << CHANCE_IMAGE;
}
