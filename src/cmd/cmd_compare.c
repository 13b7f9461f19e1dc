#include "cmd/cmd.h"
#include "image/compare.h"
#include "image/format.h"

#include <math.h>
#include <stdio.h>

static void print_comparison(const Comparison *c) {
    printf("relRMSE      %.4f %%\n", c->rel_rmse_percent);
    printf("  trimmed    %.4f %%  (without the 0.1 %% worst pixels)\n", c->trimmed_percent);
    printf("bias R G B   %+.4f %+.4f %+.4f %%\n", c->bias_percent[0], c->bias_percent[1], c->bias_percent[2]);
    printf("largest      %.4f %%\n", c->largest_percent);
    printf("p99          %.4f %%\n", c->p99_percent);
    printf("pixels       %ld, %ld not finite\n", c->pixels, c->nonfinite);
    if (c->has_z) printf("mean z^2     %.4f, |z| > 4 in %.4f %%\n", c->mean_z2, c->share_z4_percent);
}

/* NaN exceeds every bound. */
static bool within(double value, double bound) {
    return isinf(bound) || fabs(value) <= bound;
}

static bool read_optional(const char *path, Image *image, Error *error) {
    return !path || image_read(image, path, error);
}

Status cmd_compare(const Options *options, Error *error) {
    Image a = {0}, b = {0}, standard_error = {0}, mask = {0};
    Comparison c;
    bool ok = image_read(&a, options->inputs[0], error) && image_read(&b, options->inputs[1], error) &&
              read_optional(options->standard_error, &standard_error, error) &&
              read_optional(options->mask, &mask, error) &&
              compare_images(&a, &b, options->standard_error ? &standard_error : NULL,
                             options->mask ? &mask : NULL, &c, error);
    image_free(&a);
    image_free(&b);
    image_free(&standard_error);
    image_free(&mask);
    if (!ok) return error->status;
    print_comparison(&c);
    bool inside = within(c.rel_rmse_percent, options->max_relrmse_percent);
    for (int i = 0; i < 3; i++) inside = inside && within(c.bias_percent[i], options->max_bias_percent);
    /* A bound is a promise about every pixel that is compared. A pixel that is not finite breaks it. */
    bool bounded = !isinf(options->max_relrmse_percent) || !isinf(options->max_bias_percent);
    if (inside && !(bounded && c.nonfinite)) return STATUS_DONE;
    error_set(error, STATUS_COMPARISON, "%s differs from %s by more than allowed", options->inputs[0],
              options->inputs[1]);
    return STATUS_COMPARISON;
}
