/* The window as a whole, and what its worker does (view/busy.h): all that works on the picture. */
#pragma once

#include "view/busy.h"
#include "view/controls.h"
#include "view/menu.h"
#include "view/meter.h"
#include "view/picture.h"
#include "view/play.h"
#include "view/watch.h"

typedef struct View {
    const ViewParams *params;
    ViewState state;
    Window window;
    Overlay *overlay;
    Display display;
    Busy busy;
    Picture picture;
    Meter meter;
    PlayNotes notes;
    /* The scene's program whose warnings were said. */
    GLuint warned;
    Watch watch;
    Controls controls;
    SceneMenu menu;
    ViewFigures figures;
    /* When the first event came that no picture has answered yet; 0 if there is none. */
    double heard;
    /* When a picture was last shown, and when the camera last flew. */
    double shown, flown;
    /* Whether the automatic exposure has not arrived, and when it last moved. */
    bool adapting;
    double adapted;
    /* Whether there is something new to show. */
    bool news;
    /* The number of pictures to show in any case: the overlay needs some to settle. */
    int linger;
    int frames, recorded;
} View;

/* `data` is the View. */
WorkerTask task_create_picture, task_destroy_picture;

/* Reads the files again, which have changed. */
WorkerTask task_reload;

/* Opens the scene that the user wants. */
WorkerTask task_open_other;

/* Finds the figures that the overlay shows. */
WorkerTask task_find_figures;

/* Follows the state and draws for a while. */
WorkerTask task_draw;

/* Saves the picture if that is wanted, and records it. */
WorkerTask task_save;
