/* The scenes of a folder, such as those that are installed, with their titles. */
#pragma once

typedef struct SceneEntry {
    /* The file's name without its folder and without ".glsl". */
    char *name;
    /* "" if the file gives none. */
    char *title;
    char *path;
} SceneEntry;

/* A zeroed list is empty. */
typedef struct SceneList {
    SceneEntry *entries;
    int count;
} SceneList;

/* The folder `scenes` beside the GLSL library's folder, whether there is one or not. To be freed. */
char *scene_list_folder(const char *library);

/* Reads the folder's files that end in ".glsl" and define a scene or a Shadertoy program, ordered by name. A
 * file with a fault further down is listed too. The list is empty where there is no such folder. */
SceneList scene_list_read(const char *folder);

void scene_list_free(SceneList *list);
