// Two quotients that are 1 where their argument is 0. Near 0 they are computed by their series, because the quotients themselves lose their digits.
#include "math/dialect.glsl"

// The series' first term that is left out is below 2e-7 within this distance from 0.
const float QUOTIENT_SERIES = 0.1;

// (1 - exp(-x)) / x. Below -60 it stays at its value there: nothing comes through mist that is so thick.
float exp_quotient(float x) {
    float y = max(x, -60.0);
    float series = 1.0 - y * (0.5 - y * (1.0 / 6.0 - y * (1.0 / 24.0 - y / 120.0)));
    float quotient = (1.0 - exp(-y)) / y;
    return abs(y) < QUOTIENT_SERIES ? series : quotient;
}

// -log(1 - q) / q, for q < 1.
float log_quotient(float q) {
    float series = 1.0 + q * (0.5 + q * (1.0 / 3.0 + q * (0.25 + q * (0.2 + q / 6.0))));
    float quotient = -log(max(1.0 - q, 1.0e-30)) / q;
    return abs(q) < QUOTIENT_SERIES ? series : quotient;
}

// The share of the light that a depth takes away, 1 - exp(-depth).
float share_taken(float depth) {
    float taken = depth * exp_quotient(depth);
    return depth < 60.0 ? taken : 1.0;
}

// The depth that takes this share away, which is below 1.
float depth_taking(float share) {
    return share * log_quotient(share);
}
