/* The pictures of pages that `magichour export` writes, in a browser, against those of `render`; and the
 * index of tools/site.sh. */
#include "scene_list.h"
#include "web.h"

#include "base/clock.h"
#include "base/file.h"
#include "base/text.h"
#include "choice/method.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The same compiler gives the same picture but for the last bits of what is computed beside the shaders. */
static const WebBounds same = {.rel_rmse_percent = 0.001, .mean_percent = 0.001};

/* A page divides a set of spheres into other boxes than the host does, so that now and then a ray that grazes
 * a sphere is rounded to its other side. */
static const WebBounds same_but_tree = {.rel_rmse_percent = 0.01, .mean_percent = 0.001};

enum { SIZE = 96, SAMPLES = 8 };

static void compare_page(Browser *of, const char *name, int samples, WebBounds bounds) {
    Image got = web_picture(of, samples), wanted = web_native(of, "");
    web_compare(name, &got, &wanted, bounds);
    image_free(&got), image_free(&wanted);
}

/* Each scene that is exported, with the same seed. What is refused has a reason. */
static void test_scenes(void **state) {
    (void)state;
    Browser *of = web_browser();
    SceneList scenes = scene_list();
    char options[64];
    int carried = 0;
    snprintf(options, sizeof options, "--size %dx%d", SIZE, SIZE);
    for (int i = 0; i < scenes.count; i++) {
        const char *path = web_export(scenes.paths[i], options);
        if (!path) {
            print_message("refused: %s", support_err);
            continue;
        }
        web_open(of, path, "");
        bool other_tree = browser_true(of, "'sphere_tree' in MAKERS");
        compare_page(of, strrchr(scenes.paths[i], '/') + 1, SAMPLES, other_tree ? same_but_tree : same);
        assert_string_equal(browser_errors(of), "");
        assert_string_equal(browser_requests(of), "");
        carried++;
    }
    print_message("%d of %d scenes are carried\n", carried, scenes.count);
    assert_true(carried >= 18);
}

/* The data of a page, as its script reads them. */
static Text data_of(const char *path) {
    static const char begin[] = "id=\"data\">";
    Text page = {0}, data = {0};
    Error error;
    if (!file_read(path, STATUS_FAILURE, &page, &error)) fail_msg("%s", error.text);
    const char *from = strstr(text_string(&page), begin);
    if (!from) fail_msg("%s has no data", path);
    from += strlen(begin);
    text_append(&data, from, (size_t)(strstr(from, "</script>") - from));
    text_free(&page);
    return data;
}

static bool compiles(Browser *of, const char *scene, const char *options) {
    const char *path = web_export(scene, options);
    if (!path) return false;
    Text data = data_of(path);
    browser_give(of, "given", text_string(&data));
    text_free(&data);
    const char *refused = browser_string(of, "compile(given)");
    if (*refused) fail_msg("%s %s: %s", scene, options, refused);
    return true;
}

/* WebGL refuses some of what GLSL ES allows: every light, with the sun's disk and without it, in a scene of
 * each kind, and every sequence. The shaders of the methods that scenes choose by themselves are compiled by
 * test_scenes, and `make lint` compiles all by another compiler. */
static void test_compile(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/crater.glsl", "scenes/box-room.glsl", "scenes/shafts.glsl"};
    Browser *of = web_browser();
    int carried = 0, refused = 0;
    const Method *method;
    browser_open(of, "tests/data/web/compile.html", "");
    for (int i = 0; i < 3; i++) {
        for (int k = 0; (method = method_get(k)); k++) {
            bool light = method->family == METHOD_LIGHT,
                 sequence = method->family == METHOD_SEQUENCE && i == 0;
            for (int sun = 0; sun < 2 && (light || sequence); sun++) {
                char options[128];
                snprintf(options, sizeof options, "%s %s --sky table --sun-disk=%s",
                         method_family(method->family)->option, method->name, sun ? "sampled" : "off");
                if (compiles(of, scenes[i], options))
                    carried++;
                else
                    refused++;
            }
        }
    }
    print_message("%d choices compile, as %g shaders; %d are refused\n", carried,
                  browser_number(of, "seen.size"), refused);
    assert_true(carried > refused);
    /* What is no shader is refused. */
    assert_string_not_equal(
        browser_string(of, "compile('{\"piece\": \"#version 300 es\"}\\n{\"shader\": \"0\"}')"), "");
}

/* The page's state from its address: what it says of the command is what it draws. */
static void test_states(void **state) {
    (void)state;
    static const struct {
        const char *scene, *fragment, *word;
    } cases[] = {
        {"crater", "#sun=5,90&hover=1", "hover=1"},   {"crater", "#preset=twilight", "twilight"},
        {"crater", "#sun=-3,10&exposure=2", "--sun"}, {"valley", "#preset=sunset", "sunset"},
        {"shapes", "#sun=60,20", "--sun 60,20"},      {"box-room", "#preset=smoke", "smoke"},
    };
    Browser *of = web_browser();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char scene[64], name[128];
        snprintf(scene, sizeof scene, "scenes/%s.glsl", cases[i].scene);
        snprintf(name, sizeof name, "%s%s", cases[i].scene, cases[i].fragment);
        const char *path = web_export(scene, "--size 64x48");
        if (!path) continue;
        web_open(of, path, cases[i].fragment);
        const char *command = browser_string(of, "magichour.command_text()");
        if (!strstr(command, cases[i].word)) fail_msg("%s: no %s in %s", name, cases[i].word, command);
        compare_page(of, name, SAMPLES, same);
        assert_string_equal(browser_errors(of), "");
    }
}

/* A picture does not depend on the way to it: not on the picture before, nor on how many draws make it, but
 * for the last bits: how many samples a draw adds is a matter of time. */
static void test_again(void **state) {
    (void)state;
    Browser *of = web_browser();
    web_open(of, web_export("scenes/crater.glsl", "--size 64x48"), "");
    Image first = web_picture(of, 12), again = web_picture(of, 4);
    image_free(&again);
    browser_do(of, "magichour.assign('sun', '5,90')");
    again = web_picture(of, 3);
    image_free(&again);
    browser_do(of, "magichour.assign('sun', '30,0')");
    again = web_picture(of, 12);
    web_compare("again", &again, &first, same);
    image_free(&first), image_free(&again);
}

/* Without linear filtering of 32-bit floats the tables have 16 bits, which the picture hardly shows. */
static void test_half_float(void **state) {
    (void)state;
    Browser *of = web_browser();
    browser_before(of, "const original = WebGL2RenderingContext.prototype.getExtension;"
                       "WebGL2RenderingContext.prototype.getExtension = function (name) {"
                       " return name == 'OES_texture_float_linear' ? null : original.call(this, name); };");
    static const char *const suns[] = {"#sun=60,0", "#sun=30,0", "#sun=5,0", "#sun=-2,0"};
    for (int i = 0; i < 4; i++) {
        web_open(of, web_export("scenes/crater.glsl", "--size 64x48"), suns[i]);
        compare_page(of, suns[i], SAMPLES, (WebBounds){0.2, 0.05});
    }
    browser_before(of, NULL);
}

/* Another compiler rounds otherwise, so that a few paths part at edges. */
static void test_swiftshader(void **state) {
    (void)state;
    static const char *const names[] = {"crater", "box-room"};
    Browser *of = browser_start(BROWSER_SWIFTSHADER);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char scene[64];
        snprintf(scene, sizeof scene, "scenes/%s.glsl", names[i]);
        double start_s = clock_seconds();
        web_open(of, web_export(scene, "--size 96x96"), "");
        Image got = web_picture(of, SAMPLES), wanted = web_native(of, "");
        web_compare(names[i], &got, &wanted, (WebBounds){web_noise(of) / 3, 0.05});
        image_free(&got), image_free(&wanted);
        print_message("%-14s %.1f s until its picture\n", names[i], clock_seconds() - start_s);
    }
    browser_stop(of);
}

/* The index needs no scripts, and shows all on a desk and on a phone, in the dark and in the light. */
static void test_index(void **state) {
    (void)state;
    Browser *of = web_browser();
    char command[1024];
    snprintf(command, sizeof command,
             "SPP=2 tools/site.sh \"${MAGICHOUR:-build/magichour}\" '%s' ${SITE_SCENES:-scenes/crater.glsl "
             "scenes/spheres.glsl} >'%s' 2>&1",
             support_path("site"), support_path("said"));
    assert_int_equal(system(command), 0);
    browser_scripts(of, false);
    for (int i = 0; i < 4; i++) {
        bool dark = i & 2;
        web_view(of, i & 1);
        browser_scheme(of, dark ? "dark" : "light");
        browser_open(of, support_path("site/index.html"), "");
        web_look(of, dark ? "index-dark" : "index");
        assert_true(browser_true(of, "[...document.images].every(i => i.alt)"));
        assert_true(
            browser_true(of, "[...document.links].every(l => l.innerText || l.querySelector('img'))"));
    }
    /* The pictures further down come when they are scrolled to. */
    browser_do(of, "document.querySelectorAll('img').forEach(i => i.loading = 'eager')");
    browser_await(of, "[...document.images].every(i => i.complete && i.naturalWidth > 0)");
    assert_string_equal(browser_errors(of), "");
    assert_string_equal(browser_requests(of), "");
    browser_scripts(of, true);
    browser_scheme(of, "light");
    web_view(of, false);
    /* Its page is what it leads to. */
    browser_open(of, support_path("site/index.html"), "");
    browser_click(of, "#crater a");
    browser_await(of, "window.magichour");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scenes), cmocka_unit_test(test_compile),    cmocka_unit_test(test_states),
        cmocka_unit_test(test_again),  cmocka_unit_test(test_half_float), cmocka_unit_test(test_swiftshader),
        cmocka_unit_test(test_index),
    };
    return cmocka_run_group_tests_name("web", tests, web_setup, web_teardown);
}
