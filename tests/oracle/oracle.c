#include "oracle/oracle.h"

#include "support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { NUMBERS = 8 * ORACLE_ITEMS, TEXEL_COLUMNS = 256, TEXEL_ROWS = 2 * ORACLE_ITEMS / TEXEL_COLUMNS };

/* What all items say of one pair of compilers. */
typedef struct Errors {
    double squares, worst;
    int counted, set_aside;
} Errors;

void oracle_evaluate_gpu(const Context *context, OracleCase oracle, const float *inputs, int width,
                         int height, float *results) {
    char glsl[256];
    /* Beside the GLSL library, whose folder the include is looked for in. */
    snprintf(glsl, sizeof glsl, "#include \"../tests/oracle/cases/%s.glsl\"\n", oracle.name);
    support_evaluate(context, glsl, inputs, width, height, results);
}

static void errors_add(Errors *errors, const OracleQuantity *quantity, double got, const double *expected) {
    double exact = expected[quantity->result];
    double error = fabs(got - exact) / fmax(fabs(exact), fmax(quantity->floor, 1e-300));
    double condition = quantity->condition ? expected[quantity->condition] : 1;
    /* Not a number is no jump, but an error that makes the RMS none either. */
    if (!(condition <= 1000) || (quantity->jump > 0 && error > quantity->jump)) {
        errors->set_aside++;
        return;
    }
    error /= condition;
    errors->squares += error * error;
    if (!(error <= errors->worst)) errors->worst = error;
    errors->counted++;
}

static double errors_rms(const Errors *errors) {
    return sqrt(errors->squares / fmax(errors->counted, 1));
}

static void check(OracleCase oracle, const OracleQuantity *quantity, const float *gpu, const double *in_float,
                  const double *in_double) {
    Errors driver = {0}, formula = {0};
    for (int i = 0; i < NUMBERS; i += 8) {
        errors_add(&driver, quantity, (double)gpu[i + quantity->result], in_double + i);
        errors_add(&formula, quantity, in_float[i + quantity->result], in_double + i);
    }
    if (quantity->worst > 0) {
        print_message(
            "%s, %s: RMS %.1e, largest %.1e on the GPU; %.1e, %.1e in C++ float; %d of %d set aside\n",
            oracle.name, quantity->name, errors_rms(&driver), driver.worst, errors_rms(&formula),
            formula.worst, driver.set_aside, ORACLE_ITEMS);
    }
    bool exact = errors_rms(&driver) <= quantity->rms && driver.worst <= quantity->worst;
    if (!exact || driver.set_aside > quantity->most_set_aside * ORACLE_ITEMS) {
        fail_msg("%s, %s: RMS %g, largest %g, %d set aside; past %g, %g or %g", oracle.name, quantity->name,
                 errors_rms(&driver), driver.worst, driver.set_aside, quantity->rms, quantity->worst,
                 quantity->most_set_aside * ORACLE_ITEMS);
    }
}

void oracle_compare(const Context *context, OracleCase oracle, const float *inputs,
                    const OracleQuantity *quantities, int count) {
    static float gpu[NUMBERS];
    static double in_float[NUMBERS], in_double[NUMBERS];
    oracle_evaluate_gpu(context, oracle, inputs, TEXEL_COLUMNS, TEXEL_ROWS, gpu);
    oracle.in_float(inputs, TEXEL_COLUMNS, TEXEL_ROWS, in_float);
    oracle.in_double(inputs, TEXEL_COLUMNS, TEXEL_ROWS, in_double);
    for (int i = 0; i < count; i++) check(oracle, &quantities[i], gpu, in_float, in_double);
}
