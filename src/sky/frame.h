/* A frame is what the tables of a picture are made from and what its programs' uniforms are set from: the
 * scene's current values, the camera and the methods. It is put together where it is needed and owns nothing
 * that it points to. */
#pragma once

#include "choice/method.h"
#include "gl/camera.h"
#include "scene/scene.h"

#include <stdint.h>

/* The sun's position and the air that it shines through. */
typedef struct SkyState {
    Atmosphere atmosphere;
    Sun sun;
} SkyState;

typedef struct Frame {
    SkyState state;
    const MethodChoice *sky;
    /* The quality of the further orders of scattering. NULL for the default. */
    const MethodChoice *further;
    /* These are NULL if there is only a sky and no scene. */
    const MethodChoice *light, *sun_disk;
    const Scene *scene;
    /* The scene's mirror spheres if it defines them in GLSL (render/drawn_mirrors.h). NULL if they are
     * annotated, or if the picture does not need them. */
    const double (*mirrors)[4];
    Camera camera;
    /* The number of the picture's first sample. */
    uint64_t first_sample;
    /* Whether the tables that follow the sun may be coarse, for a preview. */
    bool coarse;
    /* Whether they are filled in steps. */
    bool in_steps;
} Frame;
