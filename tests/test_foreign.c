/* Scenes of strangers: which files they may read, of which size, and that each fault is one clear line. */
#include "faults.h"

#include "base/memory.h"
#include "base/names.h"
#include "source/glsl_source.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#define SCENE                                                                                                \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {}\n"                                                     \
    "Material scene_material(Hit hit) { return material_new(0, vec3(0)); }\n"
#define TOY "void mainImage(out vec4 color, in vec2 at) { color = vec4(0); }\n"

/* home/ is the scene's folder; beside it lies what is none of its business. */
static int make_folders(void **state) {
    if (support_folder(state) != 0) return -1;
    return fault_shell(
        "mkdir $D/home $D/home/sub $D/other && printf 'SECRET\\n' >$D/other/secret && "
        "printf 'SECRET,1,2,3\\n' >$D/other/secret.csv && printf '1,2,3,1\\n' >$D/other/balls.csv && "
        "printf 'float other() { return 1.0; }\\n' >$D/other/good.glsl && "
        "ln -s ../other/secret $D/home/link.glsl && ln -s ../other $D/home/linked && "
        "ln -s ../other/secret.csv $D/home/balls.csv && ln -s link.glsl $D/home/chain.glsl");
}

static const char *scene(const char *line) {
    Text text = {0};
    text_print(&text, "\n%s\n" SCENE, line);
    const char *path = support_write("home/scene.glsl", text_string(&text));
    text_free(&text);
    return path;
}

static void expect_refused(const char *line, const char *part) {
    const char *path = scene(line);
    Text place = {0};
    text_print(&place, "%s:2: ", path);
    fault_expect(3, text_string(&place), "info '%s'", path);
    text_free(&place);
    if (!strstr(support_err, part)) fail_msg("%s: '%s' is not in: %s", line, part, support_err);
    if (strstr(support_err, "SECRET") || strstr(support_err, "root:"))
        fail_msg("%s: the foreign text is in: %s", line, support_err);
}

static void test_places(void **state) {
    (void)state;
    static const char outside[] = "lies outside of the scene's folder and of the GLSL library",
                      absolute[] = "is an absolute path";
    char line[2048];
    expect_refused("#include \"/etc/passwd\"", absolute);
    expect_refused("#include \"/no/such/file\"", absolute);
    expect_refused("#include \"../other/secret\"", outside);
    expect_refused("#include \"sub/../../other/secret\"", outside);
    expect_refused("#include \"./sub/.././../other/secret\"", outside);
    expect_refused("#include \"link.glsl\"", outside);
    expect_refused("#include \"chain.glsl\"", outside);
    expect_refused("#include \"linked/secret\"", outside);
    expect_refused("#include \"material/../../../../../../../../../../etc/passwd\"", outside);
    expect_refused("//@ spheres balls.csv", outside);
    expect_refused("//@ spheres ../other/secret.csv", outside);
    snprintf(line, sizeof line, "//@ spheres %s", support_path("other/secret.csv"));
    expect_refused(line, absolute);
    snprintf(line, sizeof line, "#include \"%s\"", support_path("home/sub"));
    expect_refused(line, absolute);
    /* Not the folder whose name only begins like the scene's. */
    assert_int_equal(fault_shell("mkdir $D/home2 && echo >$D/home2/a.glsl"), 0);
    expect_refused("#include \"../home2/a.glsl\"", outside);
}

static void expect_read(const char *line, const char *options) {
    const char *path = scene(line);
    if (support_run("", "info '%s' %s", path, options) != 0)
        fail_msg("%s %s: %s", line, options, support_err);
}

/* What may be read: the folder's own tree however it is spelled, the library, and what is allowed. */
static void test_allowed(void **state) {
    (void)state;
    char line[2048], options[2048];
    support_write("home/a.glsl", "float a() { return 1.0; }\n#include \"sub/b.glsl\"\n");
    support_write("home/sub/b.glsl", "#include \"../a.glsl\"\n#include \"../../home/a.glsl\"\n");
    expect_read("#include \"a.glsl\"", "");
    expect_read("#include \"material/matte.glsl\"", "");
    expect_read("#include \"./material//../material/matte.glsl\"", "");
    snprintf(options, sizeof options, "--allow-includes '%s' --allow-includes '%s'", support_path("home2"),
             support_path("other"));
    expect_read("#include \"../other/good.glsl\"", options);
    expect_read("#include \"linked/good.glsl\"", options);
    snprintf(line, sizeof line, "#include \"%s\"", support_path("other/good.glsl"));
    expect_read(line, options);
    snprintf(line, sizeof line, "//@ spheres %s", support_path("other/balls.csv"));
    expect_read(line, options);
    fault_expect(2, "--allow-includes /no/folder: No such file or directory",
                 "info scenes/crater.glsl --allow-includes /no/folder");
    /* The scene itself may be anywhere, behind a link too, and so may its folder. */
    assert_int_equal(fault_shell("ln -s $D/home/a.glsl $D/other/away.glsl; ln -s home $D/way"), 0);
    fault_expect(3, "away.glsl:2: no file 'sub/b.glsl' beside this one", "info '%s'",
                 support_path("other/away.glsl"));
    expect_read("#include \"a.glsl\"", "");
    if (support_run("", "info '%s/scene.glsl'", support_path("way")) != 0) fail_msg("%s", support_err);
}

static void test_kinds(void **state) {
    (void)state;
    static const struct {
        const char *name, *part;
    } kinds[] = {{"pipe.glsl", "a pipe, and no regular file"},
                 {"socket.glsl", "a socket, and no regular file"},
                 {"device.glsl", "a device, and no regular file"},
                 {"folder.glsl", "Is a directory"}};
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    int made = socket(AF_UNIX, SOCK_STREAM, 0);
    snprintf(address.sun_path, sizeof address.sun_path, "%s", support_path("home/socket.glsl"));
    assert_true(made >= 0 && bind(made, (struct sockaddr *)&address, sizeof address) == 0);
    close(made);
    assert_int_equal(
        fault_shell("cd $D/home && mkfifo pipe.glsl && mkdir folder.glsl && ln -s /dev/zero "
                    "device.glsl && for k in pipe socket device folder; do ln -s $k.glsl $k.csv; done"),
        0);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        char path[1024], line[256];
        snprintf(path, sizeof path, "%s/%s", support_path("home"), kinds[i].name);
        fault_expect(3, kinds[i].part, "info '%s'", path);
        fault_expect(3, kinds[i].part, "render '%s' -o '%s'", path, support_path("a.exr"));
        fault_expect(1, kinds[i].part, "compare '%s' '%s'", path, path);
        fault_expect(1, kinds[i].part, "compare tests/data/dwaa.exr '%s'", path);
        fault_expect(1, kinds[i].part, "compare tests/data/dwaa.exr tests/data/dwaa.exr --mask '%s'", path);
        fault_expect(2, kinds[i].part, "sky --at '%s'", path);
        fault_expect(2, kinds[i].part, "chart scenes/crater.glsl --points '%s' -o '%s'", path,
                     support_path("charts"));
        snprintf(line, sizeof line, "#include \"%s\"", kinds[i].name);
        expect_refused(line, kinds[i].part);
        snprintf(line, sizeof line, "//@ spheres %.*s.csv", (int)strcspn(kinds[i].name, "."), kinds[i].name);
        expect_refused(line, kinds[i].part);
    }
    fault_expect(3, "/dev/zero: cannot be read: a device", "info /dev/zero");
}

/* A file of `size` bytes that repeats the unit behind the start. */
static const char *fill(const char *name, const char *start, const char *unit, size_t size) {
    Text text = {0};
    text_print(&text, "%s", start);
    while (text.size + strlen(unit) <= size) text_append(&text, unit, strlen(unit));
    const char *path = support_write(name, text_string(&text));
    text_free(&text);
    return path;
}

static void test_sizes(void **state) {
    (void)state;
    char line[64];
    fault_expect(3, "it has 1048580 bytes, and at most 1048576 can be", "info '%s'",
                 fill("home/big.glsl", "", "// x", 1048580));
    expect_refused("#include \"big.glsl\"", "it has 1048580 bytes");
    for (int i = 0; i < 5; i++) {
        snprintf(line, sizeof line, "home/part%d.glsl", i);
        fill(line, "", "// x", 1000000);
    }
    const char *path = scene("#include \"part0.glsl\"\n#include \"part1.glsl\"\n#include \"part2.glsl\"\n"
                             "#include \"part3.glsl\"\n#include \"part4.glsl\"");
    fault_expect(3, "scene.glsl:6: ", "info '%s'", path);
    if (!strstr(support_err, "and at most 4194304 can be read")) fail_msg("%s", support_err);
    fault_expect(3, "more than 10000 #include lines", "info '%s'",
                 fill("home/lines.glsl", SCENE, "#include \"a.glsl\"\n", 1000000));
    assert_int_equal(fault_shell("truncate -s 68000000 $D/home/huge.csv"), 0);
    expect_refused("//@ spheres huge.csv", "it has 68000000 bytes, and at most 67108864 can be");
}

static void test_tables(void **state) {
    (void)state;
    assert_int_equal(
        fault_shell("cd $D && yes 0,30,20,0 | head -n 1000001 >rows.csv; truncate -s 70M long.csv; "
                    "yes 1,1,1,1 | head -n 2000000 >home/balls2.csv"),
        0);
    fault_expect(2, "rows.csv: it has 1000001 lines, and at most 1000000 can be read", "sky --at '%s'",
                 support_path("rows.csv"));
    fault_expect(2, "long.csv: cannot be read: it has 73400320 bytes", "sky --at '%s'",
                 support_path("long.csv"));
    fault_expect(3, "balls2.csv:1000001: more than 1000000 spheres", "render '%s' -o '%s'",
                 scene("//@ spheres balls2.csv\n#include \"shape/spheres.glsl\""), support_path("a.exr"));
}

/* Tiny files that include each other again and again, by two spellings, are read once each. */
static void test_bomb(void **state) {
    (void)state;
    assert_int_equal(fault_shell("cd $D/home && for i in $(seq 42); do j=$((i + 1)); printf "
                                 "'#include \"./d%%d.glsl\"\\n#include \".//sub/../d%%d.glsl\"\\n' $j $j "
                                 ">d$i.glsl; done; echo 'float d() { return 1.0; }' >d43.glsl"),
                     0);
    expect_read("#include \"d1.glsl\"", "");
    /* A file that includes itself, and a chain that is too long. */
    support_write("home/self.glsl", "#include \"./self.glsl\"\n#include \".//self.glsl\"\n");
    expect_read("#include \"self.glsl\"", "");
    assert_int_equal(fault_shell("cd $D/home && for i in $(seq 200); do echo \"#include "
                                 "\\\"e$((i + 1)).glsl\\\"\" >e$i.glsl; done; echo >e201.glsl"),
                     0);
    fault_expect(3, "files include each other more than 64 deep", "info '%s'", scene("#include \"e1.glsl\""));
    assert_int_equal(
        fault_shell("cd $D/home && mkdir many && cd many && touch $(seq -f %%g.glsl 2100) && seq "
                    "-f '#include \"many/%%g.glsl\"' 2100 >../many.glsl"),
        0);
    fault_expect(3, "more than 2000 files for one scene", "info '%s'", scene("#include \"many.glsl\""));
}

/* Texts that would take their length squared. */
static void test_long_texts(void **state) {
    (void)state;
    static const char *const scenes[] = {"scene_intersect(", "#line 1 1\n",   "{",
                                         "#if 0\n",          "#define A B\n", "void f() {}\n"},
                             *const toys[] = {"float a( ",
                                              "const ",
                                              "struct a{ ",
                                              "uniform float iTime; ",
                                              "uniform sampler2D x;",
                                              "#define x y\n;a\n",
                                              "float a=1,",
                                              "float a[ ",
                                              "{("};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        const char *path = fill("home/long.glsl", SCENE, scenes[i], FAULT_SIZE);
        fault_cheap("flatten '%s'", path);
    }
    for (size_t i = 0; i < sizeof toys / sizeof *toys; i++) {
        const char *path = fill("home/long.glsl", TOY, toys[i], FAULT_SIZE);
        fault_cheap("flatten '%s'", path);
    }
    Text text = {0};
    text_print(&text, SCENE);
    for (int i = 0; text.size < FAULT_SIZE; i++) text_print(&text, "uniform float a%d;\n", i);
    fault_expect(3, "nothing sets the uniform 'a0'", "info '%s'",
                 support_write("home/long.glsl", text_string(&text)));
    text.size = 0;
    text_print(&text, TOY);
    for (int i = 0; text.size < FAULT_SIZE; i++) text_print(&text, "struct s%d { float a; };\n", i);
    fault_cheap("flatten '%s'", support_write("home/long.glsl", text_string(&text)));
    text_free(&text);
}

/* What a driver refuses is explained at once, however many words stand on the line. */
static void test_refused_line(void **state) {
    (void)state;
    const char *path = fill("home/words.glsl", SCENE, "a ", 300000);
    int status =
        support_run("ulimit -t 10;", "render '%s' --size 16x16 --spp 1 -o '%s'", path, support_path("a.exr"));
    if (status == 4) support_no_gl(support_err);
    if (status != 3 || !strstr(support_err, "words.glsl:3: ")) fail_msg("status %d: %s", status, support_err);
}

/* A link that changes its target all the time: what is read was checked. */
static void test_race(void **state) {
    (void)state;
    support_write("home/mine", "float mine() { return 1.0; }\n");
    const char *path = scene("#include \"swap.glsl\"");
    int status = fault_shell("cd $D/home; ln -s mine swap.glsl; ( while :; do ln -s ../other/secret n; mv -T "
                             "n swap.glsl; ln -s mine n; "
                             "mv -T n swap.glsl; done ) & p=$!; trap 'kill $p' EXIT; cd - >/dev/null; "
                             "read=0; refused=0; for i in $(seq "
                             "300); do if $M flatten '%s' >$D/out 2>$D/race; then read=$((read + 1)); else "
                             "refused=$((refused + 1)); fi; "
                             "if grep -q SECRET $D/out $D/race; then echo 'it was read' >&2; exit 1; fi; "
                             "done; echo $read read, $refused "
                             "refused >&2",
                             path);
    print_message("%s", support_err);
    assert_int_equal(status, 0);
}

/* A file's own #line names no file of this program's. */
static void test_own_lines(void **state) {
    (void)state;
    fault_expect(3, "own.glsl:2: nothing sets the uniform 'x'", "info '%s'",
                 support_write("home/own.glsl", "#line 1 99999\nuniform float x;\n" SCENE));
    fault_expect(3, ":1: nothing sets the uniform 'x'", "info '%s'",
                 support_write("home/own.glsl", "/**/ #line 1 99999\nuniform float x;\n" SCENE));
    fault_cheap("flatten '%s'", support_write("home/own.glsl", "/**/ #line 1 9999\nuniform float x;\n" TOY));
}

static void test_names(void **state) {
    (void)state;
    Names names = {0};
    char name[32];
    assert_int_equal(names_find(&names, "a", 1), -1);
    for (int i = 0; i < 5000; i++) {
        snprintf(name, sizeof name, "n%d and more", i % 2500);
        assert_int_equal(names_add(&names, name, strcspn(name, " ")), i % 2500);
    }
    assert_int_equal(names.count, 2500);
    assert_int_equal(names_find(&names, "n2499", 5), 2499);
    assert_int_equal(names_find(&names, "n2499", 3), 24);
    assert_int_equal(names_find(&names, "n2500", 5), -1);
    names_free(&names);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_places),     cmocka_unit_test(test_allowed),      cmocka_unit_test(test_kinds),
        cmocka_unit_test(test_sizes),      cmocka_unit_test(test_tables),       cmocka_unit_test(test_bomb),
        cmocka_unit_test(test_long_texts), cmocka_unit_test(test_refused_line), cmocka_unit_test(test_race),
        cmocka_unit_test(test_own_lines),  cmocka_unit_test(test_names),
    };
    return cmocka_run_group_tests_name("foreign", tests, make_folders, support_clean);
}
