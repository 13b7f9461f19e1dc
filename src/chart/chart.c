#include "chart/chart.h"

char *chart_path(const ChartParams *params, const char *name) {
    Text path = {0};
    text_print(&path, "%s/%s", params->folder, name);
    return path.data;
}

void chart_describe(const ChartParams *params, Text *out) {
    const RenderParams *picture = &params->picture;
    const Scene *scene = picture->scene;
    text_print(out, "%s, %dx%d, sun at %g", scene->title[0] ? scene->title : scene->path,
               picture->width ? picture->width : scene->width,
               picture->height ? picture->height : scene->height, scene->sun_elevation_deg);
}
