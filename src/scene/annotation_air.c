#include "scene/annotation_air.h"

#include "scene/annotation_parameters.h"

#include <string.h>

bool air_read(Line *line, Error *error) {
    SceneFile *file = line->file;
    const char *word = line->count > 1 ? line->words[1] : "";
    bool on = strcmp(word, "on") == 0;
    if (!on && strcmp(word, "off") != 0)
        return error_set(error, STATUS_SCENE,
                         "air needs on or off; its coefficients are the atmosphere's (atmosphere.NAME)");
    if (line->count > 2)
        return error_set(error, STATUS_SCENE,
                         "air: unknown word '%s': its coefficients are the atmosphere's (atmosphere.NAME)",
                         line->words[2]);
    file->air_line = line->number;
    file->air_parameter =
        parameters_add_switch(file, "air", "the atmosphere's air between the surfaces", error);
    if (file->air_parameter < 0) return error_prefix(error, "air is switched by a parameter of its name: ");
    file->values.parameters[file->air_parameter][0] = on;
    return true;
}
