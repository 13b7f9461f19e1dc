// The camera's rays. Pixels are square and counted from the picture's top left corner.
#include "scene.glsl"

uniform vec3 camera_eye;
// A unit vector.
uniform vec3 camera_forward;
// Reaches from the picture's middle to its right edge, at distance 1.
uniform vec3 camera_right;
// Reaches from the picture's middle to its top edge, at distance 1.
uniform vec3 camera_up;
// Width and height in pixels.
uniform vec3 picture_size;

// The solid angle of the pixel that holds this direction, a unit vector in the picture.
float camera_pixel_solid_angle(vec3 direction) {
    float cosine = dot(direction, camera_forward);
    float area = 4.0 * length(camera_right) * length(camera_up) / (picture_size.x * picture_size.y);
    return area * cosine * cosine * cosine;
}

// Rays are uniform in the pixel's area, which is a box filter. `u` is in [0,1)^2.
Ray camera_ray(vec2 pixel, vec2 u) {
    vec2 at = 2.0 * (pixel + u) / vec2(picture_size.x, picture_size.y) - 1.0;
    return Ray(camera_eye, normalize(camera_forward + at.x * camera_right - at.y * camera_up));
}
