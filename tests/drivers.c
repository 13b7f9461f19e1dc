#include "drivers.h"

#include "mist.h"
#include "support.h"

#include <math.h>
#include <string.h>

static const char softpipe[] = "GALLIUM_DRIVER=softpipe LIBGL_ALWAYS_SOFTWARE=1";
static const char llvmpipe[] = "GALLIUM_DRIVER=llvmpipe LIBGL_ALWAYS_SOFTWARE=1";

void drivers_need_both(void) {
    support_run(softpipe, "info");
    if (strstr(support_out, "softpipe")) return;
    print_message("no softpipe here\n");
    skip();
}

DriversDifference drivers_compare(const char *scene, const char *arguments) {
    DriversDifference result = {0};
    Image a = mist_render(softpipe, scene, arguments), b = mist_render(llvmpipe, scene, arguments);
    double level = 0, all[2] = {0}, same[2] = {0};
    assert_int_equal(a.width * a.height, b.width * b.height);
    result.values = 3 * a.width * a.height;
    for (int i = 0; i < result.values; i++) level += fabs((double)a.rgba[i / 3 * 4 + i % 3]) / result.values;
    for (int i = 0; i < result.values; i++) {
        double x = (double)a.rgba[i / 3 * 4 + i % 3], y = (double)b.rgba[i / 3 * 4 + i % 3];
        /* The differences that `control` adds up may cancel each other. */
        bool near = fabs(x - y) <= 1e-3 * fabs(x) + 1e-5 * level;
        result.differ += !near;
        result.worst = fmax(result.worst, fabs(x - y) / level);
        all[0] += x;
        all[1] += y;
        same[0] += near ? x : 0;
        same[1] += near ? y : 0;
    }
    result.bias = all[1] / all[0] - 1;
    result.bias_of_same = same[1] / same[0] - 1;
    image_free(&a);
    image_free(&b);
    return result;
}
