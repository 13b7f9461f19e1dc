// Converts radiance to what a screen shows, exactly as src/image/png.c does for files.
uniform float gain;

// The author's tone curve, which is Narkowicz's fit of ACES. Negative values and NaN become 0.
float tone(float x) {
    if (!(x > 0.0)) return 0.0;
    x = min(x, 1.0e6);
    return min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0);
}

// As in IEC 61966-2-1.
float srgb_from_linear(float v) {
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}

uint dither_hash(uint x) {
    x ^= x >> 16u;
    x *= 0x7feb352du;
    x ^= x >> 15u;
    x *= 0x846ca68bu;
    return x ^ (x >> 16u);
}

// Rounds to one of 256 steps: up with a probability that equals the fraction.
float dither(float v, uint column, uint row, uint channel) {
    uint random = dither_hash(column + dither_hash(row + dither_hash(channel + 1u)));
    return min(floor(255.0 * v + float(random >> 8u) / 16777216.0), 255.0) / 255.0;
}

float developed_channel(float light, uvec2 pixel, uint channel) {
    return dither(srgb_from_linear(tone(gain * light)), pixel.x, pixel.y, channel);
}

vec3 developed(vec3 light, uvec2 pixel) {
    return vec3(developed_channel(light.r, pixel, 0u), developed_channel(light.g, pixel, 1u),
                developed_channel(light.b, pixel, 2u));
}
