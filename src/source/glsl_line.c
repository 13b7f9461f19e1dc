#include "source/glsl_line.h"

#include <ctype.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

static const char word[] = "#line ";

static bool number_read(const char **at, int *number) {
    if (!isdigit((unsigned char)**at)) return false;
    char *end;
    long value = strtol(*at, &end, 10);
    *number = value < INT_MAX ? (int)value : INT_MAX;
    *at = end;
    return true;
}

bool glsl_line_read(const char *at, int *line, int *file) {
    int numbers[2];
    if (strncmp(at, word, sizeof word - 1) != 0) return false;
    at += sizeof word - 1;
    if (!number_read(&at, &numbers[0])) return false;
    at += strspn(at, " ");
    if (!number_read(&at, &numbers[1])) return false;
    *line = numbers[0];
    *file = numbers[1];
    return true;
}
