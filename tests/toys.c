#include "toys.h"

#include "base/file.h"
#include "image/tone.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static const char folder[] = "tests/data/toys";

const char *toys_next(void) {
    static struct dirent **entries;
    static int count, at;
    static char path[300];
    if (!entries) count = scandir(folder, &entries, NULL, alphasort), at = 0;
    for (; at < count; at++) {
        if (!strstr(entries[at]->d_name, ".glsl")) continue;
        snprintf(path, sizeof path, "%s/%s", folder, entries[at++]->d_name);
        return path;
    }
    for (int i = 0; i < count; i++) free(entries[i]);
    free(entries);
    entries = NULL;
    return NULL;
}

bool toys_line(const char *path, const char *kind, int number, char *words, size_t size) {
    Text text = {0};
    Error error;
    char mark[40];
    bool found = false;
    snprintf(mark, sizeof mark, "// %s ", kind);
    if (!file_read(path, STATUS_FAILURE, &text, &error)) fail_msg("%s", error.text);
    for (const char *at = text_string(&text); !found && (at = strstr(at, mark)); at++) {
        if (number-- > 0) continue;
        snprintf(words, size, "%.*s", (int)strcspn(at + strlen(mark), "\n"), at + strlen(mark));
        found = true;
    }
    text_free(&text);
    return found;
}

int toys_check(const char *path, const Image *image) {
    char words[300];
    int count = 0;
    for (; toys_line(path, "expect", count, words, sizeof words); count++) {
        int x, y, wanted[3];
        if (sscanf(words, "%d %d: %d %d %d", &x, &y, &wanted[0], &wanted[1], &wanted[2]) != 5)
            fail_msg("%s: expect %s", path, words);
        const float *rgb = image->rgba + 4 * ((image->height - 1 - y) * image->width + x);
        for (int c = 0; c < 3; c++) {
            double level = tone_level(image->shown ? TONE_NONE : TONE_SCREEN, 1, (double)rgb[c]);
            if (fabs(level - wanted[c]) > 1.01)
                fail_msg("%s: pixel %d %d, channel %d: %g, not %d", path, x, y, c, level, wanted[c]);
        }
    }
    return count;
}

/* The driver keeps what it has compiled, so that the text is another one in each run. */
static void print_slow(Text *text) {
    static int serial;
    long number = (long)time(NULL) % 100000 + 100000L * (getpid() % 1000) + ++serial;
    text_print(text, "float slow(vec3 p) {\n    float d = 1e9;\n");
    for (int i = 0; i < 120; i++) {
        text_print(text,
                   "    d = min(d, length(p - vec3(sin(%d.%ld + p.y), cos(%d.7 * p.z), 0.1)) - 0.1 * "
                   "abs(sin(p.x * %d.1) + pow(abs(p.z), %d.5)));\n",
                   i, number, i, i, i % 7);
    }
    text_print(text,
               "    return d;\n}\nfloat slower(vec3 p) { return slow(p.zxy + slow(p.yzx + slow(p))); }\n");
}

static const char *write_slow(const char *name, const char *before, const char *after) {
    Text text = {0};
    text_print(&text, "%s", before);
    print_slow(&text);
    text_print(&text, "%s", after);
    const char *path = support_write(name, text_string(&text));
    text_free(&text);
    return path;
}

const char *toys_write_slow(const char *name) {
    return write_slow(name, "",
                      "void mainImage(out vec4 c, in vec2 p) {\n"
                      "    c = vec4(slower(vec3(p, iTime)) > 0.0 ? 0.2 : 0.4, 0.6, 0.0, 1.0);\n}\n");
}

const char *toys_write_slow_scene(const char *name) {
    return write_slow(name, "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n",
                      "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                      "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n}\n"
                      "Material scene_material(Hit hit) {\n"
                      "    return matte(vec3(slower(hit.position) > 0.0 ? 0.2 : 0.4));\n}\n");
}
