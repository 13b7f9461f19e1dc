#include "cmd/option_table.h"

#include <string.h>

const CommandRow command_table[] = {
    {COMMAND_RENDER, "render", "render SCENE -o FILE [options]", "render a scene offscreen", 1, 1},
    {COMMAND_VIEW, "view", "view SCENE [options]", "a window: move the sun and the camera, edit the scene", 1,
     1},
    {COMMAND_SKY, "sky", "sky -o FILE | --at FILE.csv [options]",
     "the sky alone: a lat-long map, or listed directions", 0, 0},
    {COMMAND_COMPARE, "compare", "compare A B [options]",
     "errors of picture A against the reference B; - is standard input", 2, 2},
    {COMMAND_INFO, "info", "info [SCENE|FILE] [options]",
     "scenes, backends, methods, atmospheres; a scene's parameters; what a picture or a checkpoint is", 0, 1},
    {COMMAND_FLATTEN, "flatten", "flatten SCENE [options]",
     "print the shader that a scene and its methods make", 1, 1},
    {COMMAND_CHART, "chart", "chart SCENE -o DIR [options]",
     "measure speed against accuracy on this machine, and draw it", 1, 1},
    {COMMAND_EXPLAIN, "explain", "explain SCENE [options]",
     "what a scene needs: the change and the cost of each term of the model", 1, 1},
    {COMMAND_MERGE, "merge", "merge A B ... -o FILE [options]",
     "pictures of other samples or other pixels of the same picture become one", 1, MOST_INPUTS},
    {COMMAND_SWEEP, "sweep", "sweep SCENE -o DIR [options] [-- options of render]",
     "the list of jobs of a time-lapse: a render for each place of the sun", 1, MOST_INPUTS},
    {COMMAND_EXPORT, "export", "export SCENE -o FILE.html | --shadertoy -o DIR [options]",
     "a page that draws the scene in any browser, or its texts for Shadertoy", 1, 1},
    {COMMAND_NEW, "new", "new NAME [--kind KIND]", "write a scene to begin with, with comments that teach", 1,
     1},
    {COMMAND_HELP, "help", "help [COMMAND]", "the commands, or a command's options", 0, 1},
    {COMMAND_VERSION, "version", "version", "the program's version", 0, 0},
};
const int command_table_size = sizeof command_table / sizeof *command_table;

const CommandRow *command_find(Command command) {
    for (int i = 0; i < command_table_size; i++) {
        if (command_table[i].command == command) return &command_table[i];
    }
    return NULL;
}

const CommandRow *command_named(const char *word) {
    for (int i = 0; i < command_table_size; i++) {
        if (strcmp(command_table[i].name, word) == 0) return &command_table[i];
    }
    return NULL;
}
