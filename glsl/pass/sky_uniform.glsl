// --sky uniform:L: the same radiance from everywhere, for furnace tests and ambient occlusion.
uniform float sky_level;

vec3 sky_radiance(vec3 direction) {
    return vec3(sky_level);
}
