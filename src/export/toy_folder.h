/* The folder of Shadertoy's texts. */
#pragma once

#include "scene/scene_file.h"

/* By the site's tabs. */
typedef struct ToyTexts {
    Text common, buffer, image;
} ToyTexts;

void toy_texts_free(ToyTexts *texts);

/* Puts in front of each text a comment that says what it is, what to paste where, and the command line that
 * made it. */
void toy_folder_head(ToyTexts *texts, const SceneFile *file, const char *command);

/* Makes the folder if need be, and writes the three files. If one cannot be written, those that are new are
 * taken away again, and the folder too: STATUS_OUTPUT. */
MUST_CHECK bool toy_folder_write(const ToyTexts *texts, const char *folder, Error *error);
