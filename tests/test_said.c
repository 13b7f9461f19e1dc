/* What would once have been accepted in silence: lines that undo each other, uniforms that nothing sets,
 * words too many. Each is refused with its file and its line. */
#include "support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define INTERSECT "void scene_intersect(Ray ray, INOUT(Hit) hit) { }\n"
#define REST INTERSECT "Material scene_material(Hit hit) { return material_new(0, vec3(0)); }\n"

static void expect_refused(const char *text, const char *part) {
    const char *scene = support_write("said.glsl", text);
    support_expect(3, part, "info '%s'", scene);
}

/* The second of two lines of which one is enough. */
static void test_twice(void **state) {
    (void)state;
    static const struct {
        const char *line, *part;
    } cases[] = {
        {"title a", "said.glsl:3: title is there already, in line 1"},
        {"look a", "said.glsl:3: look is there already, in line 1"},
        {"size 8 8", "said.glsl:3: size is there already, in line 1"},
        {"exposure 1", "said.glsl:3: exposure is there already, in line 1"},
        {"sky uniform", "said.glsl:3: sky is there already, in line 1"},
        {"atmosphere earth", "said.glsl:3: atmosphere is there already, in line 1"},
        {"sun-disk on", "said.glsl:3: sun-disk is there already, in line 1"},
        {"spheres 3", "said.glsl:3: spheres is there already, in line 1"},
        {"sun elevation 3", "said.glsl:3: sun elevation is there already, in line 1"},
        {"camera fov 30", "said.glsl:3: camera fov is there already, in line 1"},
        {"camera fov 30 eye 0 1 0 target 1 2 3", "said.glsl:3: camera fov is there already, in line 1"},
    };
    char text[1024];
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        snprintf(text, sizeof text, "//@ %s\n\n//@ %s\n" REST, cases[i].line, cases[i].line);
        expect_refused(text, cases[i].part);
        snprintf(text, sizeof text, "//@ %s\n\n// //@ %s\n#if 0\n//@ %s\n#endif\n" REST, cases[i].line,
                 cases[i].line, cases[i].line);
        support_expect(0, "", "info '%s'", support_write("said.glsl", text));
    }
    expect_refused("//@ sun elevation 3 azimuth 4 elevation 5\n",
                   "said.glsl:1: sun elevation is there already, in line 1");
    expect_refused("//@ preset a sun.elevation 3 exposure 1 sun.elevation 4\n",
                   "said.glsl:1: preset a sets sun.elevation twice");
    expect_refused("uniform float a; //@ slider 1 min 0 max 3 min 1\n", "slider: min is there twice");
    expect_refused("uniform float a; //@ slider 1 label x unit m label y\n", "slider: label is there twice");
    /* Keys of one annotation in several lines, and lines that add up. */
    support_expect(0, "", "info '%s'",
                   support_write("said.glsl",
                                 "//@ camera eye 0 1 -2\n//@ camera fov 40\n//@ sun elevation 3\n"
                                 "//@ sun azimuth 9\n//@ bound 0 0 0 1\n//@ bound 0 0 0 2\n"
                                 "uniform float a; //@ slider 1 label unit unit label\n" REST));
}

static void test_too_many_words(void **state) {
    (void)state;
    expect_refused("//@ size 8 8 8\n", "said.glsl:1: size: '8' is one word too many");
    expect_refused("//@ exposure 1 EV\n", "said.glsl:1: exposure: 'EV' is one word too many");
    expect_refused("//@ camera\n", "said.glsl:1: camera needs eye and its value");
    expect_refused("//@ sun\n", "said.glsl:1: sun needs elevation and its value");
}

static void test_uniforms(void **state) {
    (void)state;
    static const struct {
        const char *declaration, *part;
    } refused[] = {
        {"uniform float height;",
         "said.glsl:2: nothing sets the uniform 'height': `//@ slider 1 min 0 max 2`"},
        {"uniform bool lit; // a lamp", "said.glsl:2: nothing sets the uniform 'lit': `//@ checkbox on`"},
        {"uniform vec3 tint;", "said.glsl:2: nothing sets the uniform 'tint': `//@ color 1 1 1`"},
        {"uniform int count;", "said.glsl:2: nothing sets the uniform 'count': only float, bool and vec3"},
        {"uniform sampler2D picture;",
         "said.glsl:2: nothing sets the uniform 'picture': a scene has no pictures"},
        {"uniform float a = 1.0, b;", "said.glsl:2: nothing sets the uniform 'b'"},
        {"uniform float a[2];", "said.glsl:2: nothing sets the uniform 'a'"},
        {"uniform\n  highp float\n  deep;", "said.glsl:4: nothing sets the uniform 'deep': `//@ slider"},
    };
    static const char *const accepted[] = {
        "uniform float height = 2.0;",
        "uniform vec3 tint = vec3(1.0, 0.5, 0.2), other = vec3(0.0);",
        "uniform float height; //@ slider 1",
        "// uniform float height;",
        "#if 0\nuniform float height;\n#endif",
        "/* uniform float\n height; */",
        "uniform float iTime;",
        "#include \"shape/spheres.glsl\"",
    };
    char text[1024];
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        snprintf(text, sizeof text, "// one\n%s\n" REST, refused[i].declaration);
        expect_refused(text, refused[i].part);
    }
    for (size_t i = 0; i < sizeof accepted / sizeof *accepted; i++) {
        snprintf(text, sizeof text, "%s\n" REST, accepted[i]);
        support_expect(0, "", "info '%s'", support_write("said.glsl", text));
    }
    /* In a file that the scene includes, whose annotations are not read. */
    support_write("part.glsl", "\n\nuniform float wide; //@ slider 1\n");
    expect_refused("#include \"part.glsl\"\n" REST, "part.glsl:3: nothing sets the uniform 'wide'");
    assert_non_null(strstr(support_err, "(annotations are read in "));
}

/* How a file is included. */
static void test_slots(void **state) {
    (void)state;
    expect_refused(
        "\n#include <shape/sphere.glsl>\n" REST,
        "said.glsl:2: unknown slot <shape/sphere.glsl> in #include: a file is included in quotation "
        "marks, #include \"shape/sphere.glsl\"");
}

/* What contradicts itself is refused; what has no effect is warned of, and done. */
static void test_options(void **state) {
    (void)state;
    static const char *const refused[][2] = {
        {"compare a b --quiet --json", "--quiet prints nothing, --json prints a line"},
        {"render a -o b.exr --quiet -v", "--quiet says nothing, -v says more"},
        {"render a -o b.exr --spp 3 --error 1", "--spp takes so many: one of them"},
        {"render scenes/crater.glsl -o b.exr --orders 0",
         "orders: 0 is outside the range from 1 to 1000 or all"},
        {"render scenes/crater.glsl -o b.exr --orders some",
         "orders: 'some' is not a whole number from 1 to 1000 or all"},
        {"render scenes/crater.glsl -o b.exr --set hover=9", "hover: 9 is outside the range from -0.5 to 3"},
        {"render a -o b.exr --sun 5,90,7", "'5,90,7' is not EL or EL,AZ"},
    };
    static const char *const warned[][2] = {
        {"render scenes/crater.glsl --size 8x8 --spp 1 --tone none -o $D/a.exr",
         "--tone has no effect: no -o is a PNG"},
        {"render scenes/crater.glsl --size 8x8 --spp 1 --further harmonics:8 -o $D/a.exr",
         "--further has no effect"},
        {"sky --size 8x4 --exposure 1 -o $D/a.exr", "--exposure has no effect: no -o is a PNG"},
        {"sky --size 8x4 --set camera.fov=3 -o $D/a.exr",
         "--set camera.fov=3 has no effect: there is no scene"},
        {"sky --at $D/rows.csv --sun 5", "--sun has no effect: with --at, the rows say it all"},
        {"sky --at $D/rows.csv --size 8x4", "--size has no effect"},
        {"info scenes/crater.glsl --backend egl", "--backend has no effect"},
        {"flatten scenes/furnace.glsl --all --json", "--all has no effect"},
    };
    static const char *const silent[] = {
        "render scenes/crater.glsl --size 8x8 --spp 1 --tone none -o $D/a.png",
        "render scenes/crater.glsl --size 8x8 --spp 1 --tone none -o $D/a --format png",
        "render scenes/crater.glsl --size 8x8 --spp 1 --spp 2 --set ball=0 --set ball=1 -o $D/a.exr",
        "sky --size 8x4 --exposure 1 --set exposure=1 -o $D/a.png",
    };
    support_write("rows.csv", "0,30,20,0\n");
    setenv("D", support_path(""), 1);
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++)
        support_expect(2, refused[i][1], "%s", refused[i][0]);
    for (size_t i = 0; i < sizeof warned / sizeof *warned; i++) {
        support_expect(0, warned[i][1], "%s", warned[i][0]);
        assert_non_null(strstr(support_err, "magichour: warning: "));
    }
    for (size_t i = 0; i < sizeof silent / sizeof *silent; i++) {
        support_expect(0, "", "%s", silent[i]);
        assert_null(strstr(support_err, "warning"));
    }
}

/* Why nothing can be made there. */
static void test_reasons(void **state) {
    (void)state;
    const char *file = support_write("file", "");
    support_expect(5, "no folder can be made there: Not a directory", "chart scenes/crater.glsl -o '%s/x'",
                   file);
    support_expect(5, "no folder can be made there: File exists", "chart scenes/crater.glsl -o '%s'", file);
    support_expect(2, "so -o names a folder", "chart scenes/crater.glsl -o -");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_twice), cmocka_unit_test(test_too_many_words), cmocka_unit_test(test_uniforms),
        cmocka_unit_test(test_slots), cmocka_unit_test(test_options),        cmocka_unit_test(test_reasons),
    };
    return cmocka_run_group_tests_name("said", tests, support_folder, support_clean);
}
