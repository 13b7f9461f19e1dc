/* The shaders of a page. Their texts have most of the library's files in common, so that a page holds pieces
 * of files, each once, and for each shader the list of its pieces. */
#pragma once

#include "source/glsl_source.h"

#include <stdio.h>

/* A growing list of texts, each once. A zeroed list is empty. */
typedef struct PageList {
    char **items;
    int count;
} PageList;

/* The number of the text in the list, which is added if it is new. */
int page_list_add(PageList *list, const char *text);
void page_list_free(PageList *list);

typedef struct PageTexts {
    PageList pieces;
    /* Numbers of pieces, with blanks between. */
    PageList shaders;
} PageTexts;

/* The number of the shader for WebGL 2, which is added if it is new. */
int page_texts_add(PageTexts *texts, const GlslSource *source);

/* Appends a line of JSON for each: {"piece": "..."} and {"shader": "0 1 5"}, in the order of their numbers.
 */
void page_texts_write(const PageTexts *texts, FILE *file);
void page_texts_free(PageTexts *texts);
