#include "browser.h"

#include "browser_pipe.h"

#include "base/clock.h"
#include "base/file.h"
#include "base/memory.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- Start and end */

static const char *const *flags_of(BrowserDrawing drawing) {
    static const char *const llvmpipe[] = {"--use-angle=gl-egl", "--ignore-gpu-blocklist", NULL};
    static const char *const swiftshader[] = {"--use-angle=swiftshader", "--enable-unsafe-swiftshader", NULL};
    static const char *const none[] = {"--disable-gpu", "--disable-software-rasterizer", NULL};
    return drawing == BROWSER_LLVMPIPE ? llvmpipe : drawing == BROWSER_SWIFTSHADER ? swiftshader : none;
}

void browser_missing(const char *reason) {
    const char *required = getenv("REQUIRE_WEB");
    if (required && *required && strcmp(required, "0") != 0) fail_msg("a browser is required: %s", reason);
    print_message("no browser here: %s\n", reason);
    skip();
}

/* All further messages are about one page. */
static void take_page(Browser *browser) {
    char session[sizeof browser->session];
    json_t *page = browser_call(browser, "Target.createTarget", json_pack("{s:s}", "url", "about:blank"));
    json_t *attached =
        browser_call(browser, "Target.attachToTarget",
                     json_pack("{s:O, s:b}", "targetId", json_object_get(page, "targetId"), "flatten", 1));
    snprintf(session, sizeof session, "%s", json_string_value(json_object_get(attached, "sessionId")));
    strcpy(browser->session, session);
    json_decref(page), json_decref(attached);
    static const char *const domains[] = {"Page", "Runtime", "Network", "Log", "Inspector"};
    for (size_t i = 0; i < sizeof domains / sizeof *domains; i++) {
        char method[64];
        snprintf(method, sizeof method, "%s.enable", domains[i]);
        browser_tell(browser, method, NULL);
    }
}

Browser *browser_start(BrowserDrawing drawing) {
    /* What did not start once is not waited for again. */
    static Error error;
    if (error.text[0]) browser_missing(error.text);
    Browser *browser = memory_get(1, sizeof *browser);
    if (!browser_pipe_start(browser, support_path("browser"), flags_of(drawing), &error)) {
        free(browser);
        browser_missing(error.text);
    }
    take_page(browser);
    return browser;
}

void browser_stop(Browser *browser) {
    if (!browser) return;
    browser_pipe_stop(browser);
    free(browser);
}

bool browser_runs(const Browser *browser) {
    return waitpid(browser->process, NULL, WNOHANG) == 0 && !browser->crashed;
}

/* ---- Events */

/* Appends what a value of a console's message shows. */
static void add_value(Text *text, const json_t *value) {
    const json_t *shown = json_object_get(value, "value");
    const char *description = json_string_value(json_object_get(value, "description"));
    if (json_is_string(shown))
        text_print(text, " %s", json_string_value(shown));
    else if (description)
        text_print(text, " %s", description);
}

static void hear_console(Browser *browser, const json_t *params) {
    const char *type = json_string_value(json_object_get(params, "type"));
    const json_t *values = json_object_get(params, "args");
    if (!type || (strcmp(type, "error") != 0 && strcmp(type, "assert") != 0)) return;
    text_print(&browser->errors, "console.%s:", type);
    for (size_t i = 0; i < json_array_size(values); i++)
        add_value(&browser->errors, json_array_get(values, i));
    text_print(&browser->errors, "\n");
}

static void hear_exception(Browser *browser, const json_t *params) {
    const json_t *details = json_object_get(params, "exceptionDetails");
    const char *words = json_string_value(json_object_get(details, "text"));
    text_print(&browser->errors, "%s", words ? words : "");
    add_value(&browser->errors, json_object_get(details, "exception"));
    text_print(&browser->errors, "\n");
}

/* What the browser itself says of the page, such as a file that is not there. */
static void hear_log(Browser *browser, const json_t *params) {
    const char *level = "", *text = "", *url = "";
    json_unpack((json_t *)params, "{s:{s:s, s:s, s?s}}", "entry", "level", &level, "text", &text, "url",
                &url);
    if (strcmp(level, "error") == 0) text_print(&browser->errors, "%s %s\n", text, url);
}

static void hear_request(Browser *browser, const json_t *params) {
    static const char *const inner[] = {"file:", "data:", "blob:", "about:"};
    const char *url = "";
    json_unpack((json_t *)params, "{s:{s:s}}", "request", "url", &url);
    for (size_t i = 0; i < sizeof inner / sizeof *inner; i++) {
        if (strncmp(url, inner[i], strlen(inner[i])) == 0) return;
    }
    text_print(&browser->requests, "%s\n", url);
}

static void hear_download(Browser *browser, const json_t *params) {
    const char *name = json_string_value(json_object_get(params, "suggestedFilename"));
    const char *state = json_string_value(json_object_get(params, "state"));
    if (name) snprintf(browser->downloaded, sizeof browser->downloaded, "%s", name);
    if (state && strcmp(state, "completed") == 0) browser->downloads++;
    if (state && strcmp(state, "canceled") == 0) text_print(&browser->errors, "a file was not saved\n");
}

void browser_event(Browser *browser, const char *method, const json_t *params) {
    if (strcmp(method, "Page.loadEventFired") == 0) browser->loads++;
    if (strcmp(method, "Inspector.targetCrashed") == 0) browser->crashed = true;
    if (strcmp(method, "Runtime.consoleAPICalled") == 0) hear_console(browser, params);
    if (strcmp(method, "Runtime.exceptionThrown") == 0) hear_exception(browser, params);
    if (strcmp(method, "Log.entryAdded") == 0) hear_log(browser, params);
    if (strcmp(method, "Network.requestWillBeSent") == 0) hear_request(browser, params);
    if (strncmp(method, "Browser.download", 16) == 0) hear_download(browser, params);
}

/* ---- Pages */

static void navigate(Browser *browser, const char *url) {
    Error error;
    int loads = browser->loads;
    double end_s = clock_seconds() + BROWSER_PATIENCE_S;
    json_t *result = browser_call(browser, "Page.navigate", json_pack("{s:s}", "url", url));
    const char *fault = json_string_value(json_object_get(result, "errorText"));
    if (fault) fail_msg("%s: %s", url, fault);
    json_decref(result);
    while (browser->loads == loads) {
        if (!browser_pipe_hear(browser, end_s, &error)) fail_msg("%s does not load: %s", url, error.text);
    }
}

void browser_open(Browser *browser, const char *path, const char *fragment) {
    Text url = {0};
    char real[4096];
    if (!strchr(path, ':') && !realpath(path, real)) fail_msg("%s: no such file", path);
    /* The same page with another fragment would not be loaded again. */
    navigate(browser, "about:blank");
    text_free(&browser->errors), text_free(&browser->requests);
    if (strchr(path, ':'))
        text_print(&url, "%s%s", path, fragment);
    else
        text_print(&url, "file://%s%s", real, fragment);
    navigate(browser, text_string(&url));
    text_free(&url);
}

void browser_before(Browser *browser, const char *script) {
    if (browser->script[0])
        browser_tell(browser, "Page.removeScriptToEvaluateOnNewDocument",
                     json_pack("{s:s}", "identifier", browser->script));
    browser->script[0] = 0;
    if (!script) return;
    json_t *result =
        browser_call(browser, "Page.addScriptToEvaluateOnNewDocument", json_pack("{s:s}", "source", script));
    snprintf(browser->script, sizeof browser->script, "%s",
             json_string_value(json_object_get(result, "identifier")));
    json_decref(result);
}

void browser_scripts(Browser *browser, bool allowed) {
    browser_tell(browser, "Emulation.setScriptExecutionDisabled", json_pack("{s:b}", "value", !allowed));
}

/* ---- Expressions */

/* The value of an expression, which is the caller's; `wrap` stands around it: "String(%s)". */
static json_t *evaluate(Browser *browser, const char *before, const char *after, const char *format,
                        va_list list) {
    char expression[16384];
    Text text = {0};
    if (vsnprintf(expression, sizeof expression, format, list) >= (int)sizeof expression)
        fail_msg("the expression is too long");
    text_print(&text, "(async () => %s(await (%s))%s)()", before, expression, after);
    json_t *result = browser_call(browser, "Runtime.evaluate",
                                  json_pack("{s:s, s:b, s:b, s:b}", "expression", text_string(&text),
                                            "awaitPromise", 1, "returnByValue", 1, "userGesture", 1));
    text_free(&text);
    const json_t *fault = json_object_get(result, "exceptionDetails");
    if (fault) {
        text_print(&text, "%s:", expression);
        add_value(&text, json_object_get(fault, "exception"));
        fail_msg("%s", text_string(&text));
    }
    json_t *value = json_incref(json_object_get(json_object_get(result, "result"), "value"));
    json_decref(result);
    return value;
}

double browser_number(Browser *browser, const char *format, ...) {
    va_list list;
    va_start(list, format);
    json_t *value = evaluate(browser, "", "", format, list);
    va_end(list);
    /* JSON has no word for what is not finite. */
    if (!json_is_number(value)) fail_msg("%s is no finite number", format);
    double number = json_number_value(value);
    json_decref(value);
    return number;
}

bool browser_true(Browser *browser, const char *format, ...) {
    va_list list;
    va_start(list, format);
    json_t *value = evaluate(browser, "Boolean", "", format, list);
    va_end(list);
    bool is = json_is_true(value);
    json_decref(value);
    return is;
}

const char *browser_string(Browser *browser, const char *format, ...) {
    va_list list;
    va_start(list, format);
    json_t *value = evaluate(browser, "String", "", format, list);
    va_end(list);
    text_free(&browser->string);
    text_append(&browser->string, json_string_value(value), json_string_length(value));
    json_decref(value);
    return text_string(&browser->string);
}

static unsigned digit_of(char c) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = strchr(digits, c);
    return c && at ? (unsigned)(at - digits) : 0;
}

/* Base 64, which is how bytes stand in JSON. */
static size_t decode(const char *text, size_t length, unsigned char **bytes) {
    size_t size = 0;
    unsigned char *to = *bytes = memory_get(length / 4 * 3 + 1, 1);
    for (size_t i = 0; i + 3 < length; i += 4) {
        unsigned word = 0;
        for (size_t k = 0; k < 4; k++) word = word << 6 | digit_of(text[i + k]);
        for (int k = 2; k >= 0; k--) to[size++] = (unsigned char)(word >> (8 * k));
    }
    while (length && text[length - 1] == '=') length--, size--;
    return size;
}

const void *browser_bytes(Browser *browser, size_t *size, const char *format, ...) {
    /* A binary string in parts, because a call takes only so many arguments. */
    static const char *const after = ")";
    static const char *const before = "(b => { const u = ArrayBuffer.isView(b)"
                                      " ? new Uint8Array(b.buffer, b.byteOffset, b.byteLength)"
                                      " : new Uint8Array(b); let s = '';"
                                      " for (let i = 0; i < u.length; i += 8192)"
                                      " s += String.fromCharCode(...u.subarray(i, i + 8192));"
                                      " return btoa(s); })(";
    va_list list;
    va_start(list, format);
    json_t *value = evaluate(browser, before, after, format, list);
    va_end(list);
    unsigned char *bytes;
    *size = decode(json_string_value(value), json_string_length(value), &bytes);
    json_decref(value);
    free(browser->bytes);
    return browser->bytes = bytes;
}

void browser_do(Browser *browser, const char *format, ...) {
    va_list list;
    va_start(list, format);
    json_decref(evaluate(browser, "void ", "", format, list));
    va_end(list);
}

void browser_await(Browser *browser, const char *format, ...) {
    double end_s = clock_seconds() + BROWSER_PATIENCE_S;
    char expression[4096];
    va_list list;
    va_start(list, format);
    vsnprintf(expression, sizeof expression, format, list);
    va_end(list);
    while (!browser_true(browser, "%s", expression)) {
        if (clock_seconds() > end_s)
            fail_msg("waited in vain for: %s\n%s", expression, browser_errors(browser));
        usleep(10000);
    }
}

void browser_give(Browser *browser, const char *name, const char *text) {
    json_t *string = json_string(text);
    if (!string) fail_msg("%s is no UTF-8", name);
    char *quoted = json_dumps(string, JSON_ENCODE_ANY);
    Text expression = {0};
    text_print(&expression, "void (window.%s = %s)", name, quoted);
    browser_tell(browser, "Runtime.evaluate", json_pack("{s:s}", "expression", text_string(&expression)));
    text_free(&expression);
    free(quoted);
    json_decref(string);
}

/* ---- What was told */

/* Whatever was sent before an answer is heard before it. */
const char *browser_errors(Browser *browser) {
    browser_tell(browser, "Page.getNavigationHistory", NULL);
    return text_string(&browser->errors);
}

const char *browser_requests(Browser *browser) {
    browser_tell(browser, "Page.getNavigationHistory", NULL);
    return text_string(&browser->requests);
}

/* ---- Eyes */

void browser_view(Browser *browser, int width, int height, bool phone) {
    browser_tell(browser, "Emulation.setDeviceMetricsOverride",
                 json_pack("{s:i, s:i, s:f, s:b}", "width", width, "height", height, "deviceScaleFactor", 1.0,
                           "mobile", phone));
    browser_tell(browser, "Emulation.setTouchEmulationEnabled",
                 json_pack("{s:b, s:i}", "enabled", phone, "maxTouchPoints", 2));
}

void browser_scheme(Browser *browser, const char *scheme) {
    browser_tell(browser, "Emulation.setEmulatedMedia",
                 json_pack("{s:[{s:s, s:s}]}", "features", "name", "prefers-color-scheme", "value", scheme));
}

void browser_screenshot(Browser *browser, const char *path) {
    Error error;
    unsigned char *bytes;
    json_t *result = browser_call(browser, "Page.captureScreenshot", json_pack("{s:s}", "format", "png"));
    const json_t *data = json_object_get(result, "data");
    size_t size = decode(json_string_value(data), json_string_length(data), &bytes);
    json_decref(result);
    if (!file_replace(path, bytes, size, &error)) fail_msg("%s", error.text);
    free(bytes);
}
