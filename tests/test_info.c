/* What `info SCENE` says: all that a scene's annotations set. */
#include "support.h"

#include "scene/atmosphere.h"

#include <string.h>

static const char *const scene_text = "//@ title Hints\n"
                                      "//@ sun-disk on\n"
                                      "//@ bound 0 1.50 0 2\n"
                                      "uniform float height; //@ slider 3 min 0 max 9\n"
                                      "//@ bound 0 height 0 1\n"
                                      "//@ mirror-sphere 1 2 3 0.5\n"
                                      "//@ mirror-plane 180 -height\n"
                                      "//@ emitter-sphere 4 5 6 7\n"
                                      "//@ spheres many\n"
                                      "uniform float many; //@ slider 8 min 0 max 100\n";

static void expect_lines(const char *const *lines, int count) {
    for (int i = 0; i < count; i++) {
        if (!strstr(support_out, lines[i])) fail_msg("no '%s' in:\n%s", lines[i], support_out);
    }
}

static void test_scene(void **state) {
    (void)state;
    static const char *const as_written[] = {
        ": Hints\n",
        "\n  sun-disk on, radius 0.2666 degrees\n",
        "\n  bound 0 1.50 0 2\n",
        "\n  bound 0 height 0 1  = 0,3,0,1\n",
        "\n  mirror-sphere 1 2 3 0.5\n",
        "\n  mirror-plane 180 -height  = 180,-3\n",
        "\n  emitter-sphere 4 5 6 7\n",
        "\n  spheres many  = 8\n",
    };
    static const char *const set[] = {
        "\n  sun-disk on, radius 2 degrees\n",
        "\n  bound 0 height 0 1  = 0,4.5,0,1\n",
        "\n  spheres many  = 20\n",
    };
    const char *scene = support_write("hints.glsl", scene_text);
    support_expect(0, "", "info '%s'", scene);
    expect_lines(as_written, sizeof as_written / sizeof *as_written);
    support_expect(0, "", "info '%s' --set height=4.5 --set many=20 --set sun.radius=2", scene);
    expect_lines(set, sizeof set / sizeof *set);
    scene = support_write("plain.glsl", "//@ spheres balls.csv\n");
    support_write("balls.csv", "0,0,0,1\n");
    support_expect(0, "", "info '%s'", scene);
    assert_non_null(strstr(support_out, "\n  sun-disk off, radius 0.2666 degrees\n"));
    assert_non_null(strstr(support_out, "\n  spheres balls.csv\n"));
    assert_null(strstr(support_out, "\n  bound"));
}

static int count_lines(const char *words) {
    int count = 0;
    for (const char *at = support_out; (at = strstr(at, words)); at++) count++;
    return count;
}

/* Of the atmosphere, its preset and what differs from it; all settings where that is asked for. */
static void test_atmosphere(void **state) {
    (void)state;
    const char *plain = support_write("plain.glsl", "//@ title Plain\n"),
               *earth =
                   support_write("earth.glsl", "//@ atmosphere earth\n//@ preset haze atmosphere.mie 4\n");
    support_expect(0, "", "info '%s'", plain);
    assert_non_null(strstr(support_out, "\n  atmosphere simmons2017 (-v lists its settings)\n"));
    assert_non_null(strstr(support_out, "\n  camera eye 0,2,-4 target 0,0,0 fov 90\n"));
    assert_int_equal(count_lines("  atmosphere."), 0);
    support_expect(0, "", "info '%s' --set atmosphere.mie_g=0.5", earth);
    assert_non_null(
        strstr(support_out, "\n  atmosphere earth, except for (-v lists all):\n  atmosphere.mie_g = 0.5  ("));
    assert_int_equal(count_lines("  atmosphere."), 1);
    support_expect(0, "", "info '%s' --preset haze", earth);
    assert_non_null(strstr(support_out, "\n  atmosphere.mie = 4  ("));
    support_expect(0, "", "info '%s' --atmosphere earth", plain);
    assert_non_null(strstr(support_out, "\n  atmosphere earth (-v lists its settings)\n"));
    support_expect(0, "", "info '%s' -v", earth);
    assert_non_null(strstr(support_out, "\n  atmosphere earth, with all its settings:\n"));
    int fields = 0;
    while (atmosphere_field(fields)) fields++;
    assert_int_equal(count_lines("  atmosphere."), fields);
    support_expect(2, "no preset 'haze'", "info --preset haze");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_scene), cmocka_unit_test(test_atmosphere)};
    return cmocka_run_group_tests_name("info", tests, support_folder, support_clean);
}
