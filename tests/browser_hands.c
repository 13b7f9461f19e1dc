/* The browser's hands: its mouse, fingers and keys, and the files that pages save. */
#include "browser_pipe.h"

#include "base/clock.h"

#include <stdio.h>
#include <string.h>

/* ---- The mouse */

static int button_bit(const char *button) {
    return strcmp(button, "left") == 0 ? 1 : strcmp(button, "right") == 0 ? 2 : 4;
}

static void mouse(Browser *browser, const char *type, const char *button) {
    int clicks = strcmp(type, "mouseMoved") != 0;
    browser_tell(browser, "Input.dispatchMouseEvent",
                 json_pack("{s:s, s:f, s:f, s:s, s:i, s:i}", "type", type, "x", browser->x, "y", browser->y,
                           "button", button, "buttons", browser->buttons, "clickCount", clicks));
}

void browser_move(Browser *browser, double x, double y) {
    browser->x = x, browser->y = y;
    /* The button of a drag is that which is down. */
    mouse(browser, "mouseMoved",
          browser->buttons & 1   ? "left"
          : browser->buttons & 2 ? "right"
          : browser->buttons     ? "middle"
                                 : "none");
}

void browser_press(Browser *browser, const char *button) {
    browser->buttons |= button_bit(button);
    mouse(browser, "mousePressed", button);
}

void browser_release(Browser *browser, const char *button) {
    browser->buttons &= ~button_bit(button);
    mouse(browser, "mouseReleased", button);
}

void browser_wheel(Browser *browser, double dx, double dy) {
    browser_tell(browser, "Input.dispatchMouseEvent",
                 json_pack("{s:s, s:f, s:f, s:f, s:f}", "type", "mouseWheel", "x", browser->x, "y",
                           browser->y, "deltaX", dx, "deltaY", dy));
}

void browser_center(Browser *browser, const char *selector, double *x, double *y) {
    if (!browser_true(browser, "document.querySelector('%s')", selector)) fail_msg("no element %s", selector);
    browser_do(browser,
               "document.querySelector('%s').scrollIntoView({block: 'nearest', behavior: 'instant'})",
               selector);
    const char *place = browser_string(browser,
                                       "(r => [r.x + r.width / 2, r.y + r.height / 2].join(' '))"
                                       "(document.querySelector('%s').getBoundingClientRect())",
                                       selector);
    if (sscanf(place, "%lf %lf", x, y) != 2) fail_msg("%s is nowhere", selector);
}

void browser_click(Browser *browser, const char *selector) {
    double x, y;
    browser_center(browser, selector, &x, &y);
    browser_move(browser, x, y);
    browser_press(browser, "left");
    browser_release(browser, "left");
}

/* ---- Fingers */

void browser_touch(Browser *browser, int count, const double xy[]) {
    json_t *points = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(points,
                              json_pack("{s:f, s:f, s:i}", "x", xy[2 * i], "y", xy[2 * i + 1], "id", i));
    browser_tell(browser, "Input.dispatchTouchEvent",
                 json_pack("{s:s, s:o}", "type", browser->touches ? "touchMove" : "touchStart", "touchPoints",
                           points));
    browser->touches = count;
}

void browser_untouch(Browser *browser) {
    browser_tell(browser, "Input.dispatchTouchEvent",
                 json_pack("{s:s, s:[]}", "type", "touchEnd", "touchPoints"));
    browser->touches = 0;
}

/* ---- Keys */

static const struct Key {
    const char *name, *code, *text;
    int number;
} keys[] = {
    {"Tab", "Tab", "", 9},
    {"Enter", "Enter", "\r", 13},
    {"Escape", "Escape", "", 27},
    {" ", "Space", " ", 32},
    {"PageUp", "PageUp", "", 33},
    {"PageDown", "PageDown", "", 34},
    {"End", "End", "", 35},
    {"Home", "Home", "", 36},
    {"ArrowLeft", "ArrowLeft", "", 37},
    {"ArrowUp", "ArrowUp", "", 38},
    {"ArrowRight", "ArrowRight", "", 39},
    {"ArrowDown", "ArrowDown", "", 40},
    {"Delete", "Delete", "", 46},
    {"Backspace", "Backspace", "", 8},
};

static void key_event(Browser *browser, const char *type, const struct Key *key) {
    browser_tell(browser, "Input.dispatchKeyEvent",
                 json_pack("{s:s, s:s, s:s, s:s, s:i}", "type", type, "key", key->name, "code", key->code,
                           "text", key->text, "windowsVirtualKeyCode", key->number));
}

void browser_key(Browser *browser, const char *name) {
    struct Key key = {name, "", name, 0};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        if (strcmp(keys[i].name, name) == 0) key = keys[i];
    }
    if (!key.number && name[0] && name[1]) fail_msg("no key %s is known", name);
    key_event(browser, key.text[0] ? "keyDown" : "rawKeyDown", &key);
    key.text = "";
    key_event(browser, "keyUp", &key);
}

/* ---- What is saved */

void browser_downloads(Browser *browser, const char *folder) {
    char session[sizeof browser->session];
    snprintf(browser->folder, sizeof browser->folder, "%s", folder);
    browser->downloads = 0;
    /* This is a matter of the browser and not of the page. */
    strcpy(session, browser->session);
    browser->session[0] = 0;
    browser_tell(
        browser, "Browser.setDownloadBehavior",
        json_pack("{s:s, s:s, s:b}", "behavior", "allow", "downloadPath", folder, "eventsEnabled", 1));
    strcpy(browser->session, session);
}

const char *browser_downloaded(Browser *browser) {
    static char path[1100];
    Error error;
    double end_s = clock_seconds() + BROWSER_PATIENCE_S;
    while (!browser->downloads) {
        if (!browser_pipe_hear(browser, end_s, &error)) fail_msg("no file was saved: %s", error.text);
    }
    browser->downloads--;
    snprintf(path, sizeof path, "%s/%s", browser->folder, browser->downloaded);
    return path;
}
