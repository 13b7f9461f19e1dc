/* Questions about a GLSL text, answered by its words: comments and what `#if 0` leaves out do not count. */
#pragma once

#include <stdbool.h>

/* A copy of the text in which only what counts is left. */
typedef struct GlslScan {
    char *code;
} GlslScan;

GlslScan glsl_scan(const char *text);
void glsl_scan_free(GlslScan *scan);

/* Whether the text defines a function of that name, and how often it calls (or declares) one. */
bool glsl_scan_defines(const GlslScan *scan, const char *function);
int glsl_scan_calls(const GlslScan *scan, const char *function);

/* The line of the text on which the function is defined, from 1; 0 where it is not. */
int glsl_scan_definition_line(const GlslScan *scan, const char *function);

/* Finds `const int NAME = VALUE;`: gives its line, 0 where there is none, and the value, which is -1 where it
 * is anything but a whole number in digits. */
int glsl_scan_constant(const GlslScan *scan, const char *name, int *value);

/* Whether the text has this identifier, and whether it declares it with this type, as "float iTime". */
bool glsl_scan_mentions(const GlslScan *scan, const char *name);
bool glsl_scan_declares(const GlslScan *scan, const char *type, const char *name);
