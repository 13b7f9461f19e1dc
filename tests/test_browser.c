/* The hands, eyes and ears of the tests in a browser, on small pages of their own: what other tests believe.
 */
#include "browser.h"

#include "base/file.h"
#include "image/format.h"

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Browser *browser;

static int set_up(void **state) {
    return support_folder(state);
}

static int tear_down(void **state) {
    browser_stop(browser);
    return support_clean(state);
}

/* One browser for all tests, started by the first, because a fixture cannot be skipped. */
static Browser *shared(void) {
    if (!browser) browser = browser_start(BROWSER_LLVMPIPE);
    return browser;
}

/* A float framebuffer holds what the shader says, and the browser draws with what was asked for. */
static void draws(Browser *of, const char *renderer) {
    size_t size;
    browser_open(of, "tests/data/web/webgl.html", "");
    assert_string_equal(browser_string(of, "document.getElementById('said').textContent"), "WebGL 2");
    const char *name = browser_string(of, "renderer()");
    if (!strstr(name, renderer)) browser_missing(name);
    const float *pixels =
        browser_bytes(of, &size, "draw('result = vec4(1e6 * gl_FragCoord.x, -gl_FragCoord.y, 1e-6, 0.0);')");
    assert_int_equal(size, 4 * 4 * 4 * sizeof(float));
    for (int y = 0; y < 4; y++) {
        for (int x = 0; x < 4; x++) {
            const float *rgba = pixels + 4 * (4 * y + x);
            assert_float_equal(rgba[0], 1e6f * ((float)x + 0.5f), 0);
            assert_float_equal(rgba[1], -((float)y + 0.5f), 0);
            assert_float_equal(rgba[2], 1e-6f, 1e-12f);
            assert_float_equal(rgba[3], 0, 0);
        }
    }
    assert_string_equal(browser_errors(of), "");
}

static void test_llvmpipe(void **state) {
    (void)state;
    draws(shared(), "llvmpipe");
}

static void other(BrowserDrawing drawing, void (*test)(Browser *of)) {
    Browser *own = browser_start(drawing);
    test(own);
    browser_stop(own);
}

static void draws_by_swiftshader(Browser *of) {
    draws(of, "SwiftShader");
}

static void test_swiftshader(void **state) {
    (void)state;
    other(BROWSER_SWIFTSHADER, draws_by_swiftshader);
}

static void draws_nothing(Browser *of) {
    browser_open(of, "tests/data/web/webgl.html", "");
    assert_string_equal(browser_string(of, "document.getElementById('said').textContent"), "no WebGL 2");
}

static void test_no_webgl(void **state) {
    (void)state;
    other(BROWSER_NO_WEBGL, draws_nothing);
}

static void test_values(void **state) {
    (void)state;
    Browser *of = shared();
    size_t size;
    browser_open(of, "tests/data/web/hands.html", "#a=1&b=2");
    assert_float_equal(browser_number(of, "new Promise(r => setTimeout(() => r(1 / 8), 50))"), 0.125, 0);
    assert_string_equal(browser_string(of, "location.hash"), "#a=1&b=2");
    assert_string_equal(browser_string(of, "'\\u00e9\\n\"'"), "\xc3\xa9\n\"");
    assert_true(browser_true(of, "1 < 2"));
    assert_false(browser_true(of, "null"));
    browser_do(of, "setTimeout(() => window.late = true, 100)");
    browser_await(of, "window.late");
    /* All bytes, in all positions of a group of three, and more than one part. */
    for (int length = 0; length < 5; length++) {
        const unsigned char *bytes =
            browser_bytes(of, &size, "new Uint8Array([0, 255, 128, 10]).subarray(0, %d)", length);
        assert_int_equal(size, length < 4 ? length : 4);
        assert_memory_equal(bytes, "\x00\xff\x80\x0a", size);
    }
    const float *floats = browser_bytes(of, &size, "Float32Array.from({length: 100000}, (_, i) => i)");
    assert_int_equal(size, 400000);
    for (int i = 0; i < 100000; i++) assert_true(floats[i] == (float)i);
}

static void test_errors(void **state) {
    (void)state;
    Browser *of = shared();
    browser_open(of, "tests/data/web/hands.html", "");
    assert_string_equal(browser_errors(of), "");
    browser_do(of, "console.log('not this')");
    assert_string_equal(browser_errors(of), "");
    browser_do(of, "console.error('said', 1)");
    assert_non_null(strstr(browser_errors(of), "console.error: said 1"));
    browser_do(of, "setTimeout(() => { throw new Error('thrown'); })");
    browser_await(of, "new Promise(r => setTimeout(() => r(true), 20))");
    assert_non_null(strstr(browser_errors(of), "thrown"));
    browser_do(of, "Promise.reject(new Error('rejected')), 0");
    browser_await(of, "new Promise(r => setTimeout(() => r(true), 20))");
    assert_non_null(strstr(browser_errors(of), "rejected"));
    /* The next page begins without them. */
    browser_open(of, "tests/data/web/hands.html", "");
    assert_string_equal(browser_errors(of), "");
}

static void test_requests(void **state) {
    (void)state;
    Browser *of = shared();
    browser_open(of, "tests/data/web/hands.html", "");
    assert_string_equal(browser_requests(of), "");
    browser_do(of, "fetch('http://127.0.0.1:9/x').catch(() => 0)");
    assert_string_equal(browser_requests(of), "http://127.0.0.1:9/x\n");
}

/* Whether the page has heard these words one after the other, whatever else is between them. */
static void heard(Browser *of, const char *const words[]) {
    const char *all = browser_string(of, "heard.join(' ')"), *at = all;
    for (int i = 0; words[i]; i++) {
        at = strstr(at, words[i]);
        if (!at) fail_msg("no '%s' in: %s", words[i], all);
        at += strlen(words[i]);
    }
}

static void test_mouse(void **state) {
    (void)state;
    Browser *of = shared();
    browser_view(of, 600, 400, false);
    browser_open(of, "tests/data/web/hands.html", "");
    browser_move(of, 10, 20);
    browser_press(of, "right");
    browser_move(of, 30, 40);
    browser_release(of, "right");
    browser_press(of, "left");
    browser_release(of, "left");
    browser_wheel(of, 0, 53);
    browser_await(of, "heard.some(word => word.startsWith('wheel'))");
    heard(of, (const char *const[]){"pointermove:0:10,20", "pointerdown:2:10,20", "pointermove:2:30,40",
                                    "pointerup:0:30,40", "pointerdown:1:30,40", "pointerup:0:30,40",
                                    "wheel:0:30,40:53", NULL});
    /* An element out of sight is scrolled to. */
    browser_click(of, "#below");
    heard(of, (const char *const[]){"below", NULL});
}

static void test_keys(void **state) {
    (void)state;
    Browser *of = shared();
    browser_open(of, "tests/data/web/hands.html", "");
    browser_do(of, "document.getElementById('text').focus()");
    browser_key(of, "7");
    browser_key(of, "x");
    assert_string_equal(browser_string(of, "document.getElementById('text').value"), "7x");
    browser_key(of, "Tab");
    browser_key(of, "ArrowRight");
    browser_key(of, "ArrowRight");
    assert_string_equal(browser_string(of, "document.activeElement.id + document.activeElement.value"),
                        "slider7");
    browser_key(of, "Home");
    assert_string_equal(browser_string(of, "document.activeElement.value"), "0");
    heard(of, (const char *const[]){"key:7", "key:x", "key:Tab", "key:ArrowRight", "key:Home", NULL});
}

static void test_touch(void **state) {
    (void)state;
    Browser *of = shared();
    browser_view(of, 390, 700, true);
    browser_open(of, "tests/data/web/hands.html", "");
    assert_true(browser_true(of, "navigator.maxTouchPoints == 2 && innerWidth == 390"));
    browser_touch(of, 1, (double[]){10, 20});
    browser_touch(of, 2, (double[]){10, 20, 50, 60});
    browser_touch(of, 2, (double[]){20, 20, 70, 60});
    browser_untouch(of);
    browser_await(of, "heard.some(word => word.startsWith('touchend'))");
    heard(of, (const char *const[]){"touchstart::10,20", "10,20+50,60", "20,20+70,60", "touchend", NULL});
    browser_view(of, 600, 400, false);
    browser_open(of, "tests/data/web/hands.html", "");
    assert_true(browser_true(of, "innerWidth == 600"));
}

/* The screenshot's pixel, 0 to 1 as it is shown. */
static float shown(Browser *of, int x, int y, int channel) {
    Image image = {0};
    Error error;
    const char *path = support_path("screen.png");
    browser_screenshot(of, path);
    if (!image_read(&image, path, &error)) fail_msg("%s", error.text);
    float value = image.rgba[4 * (y * image.width + x) + channel];
    image_free(&image);
    return value;
}

static void test_eyes(void **state) {
    (void)state;
    Browser *of = shared();
    browser_view(of, 600, 400, false);
    browser_scheme(of, "dark");
    browser_open(of, "tests/data/web/hands.html", "");
    assert_float_equal(shown(of, 100, 50, 0), 0, 0.01);
    assert_float_equal(shown(of, 100, 50, 2), 1, 0.01);
    assert_float_equal(shown(of, 500, 50, 1), 0, 0.01);
    browser_scheme(of, "light");
    assert_float_equal(shown(of, 500, 50, 1), 1, 0.01);
    browser_scripts(of, false);
    browser_open(of, "tests/data/web/hands.html", "");
    assert_string_equal(browser_string(of, "document.querySelector('noscript').innerText"), "no scripts");
    browser_scripts(of, true);
}

static void test_saving(void **state) {
    (void)state;
    Browser *of = shared();
    Text file = {0};
    Error error;
    browser_downloads(of, support_path("."));
    browser_open(of, "tests/data/web/hands.html", "");
    browser_click(of, "#save");
    const char *path = browser_downloaded(of);
    assert_non_null(strstr(path, "/saved.bin"));
    if (!file_read(path, STATUS_FAILURE, &file, &error)) fail_msg("%s", error.text);
    assert_int_equal(file.size, 5);
    assert_memory_equal(file.data, "\x00\x01\xfe\xff\x0a", 5);
    text_free(&file);
}

static void test_before(void **state) {
    (void)state;
    Browser *of = shared();
    browser_before(of, "HTMLCanvasElement.prototype.getContext = () => null");
    browser_open(of, "tests/data/web/webgl.html", "");
    assert_string_equal(browser_string(of, "document.getElementById('said').textContent"), "no WebGL 2");
    browser_before(of, NULL);
    browser_open(of, "tests/data/web/webgl.html", "");
    assert_string_equal(browser_string(of, "document.getElementById('said').textContent"), "WebGL 2");
}

/* How many processes have a browser's profile in this test's folder among their words. */
static int processes(void) {
    char words[65536], profile[512];
    glob_t found;
    int count = 0;
    snprintf(profile, sizeof profile, "--user-data-dir=%s", support_path("browser_"));
    if (glob("/proc/[0-9]*/cmdline", 0, NULL, &found) != 0) return -1;
    for (size_t i = 0; i < found.gl_pathc; i++) {
        FILE *file = fopen(found.gl_pathv[i], "rb");
        size_t size = file ? fread(words, 1, sizeof words - 1, file) : 0;
        if (file) fclose(file);
        for (size_t k = 0; k < size; k++) words[k] = words[k] ? words[k] : ' ';
        words[size] = 0;
        count += strstr(words, profile) != NULL;
    }
    globfree(&found);
    return count;
}

static size_t profiles(void) {
    glob_t found;
    glob(support_path("browser_*"), 0, NULL, &found);
    size_t count = found.gl_pathc;
    globfree(&found);
    return count;
}

/* Nothing is left of a browser: no process, no profile. */
static void test_end(void **state) {
    (void)state;
    shared();
    assert_true(processes() > 1);
    assert_int_equal(profiles(), 1);
    browser_stop(browser);
    browser = NULL;
    assert_int_equal(processes(), 0);
    assert_int_equal(profiles(), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_llvmpipe), cmocka_unit_test(test_values), cmocka_unit_test(test_errors),
        cmocka_unit_test(test_requests), cmocka_unit_test(test_mouse),  cmocka_unit_test(test_keys),
        cmocka_unit_test(test_touch),    cmocka_unit_test(test_eyes),   cmocka_unit_test(test_saving),
        cmocka_unit_test(test_before),   cmocka_unit_test(test_end),    cmocka_unit_test(test_swiftshader),
        cmocka_unit_test(test_no_webgl),
    };
    return cmocka_run_group_tests_name("browser", tests, set_up, tear_down);
}
