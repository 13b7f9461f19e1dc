#version 330 core
// Fills the mean radiance that the unblocked disk gives each pixel of a rectangle (pass/sun_image.glsl) where no host computes it, from a grid of
// points in each pixel. It is within 0.5 % of the mean where the disk is half a pixel wide or more.
#include "pass/camera.glsl"
#include "pass/sun_disk.glsl"

// The rectangle's first pixel.
uniform vec3 sun_image_corner;

const int COVER_POINTS = 128;

layout(location = 0) out vec4 cover;

void main() {
    vec2 pixel = floor(gl_FragCoord.xy) + vec2(sun_image_corner.x, sun_image_corner.y);
    vec3 sum = vec3(0.0);
    for (int y = 0; y < COVER_POINTS; y++) {
        for (int x = 0; x < COVER_POINTS; x++) {
            vec2 at = (vec2(x, y) + 0.5) / float(COVER_POINTS);
            sum += sun_radiance(camera_ray(pixel, at).direction);
        }
    }
    cover = vec4(sum / float(COVER_POINTS * COVER_POINTS), 1.0);
}
