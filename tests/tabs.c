#include "tabs.h"

#include "support.h"

#include "base/file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void tabs_need_gl(void) {
    Context context;
    support_open(&context);
    context_close(&context);
}

Text tabs_read_file(const char *path) {
    Text text = {0};
    Error error;
    if (!file_read(path, STATUS_FAILURE, &text, &error)) fail_msg("%s", error.text);
    return text;
}

Text tabs_read(const char *folder, const char *tab) {
    char path[600];
    snprintf(path, sizeof path, "%s/%s", folder, tab);
    return tabs_read_file(path);
}

void tabs_expect(const char *folder, const char *tab, const char *words) {
    Text text = tabs_read(folder, tab);
    if (!strstr(text_string(&text), words)) fail_msg("%s/%s: no '%s'", folder, tab, words);
    text_free(&text);
}

static const char es_head[] = "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                              "precision highp sampler2D;\n";
static const char tab_head[] = "#define HW_PERFORMANCE 1\nuniform vec3 iResolution;\nuniform float "
                               "iTime;\nuniform float iChannelTime[4];\n"
                               "uniform vec4 iMouse;\nuniform vec4 iDate;\nuniform float "
                               "iSampleRate;\nuniform vec3 iChannelResolution[4];\n"
                               "uniform int iFrame;\nuniform float iTimeDelta;\nuniform float "
                               "iFrameRate;\nuniform sampler2D iChannel0;\n"
                               "void mainImage(out vec4 c, in vec2 f);\n";
static const char tab_tail[] =
    "\nout vec4 shadertoy_out_color;\nvoid main() {\n    vec4 color = vec4(1e20);\n"
    "    mainImage(color, gl_FragCoord.xy);\n    shadertoy_out_color = color;\n}\n";

/* The site compiles Common alone too, and then without the inputs of the others. */
static void compile(const char *folder, const char *tab) {
    Text common = tabs_read(folder, "common.glsl"), own = {0}, whole = {0};
    char command[1200];
    if (tab) own = tabs_read(folder, tab);
    text_print(&whole, "%s%s%s\n%s%s", es_head,
               tab ? tab_head
                   : "uniform vec4 iDate;\nuniform float iSampleRate;\nout vec4 outColor;\n"
                     "void main() { outColor = vec4(0.0); }\n",
               text_string(&common), text_string(&own), tab ? tab_tail : "");
    const char *path = support_write("tab.frag", text_string(&whole));
    snprintf(command, sizeof command, "glslangValidator '%s' > '%s'", path, support_path("log"));
    if (system(command) != 0) {
        Text log = tabs_read_file(support_path("log"));
        fail_msg("%s, %s: %.600s", folder, tab ? tab : "Common alone", text_string(&log));
    }
    text_free(&common);
    text_free(&own);
    text_free(&whole);
}

static bool has_glslang(void) {
    static int has = -1;
    if (has < 0) {
        has = system("command -v glslangValidator > /dev/null") == 0;
        if (!has) printf("glslangValidator is not there: the texts are not compiled\n");
    }
    return has > 0;
}

void tabs_compile(const char *folder) {
    if (!has_glslang()) return;
    compile(folder, NULL);
    compile(folder, "buffer-a.glsl");
    compile(folder, "image.glsl");
}

size_t tabs_common_size(const char *folder) {
    Text text = tabs_read(folder, "common.glsl");
    size_t size = text.size;
    assert_null(strstr(text_string(&text), "\nuniform "));
    assert_null(strstr(text_string(&text), "#version"));
    assert_null(strstr(text_string(&text), "#line"));
    text_free(&text);
    return size;
}

double tabs_difference(const Image *a, const Image *b) {
    assert_true(a->width == b->width && a->height == b->height);
    size_t corner = (size_t)(a->height - 1) * (size_t)a->width, count = 0;
    double squares = 0, sum = 0;
    for (size_t i = 0; i < (size_t)a->width * (size_t)a->height; i++) {
        for (int c = 0; c < 3 && i != corner; c++, count++) {
            double d = (double)a->rgba[4 * i + (size_t)c] - (double)b->rgba[4 * i + (size_t)c];
            squares += d * d;
            sum += (double)b->rgba[4 * i + (size_t)c];
        }
    }
    return 100 * sqrt(squares / (double)count) / (sum / (double)count);
}

Image tabs_picture(const char *name) {
    Image image;
    Error error;
    if (!image_read(&image, support_path(name), &error)) fail_msg("%s", error.text);
    return image;
}

double tabs_round_trip(const char *scene, const char *options, const char *size, int samples) {
    const char *folder = support_path("trip");
    support_expect(0, "", "export %s --shadertoy -o '%s' %s", scene, folder, options);
    support_expect(0, "", "render '%s/buffer-a.glsl' --size %s --frames %d -o '%s'", folder, size, samples,
                   support_path("toy.exr"));
    support_expect(0, "", "render '%s' --size %s --frames %d -o '%s'", folder, size, samples,
                   support_path("toy.png"));
    support_expect(0, "", "render %s --light cosine --sky gauss:6 %s --size %s --spp %d -o '%s' -o '%s'",
                   scene, options, size, samples, support_path("own.exr"), support_path("own.png"));
    Image toy = tabs_picture("toy.exr"), own = tabs_picture("own.exr"), shown = tabs_picture("toy.png"),
          wanted = tabs_picture("own.png");
    double apart = tabs_difference(&toy, &own);
    size_t pixels = (size_t)own.width * (size_t)own.height, other = 0;
    for (size_t i = 0; i < pixels; i++) {
        for (size_t c = 0; c < 3; c++) other += shown.rgba[4 * i + c] != wanted.rgba[4 * i + c];
    }
    printf("%s: relRMSE %.5f %%, %zu of %zu bytes shown differ\n", scene, apart, other, 3 * pixels);
    /* The pixel in the corner shows its neighbour. */
    assert_true((double)other <= 3 + 0.01 * 3 * (double)pixels);
    image_free(&toy);
    image_free(&own);
    image_free(&shown);
    image_free(&wanted);
    return apart;
}
