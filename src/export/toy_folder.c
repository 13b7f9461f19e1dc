#include "export/toy_folder.h"

#include "base/file.h"
#include "base/version.h"
#include "export/toy_settings.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { TABS = 3 };

static const char *const names[TABS] = {"common.glsl", "buffer-a.glsl", "image.glsl"};

void toy_texts_free(ToyTexts *texts) {
    text_free(&texts->common);
    text_free(&texts->buffer);
    text_free(&texts->image);
}

static void put_in_front(Text *text, const Text *head) {
    Text whole = {0};
    text_print(&whole, "%s\n%s", text_string(head), text_string(text));
    text_free(text);
    *text = whole;
}

static const char *title_of(const SceneFile *file) {
    const char *slash = strrchr(file->path, '/');
    return file->title[0] ? file->title : slash ? slash + 1 : file->path;
}

static void head_of(int tab, const SceneFile *file, const char *command, Text *head) {
    static const char *const tabs[TABS] = {"Common", "Buffer A", "Image"};
    text_print(head, "// ");
    toy_settings_comment(title_of(file), head);
    text_print(head, ": the tab %s of a program for Shadertoy, %d of %d.\n", tabs[tab], tab + 1, TABS);
    text_print(head, "// Made by: ");
    toy_settings_comment(command, head);
    text_print(head, "\n// (magichour %s)\n//\n", MAGICHOUR_VERSION);
}

void toy_folder_head(ToyTexts *texts, const SceneFile *file, const char *command) {
    Text head = {0};
    head_of(0, file, command, &head);
    text_print(
        &head,
        "// In a new program of shadertoy.com add the tabs Common and Buffer A with the + beside Image. "
        "Paste this text into\n// Common, buffer-a.glsl into Buffer A, and image.glsl into Image. Set "
        "iChannel0 of Buffer A and iChannel0 of Image to Buffer A.\n// Each frame adds samples to the "
        "picture.\n");
    put_in_front(&texts->common, &head);
    text_free(&head);
    head_of(1, file, command, &head);
    text_print(&head, "// Set iChannel0 to Buffer A itself: it is the frame before.\n");
    put_in_front(&texts->buffer, &head);
    text_free(&head);
    head_of(2, file, command, &head);
    text_print(&head, "// Set iChannel0 to Buffer A.\n");
    put_in_front(&texts->image, &head);
    text_free(&head);
}

static bool make_folder(const char *folder, bool *made, Error *error) {
    struct stat found;
    *made = mkdir(folder, 0777) == 0;
    if (*made || (errno == EEXIST && stat(folder, &found) == 0 && S_ISDIR(found.st_mode))) return true;
    return error_set(error, STATUS_OUTPUT, "%s: no folder can be made there: %s", folder,
                     errno == EEXIST ? "it is a file" : strerror(errno));
}

static void path_of(const char *folder, int tab, Text *path) {
    text_free(path);
    text_print(path, "%s/%s", folder, names[tab]);
}

bool toy_folder_write(const ToyTexts *texts, const char *folder, Error *error) {
    const Text *all[TABS] = {&texts->common, &texts->buffer, &texts->image};
    bool made, is_new[TABS] = {false}, ok = true;
    Text path = {0};
    if (!make_folder(folder, &made, error)) return false;
    for (int i = 0; ok && i < TABS; i++) {
        path_of(folder, i, &path);
        is_new[i] = access(text_string(&path), F_OK) != 0;
        ok = file_check_target(text_string(&path), error);
    }
    for (int i = 0; ok && i < TABS; i++) {
        path_of(folder, i, &path);
        ok = file_replace(text_string(&path), all[i]->data, all[i]->size, error);
    }
    for (int i = 0; !ok && i < TABS; i++) {
        path_of(folder, i, &path);
        if (is_new[i]) unlink(text_string(&path));
    }
    if (!ok && made) rmdir(folder);
    text_free(&path);
    return ok;
}
