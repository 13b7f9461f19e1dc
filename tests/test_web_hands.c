/* A page of `magichour export` as people use it: the sun, the camera, sliders and presets by mouse, finger
 * and keyboard, its link, what it saves, and what it says when it cannot draw. */
#include "web.h"

#include "base/clock.h"
#include "base/file.h"
#include "base/text.h"
#include "image/format.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The crater's page, opened anew. */
static Browser *open_crater(const char *fragment) {
    Browser *of = web_browser();
    const char *path = web_export("scenes/crater.glsl", "--size 96x96");
    assert_non_null(path);
    web_open(of, path, fragment);
    return of;
}

static double sun(Browser *of, int angle) {
    return browser_number(of, "magichour.state.sun[%d]", angle);
}

static double distance_of_eye(Browser *of) {
    return browser_number(of,
                          "Math.hypot(...magichour.state.eye.map((x, i) => x - magichour.state.target[i]))");
}

/* A place in an element, from its middle in halves of its size: (1, 0) is the middle of its right side. */
static void place(Browser *of, const char *selector, double right, double down, double *x, double *y) {
    browser_center(of, selector, x, y);
    *x += right / 2 *
          browser_number(of, "document.querySelector('%s').getBoundingClientRect().width", selector);
    *y += down / 2 *
          browser_number(of, "document.querySelector('%s').getBoundingClientRect().height", selector);
}

static void move_to(Browser *of, const char *selector, double right, double down) {
    double x, y;
    place(of, selector, right, down, &x, &y);
    browser_move(of, x, y);
}

/* At rest, so many samples later, the page has drawn what its state says. */
static void settle(Browser *of) {
    browser_await(of, "!magichour.figures.coarse && magichour.figures.samples >= 4");
    assert_string_equal(browser_errors(of), "");
}

static void check_sun(Browser *of, double elevation, double azimuth) {
    if (fabs(sun(of, 0) - elevation) > 1.5 || fabs(sun(of, 1) - azimuth) > 1.5)
        fail_msg("the sun is at %g, %g and not at %g, %g", sun(of, 0), sun(of, 1), elevation, azimuth);
    /* The fields say the same. */
    double typed = browser_number(of, "Number(document.getElementById('elevation').value)");
    assert_float_equal(typed, sun(of, 0), 0.01);
    typed = browser_number(of, "Number(document.getElementById('azimuth').value)");
    assert_float_equal(typed, sun(of, 1), 0.01);
}

/* ---- The mouse */

/* The disc's middle is the zenith, its ring the horizon (50 of its 60 units), and up is where the camera
 * looks. */
static void test_disc(void **state) {
    (void)state;
    Browser *of = open_crater("");
    move_to(of, "#disc", 0, -0.4);
    browser_press(of, "left");
    check_sun(of, 90 - 0.4 * 60 / 50 * 90, 0);
    move_to(of, "#disc", 0.6, 0);
    check_sun(of, 90 - 0.6 * 60 / 50 * 90, -90);
    move_to(of, "#disc", -0.5, 0);
    check_sun(of, 90 - 0.5 * 60 / 50 * 90, 90);
    /* Outside of the disc, because the mouse is held; below the horizon there. */
    move_to(of, "#disc", 0, -1.3);
    assert_true(sun(of, 0) < -5);
    move_to(of, "#disc", 0, -0.2);
    browser_release(of, "left");
    check_sun(of, 90 - 0.2 * 60 / 50 * 90, 0);
    /* What is not held does not move. */
    move_to(of, "#disc", 0.5, 0);
    check_sun(of, 90 - 0.2 * 60 / 50 * 90, 0);
    settle(of);
}

/* Drawn with the new sun: the picture after dragging is that of a page that begins so. */
static void test_drag(void **state) {
    (void)state;
    Browser *of = open_crater("");
    double elevation = sun(of, 0), azimuth = sun(of, 1);
    move_to(of, "#picture", 0, 0.2);
    browser_press(of, "right");
    for (int i = 0; i < 5; i++) move_to(of, "#picture", 0.02 * i, 0.2 - 0.05 * i);
    browser_release(of, "right");
    assert_true(sun(of, 0) > elevation + 2);
    assert_true(sun(of, 1) < azimuth - 1);
    settle(of);
    Image got = web_picture(of, 8), wanted = web_native(of, "");
    web_compare("dragged", &got, &wanted, (WebBounds){0.001, 0.001});
    image_free(&got), image_free(&wanted);
}

static void test_camera(void **state) {
    (void)state;
    Browser *of = open_crater("");
    double far = distance_of_eye(of), x = browser_number(of, "magichour.state.eye[0]");
    move_to(of, "#picture", 0, 0);
    browser_press(of, "left");
    move_to(of, "#picture", 0.3, 0.1);
    browser_release(of, "left");
    assert_true(fabs(browser_number(of, "magichour.state.eye[0]") - x) > 0.5);
    assert_float_equal(distance_of_eye(of), far, 1e-4);
    assert_float_equal(sun(of, 0), 30, 0);
    browser_wheel(of, 0, -200);
    browser_await(of, "Math.hypot(...magichour.state.eye.map((x, i) => x - magichour.state.target[i])) < %g",
                  0.95 * far);
    settle(of);
    Image got = web_picture(of, 8), wanted = web_native(of, "");
    web_compare("camera", &got, &wanted, (WebBounds){0.001, 0.001});
    image_free(&got), image_free(&wanted);
    browser_click(of, "#camera");
    assert_float_equal(distance_of_eye(of), far, 1e-9);
    assert_float_equal(browser_number(of, "magichour.state.eye[0]"), x, 1e-9);
}

static void test_panel(void **state) {
    (void)state;
    Browser *of = open_crater("");
    double x, y;
    place(of, "#set-hover", 0.5, 0, &x, &y);
    browser_move(of, x, y);
    browser_press(of, "left");
    browser_release(of, "left");
    double hover = browser_number(of, "magichour.state.values.hover[0]");
    assert_float_equal(hover, -0.5 + 0.75 * 3.5, 0.15);
    assert_float_equal(
        browser_number(of, "Number(document.querySelector('input[type=number][name=hover]').value)"), hover,
        0.01);
    browser_click(of, "#set-ball");
    assert_float_equal(browser_number(of, "magichour.state.values.ball[0]"), 0, 0);
    settle(of);
    Image got = web_picture(of, 8), wanted = web_native(of, "");
    web_compare("panel", &got, &wanted, (WebBounds){0.001, 0.001});
    image_free(&got), image_free(&wanted);
    browser_click(of, "#set-ball label, label[for=set-ball]");
    assert_float_equal(browser_number(of, "magichour.state.values.ball[0]"), 1, 0);
    browser_click(of, "#pause");
    assert_string_equal(browser_string(of, "document.getElementById('pause').getAttribute('aria-pressed')"),
                        "true");
    double samples =
        browser_number(of, "new Promise(r => setTimeout(() => r(magichour.figures.samples), 100))");
    assert_float_equal(
        browser_number(of, "new Promise(r => setTimeout(() => r(magichour.figures.samples), 200))"), samples,
        0);
    /* web_picture() has limited the samples, and all of them may have been drawn before the pause. */
    browser_do(of, "magichour.rest()");
    browser_click(of, "#pause");
    browser_await(of, "magichour.figures.samples > %g", samples);
}

/* The dialog that chooses a colour is the browser's, so that its answer is given here. */
static void test_color(void **state) {
    (void)state;
    Browser *of = web_browser();
    const char *scene =
        support_write("tint.glsl", "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
                                   "uniform vec3 tint; //@ color 0.5 0.5 0.5\n"
                                   "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                                   "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n}\n"
                                   "Material scene_material(Hit hit) { return matte(tint); }\n");
    web_open(of, web_export(scene, "--size 64x64"), "");
    browser_do(of, "(box => { box.value = '#804020'; box.dispatchEvent(new Event('input')); })"
                   "(document.getElementById('set-tint'))");
    assert_float_equal(browser_number(of, "magichour.state.values.tint[0]"), 0.2159, 1e-3);
    assert_float_equal(browser_number(of, "magichour.state.values.tint[2]"), 0.0144, 1e-3);
    Image got = web_picture(of, 8), wanted = web_native(of, "");
    web_compare("colour", &got, &wanted, (WebBounds){0.001, 0.001});
    image_free(&got), image_free(&wanted);
}

/* ---- Fingers */

static void test_touch(void **state) {
    (void)state;
    Browser *of = web_browser();
    double x, y, x2, y2;
    web_view(of, true);
    open_crater("");
    place(of, "#disc", 0, -0.4, &x, &y);
    browser_touch(of, 1, (double[]){x, y});
    check_sun(of, 90 - 0.4 * 60 / 50 * 90, 0);
    place(of, "#disc", -0.5, 0, &x, &y);
    double scrolled = browser_number(of, "scrollY");
    browser_touch(of, 1, (double[]){x, y});
    browser_untouch(of);
    check_sun(of, 90 - 0.5 * 60 / 50 * 90, 90);
    assert_float_equal(browser_number(of, "scrollY"), scrolled, 0);
    /* One finger turns, two go nearer. */
    double far = distance_of_eye(of), eye = browser_number(of, "magichour.state.eye[0]");
    place(of, "#picture", 0, 0, &x, &y);
    browser_touch(of, 1, (double[]){x, y});
    browser_touch(of, 1, (double[]){x + 60, y});
    browser_untouch(of);
    browser_await(of, "Math.abs(magichour.state.eye[0] - %.17g) > 0.3", eye);
    assert_float_equal(distance_of_eye(of), far, 1e-4);
    place(of, "#picture", -0.1, 0, &x, &y);
    place(of, "#picture", 0.1, 0, &x2, &y2);
    browser_touch(of, 2, (double[]){x, y, x2, y2});
    browser_touch(of, 2, (double[]){x - 40, y, x2 + 40, y2});
    browser_untouch(of);
    browser_await(of, "Math.hypot(...magichour.state.eye.map((x, i) => x - magichour.state.target[i])) < %g",
                  0.8 * far);
    settle(of);
    web_view(of, false);
}

/* ---- The keyboard */

static void focus(Browser *of, const char *selector) {
    browser_do(of, "document.querySelector('%s').focus()", selector);
    if (!browser_true(of, "document.activeElement == document.querySelector('%s')", selector))
        fail_msg("%s takes no keys", selector);
}

static void test_keys(void **state) {
    (void)state;
    Browser *of = open_crater("");
    focus(of, "#picture");
    browser_key(of, "ArrowUp");
    browser_key(of, "ArrowUp");
    browser_key(of, "ArrowLeft");
    check_sun(of, 32, 1);
    browser_key(of, "a");
    assert_true(fabs(browser_number(of, "magichour.state.eye[0]")) > 0.1);
    browser_key(of, "r");
    assert_float_equal(browser_number(of, "magichour.state.eye[0]"), 0, 1e-9);
    browser_key(of, "=");
    assert_float_equal(browser_number(of, "magichour.state.exposure"), 0.25, 1e-9);
    focus(of, "#set-hover");
    browser_key(of, "ArrowRight");
    assert_float_equal(browser_number(of, "magichour.state.values.hover[0]"), 0.535, 1e-6);
    focus(of, "#set-ball");
    browser_key(of, " ");
    assert_float_equal(browser_number(of, "magichour.state.values.ball[0]"), 0, 0);
    /* A number is typed and taken by Enter. */
    focus(of, "#elevation");
    browser_do(of, "document.activeElement.select()");
    browser_key(of, "1");
    browser_key(of, "2");
    browser_key(of, "Enter");
    check_sun(of, 12, 1);
    /* What is out of its range is refused with words, and nothing moves. */
    browser_do(of, "document.activeElement.select()");
    for (const char *digit = "200"; *digit; digit++) browser_key(of, (char[]){*digit, 0});
    browser_key(of, "Enter");
    assert_float_equal(sun(of, 0), 12, 1e-9);
    assert_true(browser_true(of, "!document.getElementById('trouble').hidden && "
                                 "document.getElementById('trouble').innerText.includes('200')"));
    focus(of, "#preset");
    browser_key(of, "ArrowDown");
    browser_await(of, "magichour.state.preset == 'noon'");
    assert_float_equal(sun(of, 0), 60, 1e-9);
    assert_true(browser_true(of, "document.getElementById('trouble').hidden"));
    settle(of);
    /* The tabulator reaches all that takes input, and each has a name. */
    browser_do(of, "document.activeElement.blur()");
    browser_do(of, "window.reached = new Set()");
    for (int i = 0; i < 40; i++) {
        browser_key(of, "Tab");
        browser_do(of, "reached.add(document.activeElement)");
    }
    const char *missed = browser_string(
        of, "[...document.querySelectorAll('input, select, button, textarea, canvas, summary')]"
            ".filter(e => e.offsetParent && !reached.has(e)).map(e => e.id || e.name).join(' ')");
    assert_string_equal(missed, "");
    missed = browser_string(of, "[...document.querySelectorAll('input, select, button, textarea, "
                                "canvas')].filter(e => !(e.ariaLabel || "
                                "e.textContent && e.localName == 'button' || e.labels && e.labels.length && "
                                "e.labels[0].textContent.trim())).map(e => e.id || e.name).join(' ')");
    assert_string_equal(missed, "");
}

/* ---- The link and what is saved */

static void test_link(void **state) {
    (void)state;
    Browser *of = open_crater("#sun=5,90&hover=1");
    check_sun(of, 5, 90);
    assert_float_equal(browser_number(of, "magichour.state.values.hover[0]"), 1, 0);
    move_to(of, "#picture", 0, 0);
    browser_press(of, "left");
    move_to(of, "#picture", 0.1, 0.1);
    browser_release(of, "left");
    browser_click(of, "#link");
    browser_await(of, "location.hash.includes('hover=1')");
    char hash[1024];
    snprintf(hash, sizeof hash, "%s", browser_string(of, "location.hash"));
    Image first = web_picture(of, 8);
    open_crater(hash);
    Image again = web_picture(of, 8);
    web_compare("by the link", &again, &first, (WebBounds){0.001, 0.001});
    image_free(&first), image_free(&again);
    /* A link that says nothing the page knows says so. */
    of = open_crater("#sun=5,90&hovr=1&sun=200,0");
    check_sun(of, 5, 90);
    assert_true(browser_true(of, "document.getElementById('trouble').innerText.includes('hovr') && "
                                 "document.getElementById('trouble').innerText.includes('200')"));
    assert_string_equal(browser_errors(of), "");
}

/* How many percent of the bytes of two pictures, as they are shown, are equal. */
static double equal_percent(const char *path, const char *wanted_path) {
    Image got = {0}, wanted = {0};
    Error error;
    if (!image_read(&got, path, &error) || !image_read(&wanted, wanted_path, &error))
        fail_msg("%s", error.text);
    assert_int_equal(got.width, wanted.width);
    assert_int_equal(got.height, wanted.height);
    int equal = 0, bytes = 3 * got.width * got.height;
    for (int i = 0; i < 4 * got.width * got.height; i++) equal += i % 4 < 3 && got.rgba[i] == wanted.rgba[i];
    image_free(&got), image_free(&wanted);
    return 100.0 * equal / bytes;
}

static void test_save(void **state) {
    (void)state;
    Browser *of = open_crater("#sun=20,40&exposure=0.5");
    Image pixels = web_picture(of, 64), wanted = web_native(of, ""), saved = {0};
    char native[512];
    Error error;
    snprintf(native, sizeof native, "%s", support_path("native.png"));
    assert_int_equal(support_run("", "%s --quiet -o '%s'",
                                 browser_string(of, "magichour.command_text().slice(10, -15)"), native),
                     0);
    browser_downloads(of, support_path("."));
    browser_click(of, "#png");
    const char *path = browser_downloaded(of);
    assert_non_null(strstr(path, ".png"));
    double equal = equal_percent(path, native);
    print_message("%.3f %% of the saved PNG's bytes are equal\n", equal);
    assert_true(equal >= 99.9);
    browser_click(of, "#pfm");
    path = browser_downloaded(of);
    assert_non_null(strstr(path, ".pfm"));
    if (!image_read(&saved, path, &error)) fail_msg("%s", error.text);
    web_compare("saved PFM", &saved, &pixels, (WebBounds){0});
    web_compare("saved PFM", &saved, &wanted, (WebBounds){0.001, 0.001});
    image_free(&saved), image_free(&pixels), image_free(&wanted);
}

/* ---- What goes wrong */

/* The page says a whole sentence with these words, and nothing has been thrown past it. */
static void check_trouble(Browser *of, const char *words) {
    browser_await(of, "!document.getElementById('trouble').hidden");
    const char *said = browser_string(of, "document.getElementById('trouble').innerText");
    if (!strstr(said, words) || strlen(said) < 30) fail_msg("no '%s' in '%s'", words, said);
    print_message("%s\n", said);
}

static void test_no_webgl(void **state) {
    (void)state;
    Browser *of = web_browser();
    browser_before(of, "HTMLCanvasElement.prototype.getContext = () => null");
    open_crater("");
    check_trouble(of, "WebGL 2");
    assert_string_equal(browser_errors(of), "");
    web_look(of, "no-webgl");
    browser_before(of, "const original = WebGL2RenderingContext.prototype.getExtension;"
                       "WebGL2RenderingContext.prototype.getExtension = function (name) {"
                       " return name == 'EXT_color_buffer_float' ? null : original.call(this, name); };");
    open_crater("");
    check_trouble(of, "EXT_color_buffer_float");
    assert_string_equal(browser_errors(of), "");
    browser_before(of, NULL);
    /* A browser that has WebGL switched off. */
    Browser *own = browser_start(BROWSER_NO_WEBGL);
    web_open(own, support_path("crater.html"), "");
    check_trouble(own, "WebGL 2");
    browser_stop(own);
}

static void test_broken_shader(void **state) {
    (void)state;
    Browser *of = web_browser();
    Text page = {0};
    Error error;
    const char *path = web_export("scenes/crater.glsl", "--size 96x96");
    if (!file_read(path, STATUS_FAILURE, &page, &error)) fail_msg("%s", error.text);
    char *at = strstr(page.data, "void main()");
    assert_non_null(at);
    memcpy(at, "vodi", 4);
    web_open(of, support_write("broken.html", text_string(&page)), "");
    text_free(&page);
    check_trouble(of, "vodi");
    assert_string_equal(browser_errors(of), "");
}

static void test_lost(void **state) {
    (void)state;
    Browser *of = open_crater("");
    Image first = web_picture(of, 8);
    browser_do(of, "(window.loser = document.getElementById('picture').getContext('webgl2')"
                   ".getExtension('WEBGL_lose_context')).loseContext()");
    check_trouble(of, "graphics driver");
    browser_do(of, "new Promise(r => setTimeout(r, 50))");
    browser_do(of, "loser.restoreContext()");
    browser_await(of, "document.getElementById('trouble').hidden");
    Image again = web_picture(of, 8);
    web_compare("restored", &again, &first, (WebBounds){0.001, 0.001});
    image_free(&first), image_free(&again);
}

/* ---- Figures and looks */

/* Printed and not asserted: they depend on what else the machine does. A browser of its own has compiled
 * nothing before. */
static void test_figures(void **state) {
    (void)state;
    Browser *of = browser_start(BROWSER_LLVMPIPE);
    double x, y;
    const char *path = web_export("scenes/crater.glsl", "");
    web_view(of, false);
    browser_open(of, "tests/data/web/hands.html", "");
    double start_s = clock_seconds();
    web_open(of, path, "");
    double first_s = clock_seconds() - start_s;
    browser_await(of, "magichour.figures.samples && !magichour.figures.coarse");
    double fine_s = clock_seconds() - start_s;
    place(of, "#disc", 0, -0.4, &x, &y);
    browser_move(of, x, y);
    browser_press(of, "left");
    double frames = browser_number(of, "magichour.figures.frames");
    start_s = clock_seconds();
    for (int i = 0; clock_seconds() < start_s + 3; i++) browser_move(of, x + 20 * sin(0.1 * i), y);
    double seconds = clock_seconds() - start_s;
    frames = browser_number(of, "magichour.figures.frames") - frames;
    browser_release(of, "left");
    print_message("512x512: %.2f s to the first picture, %.2f s to the first in full, %.1f pictures a second "
                  "while the sun is dragged\n",
                  first_s, fine_s, frames / seconds);
    browser_stop(of);
    assert_true(frames >= 2);
}

static void test_looks(void **state) {
    (void)state;
    Browser *of = web_browser();
    const char *path = web_export("scenes/crater.glsl", "");
    for (int i = 0; i < 4; i++) {
        bool dark = i & 2;
        double x, y;
        web_view(of, i & 1);
        browser_scheme(of, dark ? "dark" : "light");
        web_open(of, path, "");
        browser_await(of, "magichour.figures.samples >= 2 && !magichour.figures.coarse");
        web_look(of, dark ? "crater-dark" : "crater");
        if (dark) continue;
        place(of, "#disc", 0.3, -0.4, &x, &y);
        browser_move(of, x, y);
        browser_press(of, "left");
        for (int k = 0; k < 10; k++) browser_move(of, x + k, y + k);
        web_look(of, "crater-dragging");
        browser_release(of, "left");
    }
    browser_scheme(of, "light");
    web_view(of, false);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_disc),     cmocka_unit_test(test_drag),          cmocka_unit_test(test_camera),
        cmocka_unit_test(test_panel),    cmocka_unit_test(test_color),         cmocka_unit_test(test_touch),
        cmocka_unit_test(test_keys),     cmocka_unit_test(test_link),          cmocka_unit_test(test_save),
        cmocka_unit_test(test_no_webgl), cmocka_unit_test(test_broken_shader), cmocka_unit_test(test_lost),
        cmocka_unit_test(test_figures),  cmocka_unit_test(test_looks),
    };
    return cmocka_run_group_tests_name("web_hands", tests, web_setup, web_teardown);
}
