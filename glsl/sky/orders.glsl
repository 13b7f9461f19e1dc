// The field of light that was scattered k times ("order k"), and the light that it scatters along a ray.
//
// At a point, the field depends on the direction, the altitude and the local elevation of the sun. It is held as moments: the integrals over the sphere of the
// field times real spherical harmonics whose axis points to the sun. A phase function depends on an angle alone, so that each harmonic of the scattered
// light is that of the field times a weight. For air the weights are 1 and 1/10 (degrees 0 and 2), and all others are 0. For aerosols they are the Legendre coefficients of
// the phase function, less a share that counts as not scattered (src/sky/orders.h).
//
// Moments stand in a texture, as tiles of one row for each altitude and one column for each elevation of the sun, one tile for each harmonic. The first
// tile of a band holds the logarithm of moment 0, and the others hold moments divided by moment 0. Behind the harmonics is a tile whose first
// row holds the logarithm of the ground's irradiance by the field.
#include "sky/atmosphere.glsl"

struct OrderGrid {
    float columns;
    float rows;
    // The chord of the zenith angle at which columns are closest, and the inverse of the chord over which they widen.
    float middle;
    float closeness;
    // The range of the coordinate across.
    float left;
    float right;
};

// Below this, a moment counts as 0.
const float ORDER_DARK = 1.0e-30;

// Returns the number of the harmonic of degree l and order m among those up to a degree: order by order.
int order_harmonic(int degree, int l, int m) {
    return m * (degree + 1) - m * (m - 1) / 2 + l - m;
}

int order_harmonics(int degree) {
    return (degree + 1) * (degree + 2) / 2;
}

// Returns the place in a tile, in texels from the centre of the first. x runs with asinh of the chord of the zenith angle, which is as smooth as the angle and
// needs no arc; y runs with the square root of altitude.
vec2 order_place(OrderGrid grid, float top, float h, float sine) {
    float z = (grid.middle - sqrt(max(2.0 - 2.0 * sine, 0.0))) * grid.closeness;
    float across = sign(z) * log(abs(z) + sqrt(z * z + 1.0));
    float x = clamp((across - grid.left) / (grid.right - grid.left), 0.0, 1.0);
    float y = sqrt(clamp(h / top, 0.0, 1.0));
    return vec2(x * (grid.columns - 1.0), y * (grid.rows - 1.0));
}

float order_altitude(OrderGrid grid, float top, float row) {
    float y = row / (grid.rows - 1.0);
    return y * y * top;
}

// Returns the cosine and the sine of the sun's elevation in a column. The last column stands a tenth of a degree off the zenith, where harmonics have a
// direction. The cosine comes from the chord, as the sine has no digits left there.
vec2 order_sun(OrderGrid grid, float column) {
    float across = mix(grid.left, grid.right, column / (grid.columns - 1.0));
    float rise = exp(across);
    float chord = max(grid.middle - 0.5 * (rise - 1.0 / rise) / grid.closeness, 1.7453e-3);
    float half_squared = 0.25 * chord * chord;
    return vec2(chord * sqrt(1.0 - half_squared), 1.0 - 2.0 * half_squared);
}

// Returns the cosine of the azimuth about the sun's direction, from the zenith. `mu` and `mu_sun` are the sines of elevation of a direction and of the sun,
// `level_sun` is the cosine of the sun's elevation, and `nu` is the cosine between the two directions.
float order_azimuth(float mu, float mu_sun, float level_sun, float nu) {
    float across = max((1.0 - nu * nu) * level_sun * level_sun, 1.0e-30);
    return clamp((mu - nu * mu_sun) * inversesqrt(across), -1.0, 1.0);
}

// The recurrence of normalised Legendre functions: Y(l,m) = x (nu Y(l-1,m) - y Y(l-2,m)) for l > m.
vec2 order_step(float l, float m) {
    float before = (l - 1.0) * (l - 1.0);
    float fall = l > m + 1.5 ? sqrt((before - m * m) / (4.0 * before - 1.0)) : 0.0;
    return vec2(sqrt((4.0 * l * l - 1.0) / (l * l - m * m)), fall);
}

// Returns the first function of order m: Y(m,m), from that of order m - 1. s is sqrt(1 - nu^2).
float order_start(float m, float s, float before) {
    float once = m < 1.5 ? 1.41421356237 : 1.0;
    return m < 0.5 ? 0.28209479177 : before * s * once * sqrt((2.0 * m + 1.0) / (2.0 * m));
}
