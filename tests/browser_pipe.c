#include "browser_pipe.h"

#include "base/clock.h"
#include "base/file.h"
#include "base/memory.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- The process */

/* The browser: what the environment says, or the first of these names. NULL where there is none. */
static const char *find_program(void) {
    static const char *const names[] = {"chromium", "chromium-browser", "google-chrome-stable"};
    const char *said = getenv("MAGICHOUR_BROWSER");
    char command[128];
    if (said && *said) return said;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        snprintf(command, sizeof command, "command -v %s >/dev/null 2>&1", names[i]);
        if (system(command) == 0) return names[i];
    }
    return NULL;
}

/* No first steps, no traffic of the browser's own, nothing outside of the profile. Pages that were left are
 * not kept, because their contexts would compete with the next page's. */
static const char *const usual_flags[] = {
    "--headless=new",
    "--remote-debugging-pipe",
    "--no-first-run",
    "--no-default-browser-check",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-extensions",
    "--disable-crash-reporter",
    "--disable-breakpad",
    "--disable-dev-shm-usage",
    "--disable-features=BackForwardCache,Translate,MediaRouter,OptimizationHints",
    "--host-resolver-rules=MAP * ~NOTFOUND",
    "--password-store=basic",
    "--use-mock-keychain",
    "--force-color-profile=srgb",
    "--mute-audio",
};

enum { USUAL = sizeof usual_flags / sizeof *usual_flags, MOST_FLAGS = USUAL + 16 };

/* In the child: the ends of the pipes become 3 and 4, and all output goes into the log. */
static void become(const Browser *browser, const char *program, const char *const *flags, const int to[2],
                   const int from[2]) {
    const char *words[MOST_FLAGS + 1] = {program};
    char profile[600], log[600];
    int count = 1;
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    snprintf(profile, sizeof profile, "--user-data-dir=%s", browser->profile);
    snprintf(log, sizeof log, "%s/log", browser->profile);
    for (int i = 0; i < USUAL; i++) words[count++] = usual_flags[i];
    words[count++] = profile;
    /* The browser does not run as root otherwise. */
    if (geteuid() == 0) words[count++] = "--no-sandbox";
    for (; *flags && count < MOST_FLAGS - 1; flags++) words[count++] = *flags;
    words[count] = "about:blank";
    setenv("HOME", browser->profile, 1);
    setenv("XDG_CONFIG_HOME", browser->profile, 1);
    setenv("XDG_CACHE_HOME", browser->profile, 1);
    /* Mesa draws by its software, whatever else is there. */
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    /* The ends may be 3 or 4 themselves, so they first go where nothing is. */
    int in = fcntl(to[0], F_DUPFD, 10), out = fcntl(from[1], F_DUPFD, 10);
    int nothing = open("/dev/null", O_RDONLY), said = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(nothing, 0), dup2(said, 1), dup2(said, 2), dup2(in, 3), dup2(out, 4);
    for (int i = 5; i < 64; i++) close(i);
    execvp(program, (char *const *)words);
    perror(program);
    _exit(127);
}

/* The last words of the browser, for an error. */
static void add_log(const Browser *browser, Error *error) {
    char path[600];
    Text log = {0};
    Error ignored;
    snprintf(path, sizeof path, "%s/log", browser->profile);
    if (file_read(path, STATUS_FAILURE, &log, &ignored)) {
        const char *text = text_string(&log);
        size_t length = strlen(text), used = strlen(error->text);
        snprintf(error->text + used, sizeof error->text - used, "; its last words:\n%s",
                 length ? text + (length > 600 ? length - 600 : 0) : "(none)");
    }
    text_free(&log);
}

bool browser_pipe_start(Browser *browser, const char *name, const char *const *flags, Error *error) {
    int to[2], from[2];
    const char *program = find_program();
    memset(browser, 0, sizeof *browser);
    browser->to = browser->from = -1;
    if (!program) return error_set(error, STATUS_FAILURE, "no chromium here (tools/deps.sh web)");
    snprintf(browser->profile, sizeof browser->profile, "%s_XXXXXX", name);
    if (!mkdtemp(browser->profile)) return error_set(error, STATUS_FAILURE, "no folder for a profile");
    if (pipe(to) != 0 || pipe(from) != 0) return error_set(error, STATUS_FAILURE, "no pipe");
    /* A browser that has ended must not end the tests. */
    signal(SIGPIPE, SIG_IGN);
    browser->process = fork();
    if (browser->process == 0) become(browser, program, flags, to, from);
    close(to[0]), close(from[1]);
    browser->to = to[1], browser->from = from[0];
    fcntl(browser->to, F_SETFD, FD_CLOEXEC), fcntl(browser->from, F_SETFD, FD_CLOEXEC);
    json_t *version = browser_pipe_ask(browser, "Browser.getVersion", NULL, BROWSER_PATIENCE_S / 2, error);
    if (!version) {
        error_prefix(error, "%s does not start: ", program);
        add_log(browser, error);
        browser_pipe_stop(browser);
        return false;
    }
    json_decref(version);
    return true;
}

static bool ended(Browser *browser, double seconds) {
    for (double end = clock_seconds() + seconds; clock_seconds() < end; usleep(10000)) {
        if (waitpid(browser->process, NULL, WNOHANG) != 0) return true;
    }
    return false;
}

void browser_pipe_stop(Browser *browser) {
    char command[600];
    if (browser->process > 0) {
        /* It ends by itself when its pipe does. What is left of its group then has nobody to ask. */
        close(browser->to), close(browser->from);
        bool gone = ended(browser, 5);
        kill(-browser->process, SIGKILL);
        if (!gone) waitpid(browser->process, NULL, 0);
    }
    if (browser->profile[0]) {
        snprintf(command, sizeof command, "rm -rf '%s'", browser->profile);
        if (system(command) != 0) print_message("%s is left\n", browser->profile);
    }
    text_free(&browser->incoming), text_free(&browser->errors);
    text_free(&browser->requests), text_free(&browser->string);
    free(browser->bytes);
    memset(browser, 0, sizeof *browser);
}

/* ---- The messages */

static bool send_text(Browser *browser, const char *text, double end_s, Error *error) {
    size_t size = strlen(text) + 1;
    for (size_t sent = 0; sent < size;) {
        struct pollfd ready = {browser->to, POLLOUT, 0};
        if (clock_seconds() > end_s || poll(&ready, 1, 1000) < 0)
            return error_set(error, STATUS_FAILURE, "the browser does not take messages");
        if (!(ready.revents & (POLLOUT | POLLERR))) continue;
        ssize_t wrote = write(browser->to, text + sent, size - sent < 4096 ? size - sent : 4096);
        if (wrote < 0) return error_set(error, STATUS_FAILURE, "the browser has ended");
        sent += (size_t)wrote;
    }
    return true;
}

/* The next message as it stands, or NULL with the error; it is good until the next call. */
static const char *receive_text(Browser *browser, double end_s, Error *error) {
    size_t searched = browser->taken;
    for (;;) {
        Text *in = &browser->incoming;
        char *end = in->size > searched ? memchr(in->data + searched, 0, in->size - searched) : NULL;
        if (end) {
            const char *message = in->data + browser->taken;
            browser->taken = (size_t)(end + 1 - in->data);
            return message;
        }
        /* Room for what comes. */
        if (browser->taken) {
            memmove(in->data, in->data + browser->taken, in->size - browser->taken);
            in->size -= browser->taken;
            browser->taken = 0;
        }
        searched = in->size;
        double left_s = end_s - clock_seconds();
        struct pollfd ready = {browser->from, POLLIN, 0};
        if (left_s <= 0 || poll(&ready, 1, (int)(1000 * left_s) + 1) == 0) {
            error_set(error, STATUS_FAILURE, "no answer in time");
            return NULL;
        }
        char part[65536];
        ssize_t got = read(browser->from, part, sizeof part);
        if (got <= 0) {
            error_set(error, STATUS_FAILURE, "the browser has ended");
            return NULL;
        }
        text_append(in, part, (size_t)got);
    }
}

static json_t *receive(Browser *browser, double end_s, Error *error) {
    json_error_t fault;
    const char *text = receive_text(browser, end_s, error);
    if (!text) return NULL;
    json_t *message = json_loads(text, JSON_ALLOW_NUL, &fault);
    if (!message) error_set(error, STATUS_FAILURE, "the browser's message is no JSON: %s", fault.text);
    return message;
}

/* Hands a message without a number, which is an event, to its receiver. */
static void hand_over(Browser *browser, const json_t *message) {
    const char *method = json_string_value(json_object_get(message, "method"));
    if (method) browser_event(browser, method, json_object_get(message, "params"));
}

bool browser_pipe_hear(Browser *browser, double end_s, Error *error) {
    json_t *message = receive(browser, end_s, error);
    if (!message) return false;
    hand_over(browser, message);
    json_decref(message);
    return true;
}

json_t *browser_pipe_ask(Browser *browser, const char *method, json_t *params, double patience_s,
                         Error *error) {
    double end_s = clock_seconds() + patience_s;
    int number = ++browser->number;
    json_t *message = json_pack("{s:i, s:s, s:o}", "id", number, "method", method, "params",
                                params ? params : json_object());
    if (browser->session[0]) json_object_set_new(message, "sessionId", json_string(browser->session));
    char *text = json_dumps(message, JSON_COMPACT);
    json_decref(message);
    bool sent = send_text(browser, text, end_s, error);
    free(text);
    json_t *result = NULL;
    for (bool answered = !sent; !answered;) {
        message = receive(browser, end_s, error);
        if (!message) break;
        answered = json_integer_value(json_object_get(message, "id")) == number;
        json_t *fault = json_object_get(message, "error");
        if (!answered)
            hand_over(browser, message);
        else if (fault)
            error_set(error, STATUS_FAILURE, "%s", json_string_value(json_object_get(fault, "message")));
        else
            result = json_incref(json_object_get(message, "result"));
        json_decref(message);
        if (browser->crashed && !answered) {
            error_set(error, STATUS_FAILURE, "the page has crashed");
            break;
        }
    }
    return result;
}

json_t *browser_call(Browser *browser, const char *method, json_t *params) {
    Error error;
    json_t *result = browser_pipe_ask(browser, method, params, BROWSER_PATIENCE_S, &error);
    if (!result) {
        add_log(browser, &error);
        fail_msg("%s: %s", method, error.text);
    }
    return result;
}

void browser_tell(Browser *browser, const char *method, json_t *params) {
    json_decref(browser_call(browser, method, params));
}
