// The image of the sun's disk, which another pass has drawn (pass/sun_image.glsl).
uniform sampler2D sun_image_sums;

// The image's radiance in this pixel, summed over the samples of the group.
vec3 sun_image_sum() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 size = textureSize(sun_image_sums, 0);
    bool drawn = pixel.x < size.x && pixel.y < size.y;
    return drawn ? texelFetch(sun_image_sums, pixel, 0).rgb : vec3(0.0);
}
