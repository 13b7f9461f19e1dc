/* The scenes that are shipped. */
#pragma once

enum { MOST_SCENES = 64 };

typedef struct SceneList {
    char paths[MOST_SCENES][288];
    int count;
} SceneList;

/* All of scenes/, by name: "scenes/crater.glsl". Fails the test where there are none or too many. */
SceneList scene_list(void);
