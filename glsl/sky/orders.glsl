// The grid and the harmonics of the fields of light from which the further orders of scattering are computed.
//
// Light that was scattered k times, by the air or by the ground, has the order k. All light of that order at all points is the field of order k. Its
// radiance at a point depends on the direction, on the altitude and on the local elevation of the sun, and on nothing else, because the planet and
// its air are round. So a grid over altitudes and elevations holds the fields for every observer and every position of the sun.
//
// At each point of the grid a field is held as moments. A moment is the integral over the sphere of the radiance times a real spherical harmonic
// whose axis points to the sun. l is the harmonic's degree, and m counts its turns about the axis. "Order" always means the order of scattering. A
// field is as bright on either side of the plane through the sun and the zenith, so that only the harmonics that are even in the azimuth are needed.
//
// Moments make scattering cheap. A phase function depends on an angle alone, so that each moment of the scattered light is that of the field times a
// weight, which depends on l alone. The weights of air are 1 and 1/10 for the degrees 0 and 2, and 0 for all others. Those of aerosols are the
// Legendre coefficients of the phase function, less a share that counts as not scattered (src/sky/orders_plan.h).
//
// A texture of moments consists of tiles, one for each harmonic. A tile has a column for each elevation of the sun and a row for each altitude. The
// first tile holds the logarithm of moment 0, and the others hold moments divided by moment 0, because these vary slowly over the grid. Behind the
// harmonics is a tile whose first row holds the logarithm of the ground's irradiance by the field. The tiles of the next band of wavelengths follow.
#include "sky/atmosphere.glsl"

struct OrderGrid {
    float columns;
    float rows;
    // The chord of the sun's zenith angle at which columns are closest, and the inverse of the chord over which their distance doubles or so. The
    // chord of an angle is that of the unit circle: 2 sin(angle / 2).
    float middle;
    float closeness;
    // The range of the coordinate across.
    float left;
    float right;
};

// A moment 0 below this counts as darkness: its logarithm is taken of this number, and what is divided by it is 0.
const float ORDER_DARK = 1.0e-30;

// Returns the number of the harmonic of degree l with m turns among those up to a degree. Those with the same m stand together.
int order_harmonic(int degree, int l, int m) {
    return m * (degree + 1) - m * (m - 1) / 2 + l - m;
}

// Returns how many harmonics there are up to a degree.
int order_harmonics(int degree) {
    return (degree + 1) * (degree + 2) / 2;
}

// Returns the place in a tile, in texels from the centre of the first, of a point at altitude h (0 to top, in metres) at which the sun's elevation
// has this sine. x runs with asinh of the chord of the sun's zenith angle. The chord is as smooth as the angle, and needs no arc function. y runs
// with the square root of the altitude.
vec2 order_place(OrderGrid grid, float top, float h, float sine) {
    float z = (grid.middle - sqrt(max(2.0 - 2.0 * sine, 0.0))) * grid.closeness;
    float across = sign(z) * log(abs(z) + sqrt(z * z + 1.0));
    float x = clamp((across - grid.left) / (grid.right - grid.left), 0.0, 1.0);
    float y = sqrt(clamp(h / top, 0.0, 1.0));
    return vec2(x * (grid.columns - 1.0), y * (grid.rows - 1.0));
}

// Returns the altitude of a row, in metres.
float order_altitude(OrderGrid grid, float top, float row) {
    float y = row / (grid.rows - 1.0);
    return y * y * top;
}

// Returns the cosine and the sine of the sun's elevation in a column. The last column stands a tenth of a degree off the zenith, because the azimuth
// about the sun has no meaning at the zenith itself. The cosine is computed from the chord, because the sine has no digits left near the zenith.
vec2 order_sun(OrderGrid grid, float column) {
    float across = mix(grid.left, grid.right, column / (grid.columns - 1.0));
    float rise = exp(across);
    float chord = max(grid.middle - 0.5 * (rise - 1.0 / rise) / grid.closeness, 1.7453e-3);
    float half_squared = 0.25 * chord * chord;
    return vec2(chord * sqrt(1.0 - half_squared), 1.0 - 2.0 * half_squared);
}

// Returns the cosine of a direction's azimuth about the sun, counted from the zenith. `mu` and `mu_sun` are the sines of elevation of the direction
// and of the sun, `level_sun` is the cosine of the sun's elevation, and `nu` is the cosine between the two directions.
float order_azimuth(float mu, float mu_sun, float level_sun, float nu) {
    float across = max((1.0 - nu * nu) * level_sun * level_sun, 1.0e-30);
    return clamp((mu - nu * mu_sun) * inversesqrt(across), -1.0, 1.0);
}

// Returns the factors x and y of the recurrence of normalised Legendre functions, Y(l,m) = x (nu Y(l-1,m) - y Y(l-2,m)) for l > m. It is the one that
// loses no digits as l grows.
vec2 order_step(float l, float m) {
    float before = (l - 1.0) * (l - 1.0);
    float fall = l > m + 1.5 ? sqrt((before - m * m) / (4.0 * before - 1.0)) : 0.0;
    return vec2(sqrt((4.0 * l * l - 1.0) / (l * l - m * m)), fall);
}

// Returns Y(m,m), from which the recurrence starts. `before` is Y(m-1,m-1), and s is sqrt(1 - nu^2). The factor sqrt(2) of all harmonics with m > 0
// enters once, at m = 1.
float order_start(float m, float s, float before) {
    float once = m < 1.5 ? 1.41421356237 : 1.0;
    return m < 0.5 ? 0.28209479177 : before * s * once * sqrt((2.0 * m + 1.0) / (2.0 * m));
}
