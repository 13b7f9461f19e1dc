/* tools/site.sh: the scenes as static pages. The program stands behind one whose `export` answers as is
 * wanted.
 */
#include "support.h"

#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* Writes the program: `export` is done by these words of a shell, in which $4 is the file to be written. */
static void write_program(const char *export) {
    char real[4096];
    const char *program = getenv("MAGICHOUR");
    Text text = {0};
    if (!realpath(program ? program : "build/magichour", real)) fail_msg("no program");
    text_print(&text,
               "#!/bin/sh\nif [ \"$1 $2\" = 'export --help' ]; then echo ' --shadertoy'; exit; fi\n"
               "if [ \"$1\" = export ]; then\n%s\nfi\nexec '%s' \"$@\"\n",
               export, real);
    support_write("program", text_string(&text));
    text_free(&text);
}

static const char *read_file(const char *name) {
    static Text text;
    Error error;
    text_free(&text);
    if (!file_read(support_path(name), STATUS_FAILURE, &text, &error)) fail_msg("%s", error.text);
    return text_string(&text);
}

/* Makes the site of these scenes in site/, and gives the exit status. */
static int make_site(const char *scenes) {
    Text command = {0};
    const char *folder = support_path(".");
    text_print(
        &command,
        "chmod +x '%s/program' && cd '%s' && SPP=2 SIZE=32x24 \"$OLDPWD/tools/site.sh\" ./program site %s "
        ">said 2>&1 </dev/null",
        folder, folder, scenes);
    int status = system(text_string(&command));
    text_free(&command);
    print_message("%s", read_file("said"));
    return WEXITSTATUS(status);
}

static void expect(const char *index, const char *words) {
    if (!strstr(index, words)) fail_msg("no '%s' in: %s", words, index);
}

/* The path of what the attribute at `at` names. */
static const char *target(const char *at) {
    static char name[512];
    char file[256];
    assert_int_equal(sscanf(at, "=\"%255[^\"]\"", file), 1);
    snprintf(name, sizeof name, "%s/site/%s", support_path("."), file);
    return name;
}

/* Every link has its file, every picture its words and its size; nothing comes from elsewhere. Gives how many
 * links there are. */
static int check_links(const char *index) {
    int count = 0;
    for (const char *at = index; (at = strstr(at, " href")); count++) {
        at += 5;
        if (access(target(at), R_OK) != 0) fail_msg("%s is not there", target(at));
    }
    for (const char *at = index; (at = strstr(at, "<img src"));) {
        char alt[512];
        int width = 0, height = 0;
        Error error;
        Image image = {0};
        at += 8;
        if (!image_read(&image, target(at), &error)) fail_msg("%s", error.text);
        int read =
            sscanf(at, "=\"%*[^\"]\" alt=\"%511[^\"]\" width=\"%d\" height=\"%d\"", alt, &width, &height);
        assert_int_equal(read, 3);
        assert_int_equal(width, image.width);
        assert_int_equal(height, image.height);
        image_free(&image);
    }
    assert_null(strstr(index, "<script"));
    assert_null(strstr(index, "http"));
    return count;
}

static const char page[] = "case $* in\n"
                           "*own.glsl*) echo \"magichour: $2:7: <it> is not carried\" >&2; exit 3 ;;\n"
                           "*--shadertoy*) mkdir -p \"$5\" && echo '// text' >\"$5/common.glsl\" ;;\n"
                           "*) echo '<title>page</title>' >\"$4\" ;;\n"
                           "esac\nexit 0\n";

static const char own[] = "//@ title  A ball & <a plane>\n"
                          "//@ look   \"the \\\"edge\\\"\"\n"
                          "#include \"material/matte.glsl\"\n#include \"shape/sphere.glsl\"\n"
                          "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                          "    hit_sphere(ray, vec3(0.0, 0.0, 5.0), 1.0, 0, hit);\n}\n"
                          "Material scene_material(Hit hit) { return matte(vec3(0.5)); }\n";

static void test_site(void **state) {
    (void)state;
    write_program(page);
    support_write("own.glsl", own);
    char scenes[4200], here[4096];
    if (!getcwd(here, sizeof here)) fail_msg("no folder");
    snprintf(scenes, sizeof scenes, "'%s/scenes/crater.glsl' own.glsl", here);
    assert_int_equal(make_site(scenes), 0);
    const char *index = read_file("site/index.html");
    /* Crater: its picture's link, its page, its text for Shadertoy and its text. Own: the picture and the
     * text. */
    assert_int_equal(check_links(index), 6);
    expect(index, "<h2>Crater</h2>");
    expect(index, "<a href=\"crater.html\"><img src=\"crater.png\" alt=\"Crater: the bowl's shade");
    expect(index, "crater-shadertoy/common.glsl");
    expect(index, "<h2>A ball &amp; &lt;a plane&gt;</h2>");
    expect(index, "<a href=\"own.png\"><img");
    expect(index, "There is no page of it: own.glsl:7: &lt;it&gt; is not carried</p>");
    expect(index, "There is no text of it for Shadertoy: own.glsl:7: &lt;it&gt; is not carried</p>");
    expect(index, "width=\"32\" height=\"24\"");
    /* Once more: the same bytes, and a page that was there before and is refused now is gone. */
    support_write("site/own.html", "an old one");
    char command[1024];
    snprintf(command, sizeof command, "cp -r '%s/site' '%s/first'", support_path("."), support_path("."));
    assert_int_equal(system(command), 0);
    assert_int_equal(unlink(support_path("first/own.html")), 0);
    assert_int_equal(make_site(scenes), 0);
    snprintf(command, sizeof command, "diff -r '%s/site' '%s/first'", support_path("."), support_path("."));
    assert_int_equal(system(command), 0);
}

/* A program that fails ends it, and the index stays as it was. */
static void test_failure(void **state) {
    (void)state;
    write_program("echo 'magichour: the disk is full' >&2; exit 5");
    support_write("own.glsl", own);
    char folder[512];
    snprintf(folder, sizeof folder, "%s", support_path("site"));
    mkdir(folder, 0700);
    support_write("site/index.html", "the index of before");
    assert_int_equal(make_site("own.glsl"), 5);
    assert_string_equal(read_file("site/index.html"), "the index of before");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_site), cmocka_unit_test(test_failure)};
    return cmocka_run_group_tests_name("site", tests, support_folder, support_clean);
}
