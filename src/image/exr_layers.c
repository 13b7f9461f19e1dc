#include "image/exr_layers.h"

#include "base/memory.h"
#include "image/exr_stream.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

typedef struct LayerList {
    ExrLayer *items;
    int count;
    /* The parts' names; "" in a file of one part. They belong to the file. */
    const char **parts;
    int part_count;
} LayerList;

/* The channel of that name in the layer, whose name has `length` bytes with the dot; -1 if there is none. */
static int channel_find(const exr_attr_chlist_t *channels, const char *layer, int length, const char *name) {
    int name_length = (int)strlen(name);
    for (int i = 0; i < channels->num_channels; i++) {
        const exr_attr_string_t *found = &channels->entries[i].name;
        if (found->length == length + name_length && memcmp(found->str, layer, (size_t)length) == 0 &&
            memcmp(found->str + length, name, (size_t)name_length) == 0)
            return i;
    }
    return -1;
}

static bool has_letters(const exr_attr_chlist_t *channels, const char *layer, int length, const char *letters,
                        int found[4]) {
    for (int c = 0; c < 3; c++) {
        found[c] = channel_find(channels, layer, length, (char[]){letters[c], 0});
        if (found[c] < 0) return false;
    }
    return true;
}

/* The layer that the channel begins. False if it is a further channel of a layer that another one begins. */
static bool layer_of_channel(const exr_attr_chlist_t *channels, int channel, ExrLayer *layer) {
    const char *name = channels->entries[channel].name.str;
    const char *dot = strrchr(name, '.');
    const char *letter = dot ? dot + 1 : name;
    int length = (int)(letter - name), rgb[4], xyz[4];
    bool has_rgb = has_letters(channels, name, length, "RGB", rgb);
    bool has_xyz = has_letters(channels, name, length, "XYZ", xyz);
    bool has_y = channel_find(channels, name, length, "Y") >= 0;
    bool alone = strlen(letter) != 1;
    *layer = (ExrLayer){.plain = !length, .kind = EXR_KIND_GREY, .channels = {channel, channel, channel, -1}};
    snprintf(layer->name, sizeof layer->name, "%.*s", length ? length - 1 : 0, name);
    if (!alone && has_rgb && strchr("RGBA", *letter)) {
        layer->kind = EXR_KIND_RGB;
        memcpy(layer->channels, rgb, sizeof rgb[0] * 3);
        layer->channels[3] = channel_find(channels, name, length, "A");
        return *letter == 'R';
    }
    if (!alone && has_xyz && strchr("XYZ", *letter)) {
        layer->kind = EXR_KIND_XYZ;
        memcpy(layer->channels, xyz, sizeof xyz[0] * 3);
        return *letter == 'X';
    }
    if (!alone && *letter == 'Y') {
        layer->channels[3] = has_rgb ? -1 : channel_find(channels, name, length, "A");
        return true;
    }
    if (!alone && *letter == 'A' && (has_xyz || has_y)) return false;
    /* A channel of its own, such as "Z" or "crypto.id". */
    snprintf(layer->name, sizeof layer->name, "%s", name);
    layer->plain = false;
    return true;
}

static exr_result_t list_fill(exr_context_t file, LayerList *list) {
    exr_result_t result = exr_get_count(file, &list->part_count);
    if (!result) list->parts = memory_get((size_t)list->part_count, sizeof *list->parts);
    for (int part = 0; !result && part < list->part_count; part++) {
        const exr_attr_chlist_t *channels = NULL;
        list->parts[part] = "";
        if (list->part_count > 1) result = exr_get_name(file, part, &list->parts[part]);
        if (!result) result = exr_get_channels(file, part, &channels);
        for (int i = 0; !result && i < channels->num_channels; i++) {
            ExrLayer layer;
            if (!layer_of_channel(channels, i, &layer)) continue;
            layer.part = part;
            if (layer.plain) snprintf(layer.name, sizeof layer.name, "%s", list->parts[part]);
            list->items = memory_grow(list->items, (size_t)list->count + 1, sizeof *list->items);
            list->items[list->count++] = layer;
        }
    }
    return result;
}

static int count_named(const LayerList *list, const char *name) {
    int count = 0;
    for (int i = 0; i < list->count; i++) count += strcmp(list->items[i].name, name) == 0;
    return count;
}

/* Puts the part's name in front of names that are there twice. */
static void names_part(LayerList *list) {
    bool *twice = memory_get((size_t)list->count, sizeof *twice);
    for (int i = 0; i < list->count; i++) twice[i] = count_named(list, list->items[i].name) > 1;
    for (int i = 0; i < list->count; i++) {
        ExrLayer *layer = &list->items[i];
        if (!twice[i] || layer->plain) continue;
        char name[sizeof layer->name];
        snprintf(name, sizeof name, "%.255s.%.255s", list->parts[layer->part], layer->name);
        memcpy(layer->name, name, sizeof name);
    }
    free(twice);
}

static bool is_main(const ExrLayer *layer) {
    static const char *const names[] = {"rgba", "beauty", "combined"};
    const char *dot = strrchr(layer->name, '.'), *word = dot ? dot + 1 : layer->name;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if (strcasecmp(word, names[i]) == 0) return true;
    }
    return false;
}

static bool is_plain_rgb(const ExrLayer *layer) {
    return layer->plain && layer->kind == EXR_KIND_RGB;
}

static bool is_main_plain_rgb(const ExrLayer *layer) {
    return is_plain_rgb(layer) && is_main(layer);
}

static bool is_main_rgb(const ExrLayer *layer) {
    return layer->kind == EXR_KIND_RGB && is_main(layer);
}

static bool is_rgb(const ExrLayer *layer) {
    return layer->kind == EXR_KIND_RGB;
}

static bool is_plain(const ExrLayer *layer) {
    return layer->plain;
}

static const ExrLayer *the_only(const LayerList *list, bool (*suits)(const ExrLayer *layer)) {
    const ExrLayer *found = NULL;
    for (int i = 0; i < list->count; i++) {
        if (!suits(&list->items[i])) continue;
        if (found) return NULL;
        found = &list->items[i];
    }
    return found;
}

static const ExrLayer *layer_default(const LayerList *list) {
    static bool (*const rules[])(const ExrLayer *) = {is_plain_rgb, is_main_plain_rgb, is_main_rgb, is_rgb,
                                                      is_plain};
    const ExrLayer *found = NULL;
    for (size_t i = 0; !found && i < sizeof rules / sizeof *rules; i++) found = the_only(list, rules[i]);
    return found;
}

static const ExrLayer *layer_named(const LayerList *list, const char *name) {
    for (int i = 0; i < list->count; i++) {
        if (strcmp(list->items[i].name, name) == 0) return &list->items[i];
    }
    return NULL;
}

static bool list_error(const LayerList *list, const char *name, const char *path, Error *error) {
    static const char *const kinds[] = {"R, G, B", "X, Y, Z", "one channel"};
    Text text = {0};
    for (int i = 0; i < list->count; i++)
        text_print(&text, "%s '%s' (%s)", i ? "," : "", list->items[i].name, kinds[list->items[i].kind]);
    if (text.data) exr_line_clean(text.data);
    const char *layers = text.size ? text_string(&text) : " none";
    if (name)
        error_set(error, STATUS_FAILURE, "%s: no layer '%s'; its layers:%s", path, name, layers);
    else
        error_set(error, STATUS_FAILURE,
                  "%s: no layer is clearly the picture, so --layer has to name one: %s", path, layers + 1);
    text_free(&text);
    return false;
}

/* Colours whose light is in Y and whose differences are in RY and BY. */
static bool has_differences(exr_context_t file, int part) {
    const exr_attr_chlist_t *channels = NULL;
    return !exr_get_channels(file, part, &channels) &&
           (channel_find(channels, "", 0, "RY") >= 0 || channel_find(channels, "", 0, "BY") >= 0);
}

static void choice_say(const LayerList *list, const ExrLayer *layer, Text *said) {
    if (list->count > 1 && *layer->name) {
        size_t start = said->size;
        text_print(said, "layer '%s' of %d", layer->name, list->count);
        exr_line_clean(said->data + start);
        text_print(said, "\n");
    }
    if (layer->kind == EXR_KIND_XYZ)
        text_print(said, "%s\n",
                   layer->plain ? "X, Y, Z converted to linear sRGB (D65)"
                                : "X, Y, Z taken as red, green, blue");
}

bool exr_layer_find(exr_context_t file, const char *name, const char *path, ExrLayer *layer, Text *said,
                    Error *error) {
    LayerList list = {0};
    exr_result_t result = list_fill(file, &list);
    bool found = false;
    if (result) {
        exr_broken(result, path, error);
    } else {
        names_part(&list);
        const ExrLayer *chosen = name ? layer_named(&list, name) : layer_default(&list);
        if (!chosen) {
            list_error(&list, name, path, error);
        } else if (chosen->plain && chosen->kind == EXR_KIND_GREY && has_differences(file, chosen->part)) {
            error_set(
                error, STATUS_FAILURE,
                "%s: EXR of Y, RY and BY (light and differences of colour) cannot be read: convert it to "
                "R, G, B",
                path);
        } else {
            *layer = *chosen;
            if (said) choice_say(&list, layer, said);
            found = true;
        }
    }
    free(list.items);
    free(list.parts);
    return found;
}
