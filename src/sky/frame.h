/* What the tables of a picture are made from and its programs are told: the scene's values as they are now,
 * the camera, the methods. It is put together where it is needed and borrows all that it points to. */
#pragma once

#include "choice/method.h"
#include "gl/camera.h"
#include "scene/scene.h"

/* Where the sun is and the air that it shines through. */
typedef struct SkyState {
    Atmosphere atmosphere;
    Sun sun;
} SkyState;

typedef struct Frame {
    SkyState state;
    const MethodChoice *sky;
    /* NULL, all of these, where there is nothing but a sky. */
    const MethodChoice *light, *sun_disk;
    const Scene *scene;
    Camera camera;
} Frame;
