#include "export/page.h"

#include "export/embedded.h"
#include "export/page_data.h"

#include <string.h>

/* A title may hold what HTML takes for a tag. */
static void write_words(const char *words, Text *html) {
    for (const char *c = words; *c; c++) {
        if (*c == '<' || *c == '>' || *c == '&' || *c == '"')
            text_print(html, "&#%d;", *c);
        else
            text_append(html, c, 1);
    }
}

/* In a script element the data must not hold a tag, such as the element's own end. In JSON a `<` stands only
 * within strings. */
static void write_data(const Text *lines, Text *html) {
    for (size_t i = 0; i < lines->size; i++) {
        if (lines->data[i] == '<')
            text_print(html, "\\u003c");
        else
            text_append(html, lines->data + i, 1);
    }
}

static void write_script(const SceneFile *file, Text *html) {
    text_print(html, "%s%s%s", embedded_page_draw_js, file->spheres[0] ? embedded_page_spheres_js : "",
               embedded_page_panel_js);
}

static void write_part(const char *name, size_t length, const PageParams *params, const Text *lines,
                       Text *html) {
    const char *title = params->states[0].scene.file->title;
    if (strncmp(name, "TITLE", length) == 0) write_words(*title ? title : "A scene", html);
    if (strncmp(name, "STYLE", length) == 0) text_print(html, "%s", embedded_page_css);
    if (strncmp(name, "SCRIPT", length) == 0) write_script(params->states[0].scene.file, html);
    if (strncmp(name, "DATA", length) == 0) write_data(lines, html);
}

/* The places of the parts are written as @TITLE@ in page.html. */
bool page_write(const PageParams *params, Text *html, Error *error) {
    Text lines = {0};
    bool ok = page_data(params, &lines, error);
    for (const char *at = embedded_page_html; ok && *at;) {
        size_t plain = strcspn(at, "@");
        text_append(html, at, plain);
        at += plain;
        if (!*at) break;
        size_t length = strcspn(at + 1, "@");
        write_part(at + 1, length, params, &lines, html);
        at += length + 2;
    }
    text_free(&lines);
    return ok;
}
