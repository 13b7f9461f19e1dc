/* Names that are nearly right: the error asks for the one that was meant, and lists those that there are. A
 * name that is like none is met with the list alone. */
#include "support.h"

#include <string.h>

#define RENDER "render scenes/crater.glsl -o never.exr "

static const struct {
    const char *arguments, *part;
} near[] = {
    {RENDER "--sky gaus:8", "unknown method 'gaus:8': did you mean gauss? (known: auto, gauss, table"},
    {RENDER "--sky tabel", "did you mean table?"},
    {RENDER "--light consine", "--light: unknown method 'consine': did you mean cosine?"},
    {RENDER "--light contorl", "did you mean control?"},
    {RENDER "--sequence sobel", "did you mean sobol?"},
    {RENDER "--further harmonic --orders 2", "did you mean harmonics?"},
    {RENDER "--sun-disk=smapled", "did you mean sampled?"},
    {RENDER "--preset sunste", "no preset 'sunste': did you mean sunset? (known: noon"},
    {RENDER "--atmosphere simons2017", "did you mean simmons2017?"},
    {RENDER "--backend osmessa", "did you mean osmesa? (known: auto"},
    {RENDER "--set bal=1", "no setting 'bal': did you mean ball? (known: ball"},
    {RENDER "--set sun.elevatoin=3", "did you mean sun.elevation?"},
    {RENDER "--set elevation=3", "did you mean sun.elevation?"},
    {RENDER "--set camera.fof=3", "did you mean camera.fov?"},
    {RENDER "--set mie_g=0.5", "did you mean atmosphere.mie_g?"},
    {RENDER "--set atmosfere.mie_g=0.5", "did you mean atmosphere.mie_g?"},
    {RENDER "--set atmosphere.mieg=0.5", "unknown setting 'atmosphere.mieg': did you mean atmosphere.mie_g?"},
    {RENDER "--aov albdeo", "--aov: unknown 'albdeo': did you mean albedo?"},
    {RENDER "--tone autor", "did you mean author?"},
};

static const char *const far[] = {"--sky frob",       "--preset winter", "--atmosphere mars",
                                  "--backend vulkan", "--set frob=1",    "--set atmosphere.frob=1",
                                  "--tone film"};

static void test_near(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof near / sizeof *near; i++)
        support_expect(2, near[i].part, "%s", near[i].arguments);
}

static void test_far(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof far / sizeof *far; i++) {
        support_expect(2, "(known: ", RENDER "%s", far[i]);
        if (strstr(support_err, "did you mean")) fail_msg("%s: %s", far[i], support_err);
    }
}

/* In a scene, with the place. */
static void test_scene(void **state) {
    (void)state;
    static const struct {
        const char *line, *part;
    } cases[] = {
        {"//@ tilte x\n", "near.glsl:1: unknown annotation 'tilte': did you mean title?"},
        {"\n//@ mirror-shpere 0 1 0 1\n",
         "near.glsl:2: unknown annotation 'mirror-shpere': did you mean mirror-sphere?"},
        {"//@ sun elevatoin 5\n", "near.glsl:1: sun: unknown key 'elevatoin': did you mean elevation?"},
        {"//@ camera eie 0 1 2\n", "did you mean eye?"},
        {"//@ atmosphere erth\n", "near.glsl:1: unknown atmosphere 'erth': did you mean earth?"},
        {"uniform float a; //@ slider 1 min 0 mxa 2\n", "slider: unknown key 'mxa': did you mean max?"},
        {"#include \"shape/spehre.glsl\"\n", "near.glsl:1: no file 'shape/spehre.glsl'"},
        {"#include \"shape/spehre.glsl\"\n", ": did you mean shape/sphere.glsl?"},
        {"#include \"material/mat.glsl\"\n", ": did you mean material/matte.glsl?"},
        {"uniform float size_m; //@ slider 1\n//@ preset low size_n 0.5\n", "near.glsl:2: "},
        {"uniform float size_m; //@ slider 1\n//@ preset low size_n 0.5\n", "did you mean size_m?"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        support_expect(3, cases[i].part, "info '%s'", support_write("near.glsl", cases[i].line));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_near), cmocka_unit_test(test_far),
                                       cmocka_unit_test(test_scene)};
    return cmocka_run_group_tests_name("meant", tests, support_folder, support_clean);
}
