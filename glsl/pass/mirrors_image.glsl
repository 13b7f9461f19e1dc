// The image of the sun's disk in the mirror spheres that the scene names.
#include "pass/camera.glsl"
#include "sun/mirrors.glsl"

// Points of the disk in each sample.
const int MIRROR_IMAGE_POINTS = 16;

// The image in one sphere. Points of the disk are reflected into the picture, and count where they fall into this pixel. All pixels
// use the same points, so together they count each point once.
vec3 mirror_image(vec2 pixel, int sphere, vec2 u) {
    vec3 toward = sun_point(u);
    SphereReflection reflection = mirror_reflection(sphere, camera_eye, toward);
    vec3 direction = -reflection.direction;
    float ahead = dot(direction, camera_forward);
    vec2 size = vec2(picture_size.x, picture_size.y);
    float x = dot(direction, camera_right) / dot(camera_right, camera_right) / ahead;
    float y = dot(direction, camera_up) / dot(camera_up, camera_up) / ahead;
    vec2 in_pixel = 0.5 * vec2(1.0 + x, 1.0 - y) * size - pixel;
    bool here = ahead > 0.0 && in_pixel.x >= 0.0 && in_pixel.y >= 0.0 && in_pixel.x < 1.0 && in_pixel.y < 1.0;
    vec3 radiance = vec3(0.0);
    if (here && reflection.focus > 0.0) {
        // The area of a pixel, at distance 1.
        float area = 4.0 * length(camera_right) * length(camera_up) / (size.x * size.y);
        vec3 irradiance = sun_solid_angle() * reflection.focus * sun_radiance(toward);
        radiance = irradiance / (ahead * ahead * ahead * area) * mirror_tint(sphere, Ray(camera_eye, direction), toward);
    }
    return radiance;
}

vec3 mirrors_image(vec2 pixel, uint index, uint seed) {
    vec3 image = vec3(0.0);
    for (int i = 0; i < MIRROR_SPHERES; i++) {
        for (int k = 0; k < MIRROR_IMAGE_POINTS; k++) {
            // Roberts's additive recurrence for the plane, with powers of 1 / 1.3247. It counts in units of 2^-32, so that no digit
            // is ever lost.
            uvec2 at = (index * uint(MIRROR_IMAGE_POINTS) + uint(k)) * uvec2(3242174889u, 2447445414u);
            at += seed * uvec2(2654435769u, 1013904223u);
            image += mirror_image(vec2(pixel), i, vec2(at >> 8u) / 16777216.0);
        }
    }
    return image / float(MIRROR_IMAGE_POINTS);
}
