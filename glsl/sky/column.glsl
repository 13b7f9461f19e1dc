// Columns of exponential densities in closed form. A column is the integral of the density along a ray, from a point to the top of the atmosphere.
//
// The first order is Chapman's grazing-incidence integral, density * H sqrt(pi X / 2) erfcx(y). Here H is the scale height, X = r / H, and
// y = sqrt(X / 2) cos(zenith angle) (F. L. Smith and C. Smith 1972).
//
// This file goes to the next order in 1 / X. Let z = (altitude gained) / r, and let c be the cosine. The path length grows by
// (1 + z) / sqrt(c^2 + 2 z + z^2) dz. If this is expanded about z = 0, the integrals over exp(-X z) are erfcx again. The sum is the first order times
// 1 + F(y) / X, with F = 3/8 - y^2/2 + y^4/2 + 2 y (3/8 - y^2/4) / (sqrt(pi) erfcx(y)).
//
// The part above the top is subtracted, by the same formula. The error is 2e-6 from the fits below and 1 / X^2 from the expansion. For the Earth's
// air it is 1e-5 in all.
#include "sky/atmosphere.glsl"

// Returns erfcx(y) = exp(y^2) erfc(y) for y >= 0, with a relative error of 2e-6.
vec2 scaled_erfc(vec2 y) {
    return (1.0 + y * (1.11610384 + y * (0.55644975 + y * 0.12392227))) /
           (1.0 + y * (2.24440585 + y * (2.08989434 + y * (0.98622912 + y * 0.21964651))));
}

// Returns F(y) (see above), with a relative error of 1.2e-3.
vec2 chapman_correction(vec2 y) {
    return (0.375 + y * (0.65576663 + y * 0.42239498)) / (1.0 + y * (0.63688344 + y * 0.42239498));
}

// Returns the columns of air and aerosols up to infinity, divided by the densities at the starting point, in metres. c must not be negative.
vec2 column_lengths(Atmosphere a, float r, float c) {
    vec2 height = vec2(a.rayleigh_scale_height_m, a.mie_scale_height_m);
    vec2 x = r / height;
    vec2 y = sqrt(0.5 * x) * c;
    return height * sqrt(0.5 * PI * x) * scaled_erfc(y) * (1.0 + chapman_correction(y) / x);
}

// Returns the columns of air and aerosols from altitude h to the top, in metres. The densities at altitude h are `density`.
// A ray that descends (b < 0) goes through its perigee. Its column is twice the level column there, less the upward column at h. It must miss the
// ground.
vec2 columns_to_top(Atmosphere a, float h, float b, vec2 density) {
    float r = a.planet_radius_m + h;
    float c = abs(b) / r;
    float r_top = a.planet_radius_m + a.thickness_m;
    float b_top = sqrt(b * b + max((a.thickness_m - h) * (r + r_top), 0.0));
    vec2 above_top = densities(a, a.thickness_m) * column_lengths(a, r_top, b_top / r_top);
    vec2 up = density * column_lengths(a, r, c);
    float h_low = perigee_altitude(h, r, b);
    vec2 level = densities(a, h_low) * column_lengths(a, a.planet_radius_m + h_low, 0.0);
    vec2 through = 2.0 * level - up;
    vec2 column = b < 0.0 ? through : up;
    return max(column - above_top, vec2(0.0));
}
