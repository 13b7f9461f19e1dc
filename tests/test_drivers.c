/* Each scene that is shipped by both of Mesa's software drivers. llvmpipe is known to compile loops wrongly
 * without a word, and softpipe shares no code generator with it. */
#include "drivers.h"
#include "scene_list.h"
#include "support.h"

#include "choice/method.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Small, because softpipe takes a thousand times as long as a GPU, and under an atmosphere whose sky takes no
 * time. The difference of two roundings grows with each hit on a curved mirror or a fractal, until paths part
 * that no driver has wrong, so that the paths have three hits. */
#define PICTURE "--size 16x16 --spp 8 --seed 5 --sun 20 --atmosphere simmons2017 --sky table --depth 3"

/* The light methods but for the plain one. */
static int lights(const char *names[32]) {
    int count = 0;
    for (int i = 0; method_get(i); i++) {
        bool other = method_get(i)->family == METHOD_LIGHT && strcmp(method_get(i)->name, "cosine") != 0;
        if (other && count < 32) names[count++] = method_get(i)->name;
    }
    return count;
}

static void compare(const char *scene, const char *light, double *all) {
    char arguments[256];
    snprintf(arguments, sizeof arguments, PICTURE " --light %s", light);
    DriversDifference drivers = drivers_compare(scene, arguments);
    print_message("%s, %s: %d of %d values differ, the others' bias %.1e, of all %.1e\n", scene, light,
                  drivers.differ, drivers.values, drivers.bias_of_same, drivers.bias);
    /* Rays that search along a field pass edges on their other side more often. */
    assert_true(drivers.differ <= drivers.values / 32);
    assert_true(fabs(drivers.bias_of_same) < 5e-5);
    *all += drivers.bias;
}

/* The plain method on each scene, and on each second one another method in turn: a minute on two cores. */
static void test_every_scene(void **state) {
    (void)state;
    SceneList list = scene_list();
    const char *names[32];
    int count = lights(names), pictures = 0;
    double all = 0;
    drivers_need_both();
    assert_true(count > 0);
    for (int i = 0; i < list.count; i++) {
        compare(list.paths[i], "cosine", &all);
        pictures++;
        if (i % 2) continue;
        compare(list.paths[i], names[i / 2 % count], &all);
        pictures++;
    }
    print_message("bias of all %d pictures: %.1e\n", pictures, all / pictures);
    assert_true(fabs(all / pictures) < 1e-4);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_every_scene)};
    return cmocka_run_group_tests_name("drivers", tests, support_folder, support_clean);
}
