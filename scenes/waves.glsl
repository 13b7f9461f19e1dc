//@ title   Waves
//@ look    "a sea of mist over a plain, with waves that move: stones and poles that stand out of it, and their shadows across the crests"
//@ camera  eye 0 2.9 -13  target 0 0.9 4  fov 46
//@ sun     elevation 9  azimuth 55
//@ sun-disk on
//@ atmosphere earth
//@ size    640 480
//@ exposure -0.5
//@ mist    extinction density  falloff 0.7  albedo 0.98 0.98 0.98  g 0.5  box 0 1 0  reach 1 reach
//@ preset  clear    mist off
//@ preset  calm     swell 0.05
//@ preset  noon     sun.elevation 60  exposure -2
//@ preset  sunset   sun.elevation 5
//@ preset  twilight sun.elevation -2  exposure 4
#include "color/noise.glsl"
#include "material/matte.glsl"
#include "shape/cylinder.glsl"
#include "shape/ellipsoid.glsl"
#include "shape/plane.glsl"

uniform float density; //@ slider 3.5  min 0  max 4  unit /m  label "extinction of the mist on the ground"
uniform float swell;   //@ slider 0.5  min 0  max 0.7  unit m  label "height of the waves"
uniform float moved;   //@ slider 0  min 0  max 6.2832  label "how far the waves have moved: 0 and 2 pi are the same"
uniform float reach;   //@ slider 40  min 4  max 60  unit m  label "how far the mist reaches from the middle"

const int PLAIN = 0;
const int STONE = 1;
const int POLE = 2;
// The waves' mean height, and the height in which the mist thins at their tops, in metres.
const float LEVEL = 0.75;
const float SOFT = 0.3;

// Trains of waves of different lengths, from different sides. Each moves by whole lengths while `moved` goes once around.
float waves(vec2 at) {
    return 0.45 * sin(dot(at, vec2(0.3, 0.75)) + moved) + 0.25 * sin(dot(at, vec2(-0.6, 1.3)) + 1.3 + moved) +
           0.2 * sin(dot(at, vec2(1.7, 1.1)) + 0.7 - 2.0 * moved) + 0.1 * sin(dot(at, vec2(-2.3, 2.6)) + 2.1 + 3.0 * moved);
}

// All of the mist below the waves, and none above them. Toward its end the mist fades, so that no edge is seen.
float scene_mist(vec3 p) {
    float top = LEVEL + swell * waves(vec2(p.x, p.z));
    float ends = 1.0 - smoothstep(0.7 * reach, reach, length(vec2(p.x, p.z)));
    return ends * (1.0 - smoothstep(top - SOFT, top + SOFT, p.y));
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, PLAIN, hit);
    hit_ellipsoid(ray, vec3(-2.6, 0.1, 1.0), vec3(1.7, 1.5, 1.4), STONE, hit);
    hit_ellipsoid(ray, vec3(3.4, 0.0, 6.5), vec3(2.4, 2.3, 2.0), STONE, hit);
    hit_ellipsoid(ray, vec3(-6.5, 0.0, 12.0), vec3(3.0, 2.6, 2.6), STONE, hit);
    for (int i = 0; i < 6; i++) {
        vec3 foot = vec3(1.2 + 0.5 * float(i), 0.0, -5.0 + 2.4 * float(i));
        hit_cylinder(ray, foot, foot + vec3(0.05, 1.7, 0.04), 0.09, POLE, hit);
    }
}

Material scene_material(Hit hit) {
    if (hit.object == PLAIN) return matte(mix(vec3(0.22, 0.19, 0.14), vec3(0.3, 0.27, 0.2), noise_octaves(0.5 * hit.position, 3)));
    if (hit.object == POLE) return matte(vec3(0.12, 0.08, 0.05));
    return matte(mix(vec3(0.2, 0.19, 0.18), vec3(0.4, 0.38, 0.34), noise_octaves(3.0 * hit.position, 3)));
}
