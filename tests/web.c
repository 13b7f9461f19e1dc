#include "web.h"

#include "failed.h"

#include "base/text.h"
#include "image/compare.h"
#include "image/format.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static Browser *shared;

int web_setup(void **state) {
    mkdir("build", 0777), mkdir("build/web", 0777);
    return support_folder(state);
}

int web_teardown(void **state) {
    browser_stop(shared);
    return support_clean(state);
}

Browser *web_browser(void) {
    /* A browser that one test has lost does not fail the next. */
    if (shared && !browser_runs(shared)) {
        browser_stop(shared);
        shared = NULL;
    }
    if (!shared) shared = browser_start(BROWSER_LLVMPIPE);
    return shared;
}

const char *web_export(const char *scene, const char *options) {
    const char *name = strrchr(scene, '/') ? strrchr(scene, '/') + 1 : scene;
    char file[288];
    snprintf(file, sizeof file, "%.*s.html", (int)strcspn(name, "."), name);
    const char *path = support_path(file);
    int status = support_run("", "export '%s' %s -o '%s'", scene, options, path);
    if (status == STATUS_SCENE || status == STATUS_USAGE) return NULL;
    if (status) fail_msg("export %s: status %d: %s", scene, status, support_err);
    return path;
}

void web_open(Browser *browser, const char *path, const char *fragment) {
    browser_open(browser, path, fragment);
    if (!browser_true(browser, "window.magichour")) fail_msg("%s: %s", path, browser_errors(browser));
    browser_await(browser, "magichour.figures.samples || magichour.figures.trouble");
}

Image web_picture(Browser *browser, int samples) {
    size_t size;
    browser_do(browser, "magichour.render(%d)", samples);
    Image image = image_create((int)browser_number(browser, "document.getElementById('picture').width"),
                               (int)browser_number(browser, "document.getElementById('picture').height"));
    const float *pixels = browser_bytes(browser, &size, "magichour.pixels().rgba");
    assert_int_equal(size, 4 * sizeof *pixels * (size_t)image.width * (size_t)image.height);
    memcpy(image.rgba, pixels, size);
    return image;
}

Image web_native(Browser *browser, const char *options) {
    static const char start[] = "magichour render ", end[] = " -o picture.png";
    Image image = {0};
    Error error;
    char command[4096];
    const char *path = support_path("native.exr");
    snprintf(command, sizeof command, "%s", browser_string(browser, "magichour.command_text()"));
    size_t length = strlen(command);
    if (strncmp(command, start, sizeof start - 1) != 0 || length < sizeof end ||
        strcmp(command + length - (sizeof end - 1), end) != 0)
        fail_msg("the page's command is %s", command);
    command[length - (sizeof end - 1)] = 0;
    if (support_run("", "%s %s --quiet -o '%s'", command + 10, options, path) != 0)
        fail_msg("%s: %s", command, support_err);
    if (!image_read(&image, path, &error)) fail_msg("%s", error.text);
    return image;
}

double web_noise(Browser *browser) {
    Image a = web_native(browser, "--seed 1"), b = web_native(browser, "--seed 2");
    Comparison figures;
    Error error;
    if (!compare_images(&a, &b, NULL, &figures, &error)) fail_msg("%s", error.text);
    image_free(&a), image_free(&b);
    return figures.rel_rmse_percent;
}

static double mean(const Image *image) {
    double sum = 0;
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < 4 * pixels; i++) sum += i % 4 < 3 ? (double)image->rgba[i] : 0;
    return sum / (3 * (double)pixels);
}

void web_compare(const char *name, const Image *got, const Image *wanted, WebBounds bounds) {
    Comparison figures;
    Error error;
    if (!compare_images(got, wanted, NULL, &figures, &error)) fail_msg("%s: %s", name, error.text);
    double off = 100 * (mean(got) / mean(wanted) - 1);
    bool black = !(mean(wanted) > 0);
    bool right = !black && figures.nonfinite == 0 && figures.rel_rmse_percent <= bounds.rel_rmse_percent &&
                 fabs(off) <= bounds.mean_percent;
    print_message("%-14s relRMSE %.5f %%, mean %+.5f %%\n", name, figures.rel_rmse_percent, off);
    if (right) return;
    failed_keep(name, got, wanted);
    fail_msg("%s: relRMSE %g %% (at most %g), mean %+g %% (%g)", name, figures.rel_rmse_percent,
             bounds.rel_rmse_percent, off, bounds.mean_percent);
}

void web_view(Browser *browser, bool phone) {
    browser_view(browser, phone ? 390 : 1280, phone ? 844 : 900, phone);
}

void web_look(Browser *browser, const char *name) {
    char path[128];
    double width = browser_number(browser, "innerWidth");
    snprintf(path, sizeof path, "build/web/%s-%g.png", name, width);
    browser_screenshot(browser, path);
    double needed = browser_number(browser, "document.documentElement.scrollWidth");
    if (needed > width) fail_msg("%s is %g pixels wide, in a window of %g", name, needed, width);
}
