//@ title   The sky alone
//@ look    "the glow about the sun, left; with preset shadow the planet's own, blue under air that is lit red, rising where the sun is not"
//@ camera  eye 0 1 0  target 1 1.45 0  fov 75
//@ sun     elevation 5  azimuth 140
//@ atmosphere earth
//@ size    768 384
//@ preset  noon       sun.elevation 60
//@ preset  sunset     sun.elevation 5   exposure 0.5
//@ preset  twilight   sun.elevation -2  exposure 4
//@ preset  shadow     sun.elevation -3  sun.azimuth -90  exposure 5
//@ preset  high       sun.elevation 5   atmosphere.observer_height_m 20000  camera.target 1,1,0
//@ preset  hazy       sun.elevation 10  atmosphere.mie 4  exposure -0.5
//@ preset  blue-hour  sun.elevation -6  exposure 8.5
//@ preset  no-ozone   sun.elevation -4  atmosphere.ozone 0  exposure 6
//@ preset  once       sun.elevation -4  atmosphere.orders 1  exposure 6

// There is nothing to hit, so every ray brings back the sky. Below the horizon this is the air in front of the dark ground.
#include "material/matte.glsl"

void scene_intersect(Ray ray, INOUT(Hit) hit) {}

Material scene_material(Hit hit) {
    return matte(vec3(0.0));
}
