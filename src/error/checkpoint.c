#include "error/checkpoint.h"

#include "base/file.h"
#include "base/memory.h"
#include "render/identity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char any_version[] = "magichour checkpoint ", driver_line[] = "driver ";

enum { NUMBERS = 2 * sizeof(uint64_t) };

static bool archive_all(Checkpoint *checkpoint, Archive *archive, Error *error) {
    ARCHIVE(archive, checkpoint->seconds);
    adaptive_archive(checkpoint->adaptive, archive);
    return renderer_archive(checkpoint->renderer, archive, error) &&
           aov_archive(checkpoint->aov, archive, error);
}

/* PATH.old, to be freed. */
static char *older_path(const char *path) {
    char *older = memory_get(strlen(path) + 5, 1);
    sprintf(older, "%s.old", path);
    return older;
}

/* Gives the file a second name, so that it outlives its replacement. There is a file at `path` at all times.
 */
static void keep_older(const char *path) {
    char *older = older_path(path), *target = realpath(path, NULL);
    if (target) {
        unlink(older);
        /* Where there are no hard links, there is no older checkpoint. */
        if (link(target, older) != 0) unlink(older);
    }
    free(target);
    free(older);
}

/* The checksum of the lines, the size and the state. */
static uint64_t sum_of(const char *file, size_t head, const char *state, size_t size) {
    uint64_t sums[2] = {checksum(file, head + sizeof(uint64_t)), checksum(state, size)};
    return checksum(sums, sizeof sums);
}

bool checkpoint_write(const char *path, Checkpoint *checkpoint, Error *error) {
    Text file = {0};
    text_print(&file, "%s%s%s%s\n\n%s\n", CHECKPOINT_MAGIC, checkpoint->about, driver_line,
               checkpoint->driver, checkpoint->identity);
    size_t head = file.size;
    uint64_t numbers[2] = {0};
    text_append(&file, numbers, sizeof numbers);
    Archive archive = {.out = &file};
    bool ok = archive_all(checkpoint, &archive, error);
    if (ok) {
        numbers[0] = file.size - head - NUMBERS;
        memcpy(file.data + head, numbers, sizeof numbers);
        numbers[1] = sum_of(file.data, head, file.data + head + NUMBERS, numbers[0]);
        memcpy(file.data + head, numbers, sizeof numbers);
        keep_older(path);
        ok = file_replace(path, file.data, file.size, error);
    }
    text_free(&file);
    return ok;
}

bool checkpoint_is_one(const Text *file) {
    size_t length = strlen(any_version);
    return file->size >= length && memcmp(file->data, any_version, length) == 0;
}

static bool read_file(const char *path, Text *file, Error *error) {
    FileBounds bounds = {.status = STATUS_FAILURE, .most = CHECKPOINT_MOST, .begins_well = checkpoint_is_one};
    return file_read_within(path, &bounds, file, error);
}

/* The parts of a whole checkpoint; they point into the file. */
typedef struct Parts {
    const char *about, *identity, *state;
    size_t about_size, identity_size, state_size;
} Parts;

/* The place behind the next empty line, or NULL. */
static const char *after_empty_line(const char *at, const char *end) {
    for (; at + 1 < end; at++) {
        if (at[0] == '\n' && at[1] == '\n') return at + 2;
    }
    return NULL;
}

/* Cuts a file into its parts. Returns what is wrong with it, or NULL. */
static const char *cut(const Text *file, Parts *parts) {
    static const char magic[] = CHECKPOINT_MAGIC;
    if (!checkpoint_is_one(file)) return "this is no checkpoint";
    if (file->size < strlen(magic) || memcmp(file->data, magic, strlen(magic)) != 0)
        return "this checkpoint is of another version of magichour";
    const char *end = file->data + file->size;
    parts->about = file->data + strlen(magic);
    parts->identity = after_empty_line(parts->about, end);
    parts->state = parts->identity ? after_empty_line(parts->identity, end) : NULL;
    if (!parts->state || (size_t)(end - parts->state) < NUMBERS) return "this checkpoint is cut off";
    uint64_t numbers[2];
    size_t head = (size_t)(parts->state - file->data);
    memcpy(numbers, parts->state, sizeof numbers);
    parts->about_size = (size_t)(parts->identity - parts->about) - 1;
    parts->identity_size = (size_t)(parts->state - parts->identity) - 1;
    parts->state += NUMBERS;
    parts->state_size = (size_t)(end - parts->state);
    if (numbers[0] > parts->state_size) return "this checkpoint is cut off";
    if (numbers[0] != parts->state_size ||
        numbers[1] != sum_of(file->data, head, parts->state, parts->state_size))
        return "this checkpoint is damaged";
    return NULL;
}

/* Says what is wrong, and whether the checkpoint before is whole. */
static bool broken(const char *path, const char *why, Error *error) {
    char *older = older_path(path);
    Text file = {0};
    Parts parts;
    Error ignored;
    bool whole = access(older, F_OK) == 0 && read_file(older, &file, &ignored) && !cut(&file, &parts);
    error_set(error, STATUS_FAILURE, "%s: %s%s%s", path, why,
              whole ? "; the one before it is whole: --resume " : "", whole ? older : "");
    text_free(&file);
    free(older);
    return false;
}

bool checkpoint_lines(const char *path, const Text *file, Text *lines, Error *error) {
    Parts parts;
    const char *wrong = cut(file, &parts);
    if (wrong) return broken(path, wrong, error);
    text_append(lines, parts.about, parts.about_size);
    text_append(lines, parts.identity, parts.identity_size);
    return true;
}

/* The driver's name, which is the last line about the picture. To be freed. */
static char *driver_of(const Parts *parts) {
    const char *end = parts->about + parts->about_size - 1, *at = end;
    while (at > parts->about && at[-1] != '\n') at--;
    size_t length = (size_t)(end - at), skip = strlen(driver_line);
    return length > skip ? memory_string_part(at + skip, length - skip) : memory_string("");
}

static bool load(const char *path, const Parts *parts, Checkpoint *checkpoint, Error *error) {
    Archive archive = {.at = parts->state, .end = parts->state + parts->state_size};
    if (!archive_all(checkpoint, &archive, error)) return false;
    if (!archive.torn && archive.at == archive.end) return true;
    return error_set(error, STATUS_FAILURE, "%s: this checkpoint's state has another size than its picture",
                     path);
}

bool checkpoint_read(const char *path, Checkpoint *checkpoint, char **other_driver, Error *error) {
    Text file = {0}, before = {0}, difference = {0};
    Parts parts;
    *other_driver = NULL;
    if (!read_file(path, &file, error)) return false;
    const char *wrong = cut(&file, &parts);
    bool ok = !wrong || broken(path, wrong, error);
    if (ok) {
        text_append(&before, parts.identity, parts.identity_size);
        ok = identity_same(text_string(&before), checkpoint->identity, &difference) ||
             error_set(error, STATUS_FAILURE, "%s: this checkpoint is of another picture: %s", path,
                       text_string(&difference));
    }
    ok = ok && load(path, &parts, checkpoint, error);
    if (ok) {
        char *driver = driver_of(&parts);
        bool same = strcmp(driver, checkpoint->driver) == 0;
        if (!same) *other_driver = driver;
        if (same) free(driver);
    }
    text_free(&file);
    text_free(&before);
    text_free(&difference);
    return ok;
}
