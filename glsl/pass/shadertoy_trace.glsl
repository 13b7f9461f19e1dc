// The tab Buffer A of a scene's program for Shadertoy: it adds samples to what the frame before had, and shows it by no tone curve. The host writes the
// constants in capitals and the variables scene_NAME (src/export/toy_settings.h).

// Samples of each pixel in a frame.
const int SAMPLES = 1;

void set_camera(vec2 size) {
    picture_size = vec3(size, 0.0);
    camera_eye = CAMERA_EYE;
    camera_forward = CAMERA_FORWARD;
    camera_right = size.x / size.y * CAMERA_RIGHT;
    camera_up = CAMERA_UP;
}

// The sun's elevation and azimuth in degrees.
void set_sun(vec2 place) {
    vec2 angle = radians(place);
    sun_level = vec3(sin(angle.y), 0.0, cos(angle.y));
    sun_direction = vec3(cos(angle.x) * sun_level.x, sin(angle.x), cos(angle.x) * sun_level.z);
}

// rgb is the mean radiance of a pixel so far, and a the number of its samples. Pixel (0, 0) holds what the picture was made for instead: its size, and
// where the mouse was. When that changes, the sums restart.
void mainImage(out vec4 mean, in vec2 at) {
    ivec2 pixel = ivec2(at);
    vec4 made_for = vec4(iResolution.xy, iMouse.xy);
    bool fresh = iFrame == 0 || texelFetch(iChannel0, ivec2(0), 0) != made_for;
    mean = fresh ? vec4(0.0) : texelFetch(iChannel0, pixel, 0);
#include <scene-inputs>
    set_camera(iResolution.xy);
    set_sun(MOUSE_MOVES_SUN && iMouse.xy != vec2(0.0) ? mix(SUN_AT_CORNER, SUN_AT_OTHER_CORNER, iMouse.yx / iResolution.yx) : SUN);
    // Row 0 is the picture's bottom here, and its top for the sequence.
    uvec2 place = uvec2(pixel.x, int(iResolution.y) - 1 - pixel.y);
    vec4 group = vec4(0.0);
    int i = 0;
    do {
        Sequence sequence = sequence_start(place.x, place.y, uint(iFrame * SAMPLES + i), SEED);
        Ray ray = camera_ray(vec2(place), sequence_pair(sequence));
        vec3 radiance = path_radiance(ray, MOST_HITS, sequence);
        group += is_finite(radiance) ? vec4(radiance, 1.0) : vec4(0.0);
        i += 1;
    } while (i < SAMPLES);
    float count = mean.a + group.a;
    mean = vec4(mean.rgb + (group.rgb - group.a * mean.rgb) / max(count, 1.0), count);
    if (pixel == ivec2(0)) mean = made_for;
}
