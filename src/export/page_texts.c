#include "export/page_texts.h"

#include "base/json.h"
#include "base/memory.h"
#include "export/es.h"

#include <stdlib.h>
#include <string.h>

int page_list_add(PageList *list, const char *text) {
    for (int i = 0; i < list->count; i++)
        if (strcmp(list->items[i], text) == 0) return i;
    list->items = memory_grow(list->items, (size_t)list->count + 1, sizeof *list->items);
    list->items[list->count] = memory_string(text);
    return list->count++;
}

void page_list_free(PageList *list) {
    for (int i = 0; i < list->count; i++) free(list->items[i]);
    free(list->items);
    *list = (PageList){0};
}

/* The text is cut where another file begins or goes on. */
int page_texts_add(PageTexts *texts, const GlslSource *source) {
    Text numbers = {0};
    EsReader reader = es_begin(source);
    for (Text piece = {0}; es_piece(&reader, &piece); text_free(&piece))
        text_print(&numbers, "%s%d", numbers.size ? " " : "",
                   page_list_add(&texts->pieces, text_string(&piece)));
    es_end(&reader);
    int number = page_list_add(&texts->shaders, text_string(&numbers));
    text_free(&numbers);
    return number;
}

static void write(const PageList *list, const char *name, FILE *file) {
    for (int i = 0; i < list->count; i++) {
        Json json = json_begin();
        json_text(&json, name, list->items[i]);
        json_end(&json, file);
    }
}

void page_texts_write(const PageTexts *texts, FILE *file) {
    write(&texts->pieces, "piece", file);
    write(&texts->shaders, "shader", file);
}

void page_texts_free(PageTexts *texts) {
    page_list_free(&texts->pieces);
    page_list_free(&texts->shaders);
}
