/* Small stacks and little memory: everything works with 200 KiB of stack, and where memory runs out one line
 * says so. */
#include "faults.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define SMALL "--size 32x32 --spp 1 --quiet"

/* The deepest texts that are allowed, too. */
static void test_stack(void **state) {
    (void)state;
    static const char *const commands[] = {
        "help --man",
        "info scenes/materials.glsl",
        "flatten scenes/materials.glsl",
        "flatten $D/deep.glsl",
        "flatten $D/nested.glsl",
        "flatten $D/toy.glsl",
        "render scenes/crater.glsl " SMALL " --aov albedo,variance -o $D/a.exr",
        "render scenes/crater.glsl " SMALL " -o $D/a.png",
        "render scenes/spheres.glsl " SMALL " -o $D/a.pfm",
        "render $D/same.glsl " SMALL " -o $D/b.pfm",
        "sky --size 32x16 --quiet -o $D/sky.exr",
        "sky --at $D/rows.csv",
        "compare $D/a.exr $D/a.exr -o $D/d.png",
        "compare $D/a.png $D/a.png",
        "compare $D/a.pfm $D/a.pfm",
        "compare tests/data/dwaa.exr tests/data/dwaa.exr",
    };
    assert_int_equal(
        fault_shell(
            "cd $D && for i in $(seq 60); do echo \"#include \\\"e$((i + 1)).glsl\\\"\" >e$i.glsl; done; "
            "cp e60.glsl deep.glsl; echo >e61.glsl; s='void scene_intersect(Ray ray, INOUT(Hit) hit) {'; "
            "m='Material scene_material(Hit hit) { return matte(vec3(0.5)); }'; "
            "{ echo '#include \"e1.glsl\"'; echo '#include \"material/matte.glsl\"'; echo \"$s }\"; echo "
            "\"$m\"; } >deep.glsl; "
            "{ cat deep.glsl; yes '{(' | head -n 100000; } >nested.glsl; "
            "{ echo 'void mainImage(out vec4 c, vec2 p) {'; yes '{(' | head -n 100000; } >toy.glsl; "
            "{ echo '//@ spheres same.csv'; echo '#include \"shape/spheres.glsl\"'; "
            "echo '#include \"material/matte.glsl\"'; echo \"$s hit_spheres(ray, 0, hit); }\"; echo \"$m\"; "
            "} >same.glsl; "
            "yes 1,1,1,1 | head -n 20000 >same.csv; echo 0,30,20,0 >rows.csv"),
        0);
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        int status = fault_shell("ulimit -s 200; $M %s >$D/out", commands[i]);
        if (status != 0) fail_msg("%s: status %d: %s", commands[i], status, support_err);
    }
}

/* In steps, so that memory runs out at many places. */
static void test_memory(void **state) {
    (void)state;
    if (FAULT_SLOWER > 1) {
        print_message("skipped: the sanitizers take terabytes of addresses\n");
        skip();
    }
    static const char *const commands[] = {
        "compare $D/m.exr $D/m.exr", "compare $D/m.pfm $D/m.pfm",
        "compare $D/m.png $D/m.png", "compare tests/data/dwaa.exr tests/data/dwaa.exr",
        "info $D/many.glsl",
    };
    assert_int_equal(
        fault_shell("$M sky --size 1024x512 --quiet -o $D/m.exr -o $D/m.pfm -o $D/m.png; "
                    "{ echo 'void scene_intersect(Ray ray, INOUT(Hit) hit) {}'; "
                    "echo 'Material scene_material(Hit hit) { return material_new(0, vec3(0)); }'; "
                    "yes 'struct s { int a; };' | head -n 45000; } >$D/many.glsl"),
        0);
    int refused = 0;
    for (int kilobytes = 40000; kilobytes <= 120000; kilobytes += 8000) {
        for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
            int status = fault_shell("ulimit -v %d; exec $M %s >$D/out", kilobytes, commands[i]);
            /* With too little the program's libraries are not even loaded. */
            if (status == 0 || status == 127) continue;
            if (status != 1 || !strstr(support_err, "out of memory") || strchr(support_err, '\n')[1])
                fail_msg("%s with %d kB: status %d: %s", commands[i], kilobytes, status, support_err);
            refused++;
        }
    }
    print_message("%d times out of memory\n", refused);
    assert_true(refused > 3);
    for (int kilobytes = 150000; kilobytes <= 600000; kilobytes += 90000) {
        int status =
            fault_shell("ulimit -v %d; exec $M render scenes/crater.glsl " SMALL " -o $D/c.exr", kilobytes);
        if (status != 4 || !strstr(support_err, "magichour: out of memory: an OpenGL driver needs about"))
            fail_msg("render with %d kB: status %d: %s", kilobytes, status, support_err);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_stack), cmocka_unit_test(test_memory)};
    return cmocka_run_group_tests_name("limits", tests, support_folder, support_clean);
}
