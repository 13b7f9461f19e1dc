#include "base/json.h"

#include <inttypes.h>
#include <math.h>

Json json_begin(void) {
    Json json = {0};
    text_print(&json.line, "{");
    return json;
}

static void print_string(Text *line, const char *value) {
    text_append(line, "\"", 1);
    for (const char *c = value; *c; c++) {
        if (*c == '"' || *c == '\\')
            text_print(line, "\\%c", *c);
        else if (*c == '\n')
            text_print(line, "\\n");
        else if ((unsigned char)*c < 0x20)
            text_print(line, "\\u%04x", (unsigned)*c);
        else
            text_append(line, c, 1);
    }
    text_append(line, "\"", 1);
}

static void print_name(Json *json, const char *name) {
    if (json->line.size > 1) text_print(&json->line, ", ");
    print_string(&json->line, name);
    text_print(&json->line, ": ");
}

static void print_number(Text *line, double value) {
    if (isfinite(value))
        text_print(line, "%.9g", value);
    else
        text_print(line, "null");
}

void json_number(Json *json, const char *name, double value) {
    print_name(json, name);
    print_number(&json->line, value);
}

void json_numbers(Json *json, const char *name, const double *values, int count) {
    print_name(json, name);
    text_print(&json->line, "[");
    for (int i = 0; i < count; i++) {
        if (i) text_print(&json->line, ", ");
        print_number(&json->line, values[i]);
    }
    text_print(&json->line, "]");
}

void json_seconds(Json *json, const char *name, double seconds) {
    print_name(json, name);
    text_print(&json->line, "%.6f", seconds);
}

void json_count(Json *json, const char *name, uint64_t count) {
    print_name(json, name);
    text_print(&json->line, "%" PRIu64, count);
}

void json_flag(Json *json, const char *name, bool value) {
    print_name(json, name);
    text_print(&json->line, value ? "true" : "false");
}

void json_text(Json *json, const char *name, const char *value) {
    print_name(json, name);
    print_string(&json->line, value);
}

void json_end(Json *json, FILE *file) {
    text_print(&json->line, "}\n");
    fwrite(json->line.data, 1, json->line.size, file);
    fflush(file);
    text_free(&json->line);
}
