/* What the last word of an unfinished command line may become. The scripts of cmd/completion_scripts.c ask
 * for it with `magichour --complete WORD...`, so that they need not know a single option. */
#pragma once

#include "base/text.h"

#define COMPLETE_WORD "--complete"

/* Prints a line for each word that the last of `words` may become, and behind a tab what it means if that is
 * known. A line that begins with ":" says what else the word may be:
 *
 *     :files     the path of a file, behind a "=" if the word has one
 *     :folders   the same of a folder
 *
 * `words` are those behind the program's name, the last one as far as it is typed: "" if nothing is. */
void complete_print(int count, char *const *words, Text *out);
