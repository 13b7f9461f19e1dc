/* What the help and the manual page say alike. */
#pragma once

#include "cmd/option_table.h"

typedef struct HelpStatus {
    Status status;
    const char *meaning;
} HelpStatus;

/* The program in a few words. */
extern const char help_about[];

/* The exit statuses; NULL past the end. */
const HelpStatus *help_status(int index);

/* Writes such as "--size WxH", "--sun-disk[=METHOD]" or "-h, --help". */
void help_option_words(const OptionRow *row, char *words, size_t size);

/* Appends what an option does. For an option that takes a method it adds the methods and what auto chooses.
 */
void help_option_text(const OptionRow *row, Text *out);
