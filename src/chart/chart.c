#include "chart/chart.h"

char *chart_path(const ChartParams *params, const char *name) {
    Text path = {0};
    text_print(&path, "%s/%s", params->folder, name);
    return path.data;
}

void chart_describe(const ChartParams *params, Text *out) {
    const RenderParams *picture = &params->picture;
    const Scene *scene = picture->scene;
    text_print(out, "%s, %dx%d, sun at %g", scene->file->title[0] ? scene->file->title : scene->file->path,
               picture->width ? picture->width : scene->file->width,
               picture->height ? picture->height : scene->file->height, scene->values.sun.elevation_deg);
}
