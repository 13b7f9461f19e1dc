/* The oracle: the GLSL library's own files compiled as C++ through GLM, in float and in double. Double
 * against float shows a formula's precision, float against the GPU shows the driver.
 *
 * A case is one file, cases/NAME.glsl, that includes what it tests and defines `vec4 evaluate(vec2 texel)`;
 * with item.glsl it defines item() instead, eight numbers in and eight out. All three compilers take the same
 * text: the GPU through oracle_evaluate_gpu(), C++ through two functions that the build makes of each case.
 * So to add one:
 *
 *   1. write cases/NAME.glsl, in the library's dialect (glsl/math/dialect.glsl); the Makefile finds it;
 *   2. in the test, ORACLE_CASE(NAME) declares the functions, ORACLE(NAME) is the case.
 *
 * A uniform of an included file becomes a global, to be set by evaluate() or item(). */
#pragma once

#include "gl/context.h"

/* Evaluates width * height texels, four numbers each. `inputs` holds as many. */
typedef void OracleEvaluate(const float *inputs, int width, int height, double *results);

typedef struct OracleCase {
    const char *name;
    OracleEvaluate *in_float, *in_double;
} OracleCase;

#define ORACLE_CASE(name) OracleEvaluate oracle_##name##_float, oracle_##name##_double
#define ORACLE(name)                                                                                         \
    (OracleCase) {                                                                                           \
#name, oracle_##name##_float, oracle_##name##_double                                                 \
    }

/* The same by the GPU. */
void oracle_evaluate_gpu(const Context *context, OracleCase oracle, const float *inputs, int width,
                         int height, float *results);

enum { ORACLE_ITEMS = 128 * 64 };

/* One of an item's eight results, and how well the three agree. An error is relative to the value in double,
 * or to `floor` where that is larger. */
typedef struct OracleQuantity {
    const char *name;
    int result;        /* 0 to 7 */
    int condition;     /* the result that tells how much a rounding of the inputs grows; 0: not at all */
    double floor;      /* in the quantity's unit */
    double rms, worst; /* bounds of the error over the condition; GPU against double */
    double jump;       /* an error past this is a jump, such as a shadow's edge, and only counted; 0: none */
    double most_set_aside; /* bound of the share that is counted only: jumps, and conditions above 1000 */
} OracleQuantity;

/* Evaluates ORACLE_ITEMS items, eight inputs each, three ways; prints each quantity's errors, fails past a
 * bound. */
void oracle_compare(const Context *context, OracleCase oracle, const float *inputs,
                    const OracleQuantity *quantities, int count);
