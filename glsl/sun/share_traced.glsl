// Light is traced from the sun too.
#include "light/surface.glsl"
#include "sun/aim.glsl"
#include "sun/balance.glsl"
#include "sun/share.glsl"

// The number of light paths for one sample of one pixel.
float light_paths_a_sample();
float camera_pixel_solid_angle(vec3 direction);

float sun_share(float traced, Ray ray) {
    float share = 1.0;
    if (traced > 0.0) share = 1.0 / (1.0 + light_paths_a_sample() * traced * aim_density(ray.origin, ray.direction));
    return share;
}

float sun_share_reflected(float traced, Hit hit, Material material, vec3 incoming, vec3 toward) {
    float share = 1.0;
    if (traced > 0.0 && balance_counts(material)) {
        float here = balance_end(hit.normal, material, incoming, toward);
        share = sun_share(traced * here, ray_from(hit, toward));
    }
    return share;
}

// A path whose first hit is a mirror or glass stays at 0: no light path can be joined to the camera there.
float sun_traced(SunState state, Hit hit, Material material, vec3 incoming, Bounce bounce) {
    float traced = state.traced;
    if (bounce.pdf > 0.0) {
        if (state.found == SUN_PICTURED) {
            float beam = hit.t * hit.t * camera_pixel_solid_angle(incoming);
            traced = beam * balance_first(hit.normal, material, incoming, bounce.direction);
        } else if (traced > 0.0) {
            traced *= balance_between(hit.normal, material, incoming, bounce.direction);
        }
    }
    return traced;
}
