// GLSL's words for a C++ compiler: included before a case's text (see flatten.c), which is compiled with REAL
// as its float. All in an anonymous namespace, since float and double make different functions of one name.
#pragma once

#include <cassert>
#include <cmath>
#include <glm/glm.hpp>

// A case uses a part of what it includes.
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-parameter"

#undef INFINITY
#define IN(T) T
#define OUT(T) T &
#define INOUT(T) T &
#define uniform

namespace {

using namespace glm; // the types below hide GLM's of the same name

using Real = REAL;
using vec2 = glm::vec<2, Real>;
using vec3 = glm::vec<3, Real>;
using vec4 = glm::vec<4, Real>;
using mat3 = glm::mat<3, 3, Real>;

// By the bits of a GPU's float, whatever Real is: a double past float's range counts as infinite.
uint floatBitsToUint(Real v) {
    return glm::floatBitsToUint(static_cast<glm::f32>(v));
}

uvec3 floatBitsToUint(vec3 v) {
    return glm::floatBitsToUint(glm::vec<3, glm::f32>(v));
}

struct sampler2D {
    const glm::f32 *texels;
    int width;
};

vec4 texelFetch(sampler2D sampler, ivec2 at, int level) {
    assert(level == 0 && at.x >= 0 && at.x < sampler.width && at.y >= 0);
    const glm::f32 *texel = sampler.texels + 4 * (at.y * sampler.width + at.x);
    return vec4(texel[0], texel[1], texel[2], texel[3]);
}

template <typename Evaluate>
void evaluate_all(Evaluate evaluate_texel, int width, int height, double *results) {
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            vec4 value = evaluate_texel(vec2(x, y));
            for (int c = 0; c < 4; c++) *results++ = static_cast<double>(value[c]);
        }
    }
}

} // namespace

// oracle_NAME_float() or oracle_NAME_double(), declared for C in oracle.h; at a case's end.
#define ORACLE_EXPORT_AS(name, real)                                                                         \
    extern "C" void oracle_##name##_##real(const glm::f32 *texels, int width, int height, double *results) { \
        inputs = {texels, width};                                                                            \
        evaluate_all(evaluate, width, height, results);                                                      \
    }
#define ORACLE_EXPORT_REAL(name, real) ORACLE_EXPORT_AS(name, real)
#define ORACLE_EXPORT(name) ORACLE_EXPORT_REAL(name, REAL)
