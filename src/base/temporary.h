/* The file beside a target that is written first, and renamed when it is whole. While it is written, its
 * writer holds a lock on it, which ends with the process: what is left of a killed one is known by that. */
#pragma once

/* Makes the temporary file of a target, gives its path (to be freed) and its descriptor, which is locked; -1
 * with errno where it cannot be made. */
int temporary_make(const char *target, char **path);

/* Removes what killed processes of this user have left for the same target. */
void temporary_sweep(const char *target);

/* The folder that holds a file, to be freed. */
char *temporary_folder(const char *path);
