#include "desktop.h"

#include "drop.h"

#include "base/clock.h"
#include "base/memory.h"
#include "base/text.h"

#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* Long, for slow machines and sanitizers; nothing waits as long as that unless it fails. */
static const double patience_s = 60;

enum { SCREEN_WIDTH = 800, SCREEN_HEIGHT = 600 };

struct Desktop {
    pid_t server, program;
    int number;
    char log_path[512];
    Text log;
    size_t news;    /* where in the log */
    double picture; /* the last one of before */
};

static bool has(const char *program) {
    char command[128];
    snprintf(command, sizeof command, "command -v %s >/dev/null 2>&1", program);
    return system(command) == 0;
}

static void pause_ms(long ms) {
    usleep((useconds_t)(1000 * ms));
}

/* Xvfb says which number it took. */
static int start_server(Desktop *desktop, const char *folder) {
    int ends[2];
    char number[16] = "", descriptor[16], screen[32];
    snprintf(screen, sizeof screen, "%dx%dx24", SCREEN_WIDTH, SCREEN_HEIGHT);
    if (pipe(ends) != 0) return -1;
    desktop->server = fork();
    if (desktop->server == 0) {
        int nothing = open("/dev/null", O_RDWR);
        dup2(nothing, 0), dup2(nothing, 1), dup2(nothing, 2);
        close(ends[0]);
        snprintf(descriptor, sizeof descriptor, "%d", ends[1]);
        execlp("Xvfb", "Xvfb", "-displayfd", descriptor, "-screen", "0", screen, "-fbdir", folder,
               "-nolisten", "tcp", (char *)NULL);
        _exit(127);
    }
    close(ends[1]);
    for (size_t got = 0; got < sizeof number - 1; got++) {
        if (read(ends[0], number + got, 1) != 1 || number[got] == '\n') break;
    }
    close(ends[0]);
    return *number ? atoi(number) : -1;
}

Desktop *window;

int desktop_setup(void **state) {
    (void)state;
    if (!has("Xvfb") || !has("xdotool")) {
        print_message("no Xvfb or no xdotool here\n");
        skip();
    }
    Desktop *desktop = memory_get(1, sizeof *desktop);
    char folder[512];
    snprintf(folder, sizeof folder, "%s", support_path("."));
    desktop->number = start_server(desktop, folder);
    if (desktop->number < 0) fail_msg("Xvfb does not start");
    snprintf(desktop->log_path, sizeof desktop->log_path, "%s", support_path("view.log"));
    window = desktop;
    return 0;
}

int desktop_teardown(void **state) {
    (void)state;
    Desktop *desktop = window;
    if (!desktop) return 0;
    if (desktop->program > 0) {
        kill(desktop->program, SIGKILL);
        waitpid(desktop->program, NULL, 0);
    }
    kill(desktop->server, SIGTERM);
    waitpid(desktop->server, NULL, 0);
    text_free(&desktop->log);
    free(desktop);
    window = NULL;
    return 0;
}

static void read_log(Desktop *desktop) {
    char buffer[65536];
    size_t got;
    FILE *file = fopen(desktop->log_path, "rb");
    if (!file) return;
    fseek(file, (long)desktop->log.size, SEEK_SET);
    while ((got = fread(buffer, 1, sizeof buffer, file)) > 0) text_append(&desktop->log, buffer, got);
    fclose(file);
}

const char *desktop_log(Desktop *desktop) {
    read_log(desktop);
    return text_string(&desktop->log);
}

static void start_view(Desktop *desktop, const char *format, va_list list) {
    char arguments[2048];
    vsnprintf(arguments, sizeof arguments, format, list);
    Text command = {0};
    const char *program = getenv("MAGICHOUR");
    text_print(&command,
               "here=$PWD; cd '%s' && DISPLAY=:%d XDG_STATE_HOME=\"$PWD/state\" exec '%s' view %s --progress "
               "json 2>'%s' </dev/null",
               support_path("."), desktop->number, program ? program : "build/magichour", arguments,
               desktop->log_path);
    unlink(desktop->log_path);
    text_free(&desktop->log);
    desktop->news = 0;
    desktop->picture = 0;
    desktop->program = fork();
    if (desktop->program == 0) {
        execl("/bin/sh", "sh", "-c", text_string(&command), (char *)NULL);
        _exit(127);
    }
    text_free(&command);
}

void desktop_start(Desktop *desktop, const char *format, ...) {
    va_list list;
    va_start(list, format);
    start_view(desktop, format, list);
    va_end(list);
}

void desktop_view(Desktop *desktop, const char *format, ...) {
    va_list list;
    va_start(list, format);
    start_view(desktop, format, list);
    va_end(list);
    desktop_expect(desktop, "\"frame\": 3,", "");
}

int desktop_end(Desktop *desktop) {
    int status = 0;
    for (double end = clock_seconds() + patience_s; clock_seconds() < end; pause_ms(10)) {
        if (waitpid(desktop->program, &status, WNOHANG) != desktop->program) continue;
        desktop->program = 0;
        read_log(desktop);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    fail_msg("the window does not close");
    return -1;
}

void desktop_print_last(Desktop *desktop) {
    const char *log = desktop_log(desktop);
    size_t length = strlen(log);
    /* cmocka's own functions cut what is long, and the reason stands last. */
    printf("the window's last words:\n%s\n", log + (length > 4000 ? length - 4000 : 0));
    fflush(stdout);
}

void desktop_quit(Desktop *desktop) {
    desktop_do(desktop, "key Escape");
    int status = desktop_end(desktop);
    /* The leak sanitizer now and then fails to stop the threads of a process that ends, and says so. That is
     * no finding, and all else has been seen by then. */
    if (strstr(desktop_log(desktop), "LeakSanitizer has encountered a fatal error")) status = 0;
    if (status) desktop_print_last(desktop);
    assert_int_equal(status, 0);
    assert_non_null(strstr(desktop_log(desktop), "\"event\": \"end\""));
    assert_null(strstr(desktop_log(desktop), "OpenGL error"));
}

void desktop_signal(Desktop *desktop, int signal) {
    kill(desktop->program, signal);
}

static void run(const Desktop *desktop, const char *format, va_list list) {
    char arguments[32768];
    Text command = {0};
    vsnprintf(arguments, sizeof arguments, format, list);
    text_print(&command, "DISPLAY=:%d xdotool %s >/dev/null", desktop->number, arguments);
    if (system(text_string(&command)) != 0) fail_msg("xdotool %s failed", arguments);
    text_free(&command);
}

void desktop_do(Desktop *desktop, const char *format, ...) {
    va_list list;
    read_log(desktop);
    desktop->news = desktop->log.size;
    desktop->picture = desktop_number(desktop, "picture");
    va_start(list, format);
    run(desktop, format, list);
    va_end(list);
}

void desktop_also(Desktop *desktop, const char *format, ...) {
    va_list list;
    va_start(list, format);
    run(desktop, format, list);
    va_end(list);
}

void desktop_drop(Desktop *desktop, const char *title, const char *path) {
    char command[256];
    unsigned long target = 0;
    snprintf(command, sizeof command, "DISPLAY=:%d xdotool search --name '%s'", desktop->number, title);
    FILE *answer = popen(command, "r");
    if (!answer || fscanf(answer, "%lu", &target) != 1) fail_msg("there is no window %s", title);
    pclose(answer);
    desktop_do(desktop, "mousemove 700 500");
    if (!drop_file(desktop->number, target, 100, 100, path)) fail_msg("%s: the window did not take it", path);
}

static bool line_has(const char *line, size_t length, const char *words) {
    size_t size = strlen(words);
    for (size_t i = 0; i + size <= length; i++) {
        if (strncmp(line + i, words, size) == 0) return true;
    }
    return false;
}

static void show_end(Desktop *desktop, const char *wanted) {
    const char *log = desktop_log(desktop);
    size_t size = strlen(log);
    print_message("waited in vain for '%s' in a log that ends:\n", wanted);
    print_message("%s\n", log + (size > 900 ? size - 900 : 0));
    fail();
}

const char *desktop_expect(Desktop *desktop, const char *words, const char *more_words) {
    static char found[8192];
    for (double end = clock_seconds() + patience_s; clock_seconds() < end; pause_ms(5)) {
        read_log(desktop);
        const char *line = text_string(&desktop->log) + desktop->news;
        for (const char *next; (next = strchr(line, '\n')); line = next + 1) {
            size_t length = (size_t)(next - line);
            if (!line_has(line, length, words) || !line_has(line, length, more_words)) continue;
            snprintf(found, sizeof found, "%.*s", (int)length, line);
            return found;
        }
    }
    show_end(desktop, words);
    return "";
}

/* In a copy of the line: strstr() and sscanf() may look for the text's end, which is far in a long log. */
static bool number_in(const char *line, size_t length, const char *name, double *value) {
    char key[64], copy[2048];
    snprintf(key, sizeof key, "\"%s\": ", name);
    snprintf(copy, sizeof copy, "%.*s", (int)length, line);
    const char *at = strstr(copy, key);
    return at && sscanf(at + strlen(key), "%lf", value) == 1;
}

/* In the last of the lines before `end` that has it. */
static double last_number(const char *log, const char *end, const char *name) {
    double value = -1e300;
    while (end && end > log) {
        const char *line = end;
        while (line > log && line[-1] != '\n') line--;
        if (number_in(line, (size_t)(end - line), name, &value)) break;
        end = line > log ? line - 1 : NULL;
    }
    return value;
}

void desktop_expect_number(Desktop *desktop, const char *name, double low, double high) {
    double value = -1e300;
    for (double end = clock_seconds() + patience_s; clock_seconds() < end; pause_ms(5)) {
        read_log(desktop);
        const char *line = text_string(&desktop->log) + desktop->news;
        for (const char *next; (next = strchr(line, '\n')); line = next + 1) {
            bool found = number_in(line, (size_t)(next - line), name, &value);
            if (found && value >= low && value <= high) return;
        }
    }
    char wanted[128];
    snprintf(wanted, sizeof wanted, "%s from %g to %g, it is %g", name, low, high, value);
    show_end(desktop, wanted);
}

double desktop_expect_pair(Desktop *desktop, const char *name, double low, const char *other, double *value) {
    double found;
    for (double end = clock_seconds() + patience_s; clock_seconds() < end; pause_ms(5)) {
        read_log(desktop);
        const char *line = text_string(&desktop->log) + desktop->news;
        for (const char *next; (next = strchr(line, '\n')); line = next + 1) {
            size_t length = (size_t)(next - line);
            if (number_in(line, length, name, &found) && found >= low &&
                number_in(line, length, other, value))
                return found;
        }
    }
    show_end(desktop, name);
    return 0;
}

/* The window hears events in their order, says which keys it hears, and shows three frames after each. A key
 * without a meaning that is pressed now is therefore heard after what was done before, and three more frames
 * are sure to come, even at rest. The first of these may have the figures of before. */
double desktop_settle(Desktop *desktop) {
    read_log(desktop);
    size_t start = desktop->log.size;
    desktop_also(desktop, "key F12");
    for (double end = clock_seconds() + patience_s; clock_seconds() < end; pause_ms(5)) {
        const char *key = strstr(desktop_log(desktop) + start, "\"key\": 301}\n");
        double frame;
        if (!key) continue;
        frame = last_number(text_string(&desktop->log), key, "frame") + 3;
        desktop_expect_number(desktop, "frame", frame, 1e300);
        return frame;
    }
    show_end(desktop, "the key F12");
    return 0;
}

/* Waits for a line with at least this frame, picture and samples, and at most this coarseness, of a window
 * that rests, if that is asked for: one that the hand has just left draws its picture once more. */
static bool await(Desktop *desktop, double frame, double picture, double coarseness, double samples,
                  bool rests) {
    double got[5];
    for (double end = clock_seconds() + patience_s; clock_seconds() < end; pause_ms(5)) {
        read_log(desktop);
        const char *line = text_string(&desktop->log) + desktop->news;
        for (const char *next; (next = strchr(line, '\n')); line = next + 1) {
            size_t length = (size_t)(next - line);
            if (number_in(line, length, "frame", &got[0]) && got[0] >= frame &&
                number_in(line, length, "picture", &got[1]) && got[1] >= picture &&
                number_in(line, length, "coarseness", &got[2]) && got[2] <= coarseness &&
                number_in(line, length, "samples", &got[3]) && got[3] >= samples &&
                number_in(line, length, "rests", &got[4]) && got[4] >= rests) {
                return true;
            }
        }
    }
    return false;
}

void desktop_expect_samples(Desktop *desktop, double samples) {
    if (!await(desktop, desktop_settle(desktop), 0, 1e300, samples, false)) show_end(desktop, "samples");
}

void desktop_expect_rest(Desktop *desktop, double samples) {
    if (!await(desktop, desktop_settle(desktop), desktop->picture + 1, 1, samples, false))
        show_end(desktop, "a picture at rest");
}

void desktop_expect_done(Desktop *desktop, double samples) {
    if (!await(desktop, desktop_settle(desktop), desktop->picture + 1, 1, samples, true))
        show_end(desktop, "a picture that is done");
}

double desktop_number(Desktop *desktop, const char *name) {
    const char *log = desktop_log(desktop);
    return last_number(log, strrchr(log, '\n'), name);
}

double desktop_largest(Desktop *desktop, const char *name) {
    double largest = -1e300, value;
    const char *line = desktop_log(desktop);
    for (const char *next; (next = strchr(line, '\n')); line = next + 1) {
        if (number_in(line, (size_t)(next - line), name, &value) && value > largest) largest = value;
    }
    return largest;
}

/* An XWD file that the server keeps up to date: a header in 25 big-endian words and more, a colour map, then
 * rows of BGRX. */
static unsigned char *read_screen(int *stride) {
    unsigned char *data = NULL, *header;
    long size = 0;
    FILE *file = fopen(support_path("Xvfb_screen0"), "rb");
    if (!file) fail_msg("the display has no screen");
    fseek(file, 0, SEEK_END);
    size = ftell(file);
    rewind(file);
    header = data = memory_get((size_t)size, 1);
    if (fread(data, 1, (size_t)size, file) != (size_t)size) fail_msg("the screen cannot be read");
    fclose(file);
    unsigned word[25];
    for (int i = 0; i < 25; i++, header += 4)
        word[i] =
            (unsigned)header[0] << 24 | (unsigned)header[1] << 16 | (unsigned)header[2] << 8 | header[3];
    size_t start = word[0] + 12 * (size_t)word[19];
    *stride = (int)word[12];
    memmove(data, data + start, (size_t)size - start);
    return data;
}

void desktop_mean(Desktop *desktop, int x, int y, int width, int height, double rgb[3]) {
    (void)desktop;
    int stride;
    unsigned char *screen = read_screen(&stride);
    rgb[0] = rgb[1] = rgb[2] = 0;
    for (int row = y; row < y + height; row++) {
        for (int column = x; column < x + width; column++) {
            const unsigned char *pixel = screen + row * stride + 4 * column;
            for (int c = 0; c < 3; c++) rgb[c] += pixel[2 - c] / ((double)width * height);
        }
    }
    free(screen);
}

bool desktop_find(Desktop *desktop, const int rgb[3], int from, int *x, int *y) {
    (void)desktop;
    int stride;
    bool found = false;
    unsigned char *screen = read_screen(&stride);
    for (int at = from * stride; at < SCREEN_HEIGHT * stride && !found; at += 4) {
        found = screen[at] == rgb[2] && screen[at + 1] == rgb[1] && screen[at + 2] == rgb[0];
        *x = at % stride / 4;
        *y = at / stride;
    }
    free(screen);
    return found;
}

void desktop_pixel(Desktop *desktop, int x, int y, int rgb[3]) {
    double mean[3];
    desktop_mean(desktop, x, y, 1, 1, mean);
    for (int c = 0; c < 3; c++) rgb[c] = (int)mean[c];
}

const char *desktop_save(Desktop *desktop, const char *extension) {
    char name[64], file[80];
    desktop_do(desktop, "key p");
    const char *line = desktop_expect(desktop, "\"event\": \"save\"", "\"message\": \"\"");
    assert_int_equal(sscanf(strstr(line, "\"name\": "), "\"name\": \"%63[^\"]", name), 1);
    snprintf(file, sizeof file, "%s.%s", name, extension);
    return support_path(file);
}
