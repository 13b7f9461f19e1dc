// The camera's rays. Pixels are square and counted from the picture's top left corner.
#include "scene.glsl"

uniform vec3 camera_eye;
uniform vec3 camera_forward; // unit length
uniform vec3 camera_right;   // to the picture's right edge at distance 1 ahead
uniform vec3 camera_up;      // to its top edge
uniform vec3 picture_size;   // width, height

// Uniform in the pixel's area: a box filter.
Ray camera_ray(vec2 pixel, vec2 u) {
    vec2 at = 2.0 * (pixel + u) / vec2(picture_size.x, picture_size.y) - 1.0;
    return Ray(camera_eye, normalize(camera_forward + at.x * camera_right - at.y * camera_up));
}
