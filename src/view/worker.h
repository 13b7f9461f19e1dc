/* A thread that draws, with an OpenGL context of its own that shares textures with the window's. Drivers
 * compile a program when it is made or when it draws first, and that may take long. The window's thread waits
 * for the work, or goes on showing the window meanwhile. Only one of the two threads works on the picture at
 * a time. */
#pragma once

#include "view/window.h"

#include <pthread.h>

typedef bool WorkerTask(void *data, Error *error);

typedef struct Worker {
    /* The worker's own. Everything but showing the picture is done with it. */
    Context context;
    GLFWwindow *hidden;
    pthread_t thread;
    /* Guards what follows. */
    pthread_mutex_t mutex;
    pthread_cond_t changed;
    bool started, busy, leaves, ok;
    WorkerTask *task;
    void *data;
    Error error;
} Worker;

/* Starts the thread. Fails with STATUS_NO_GL if there is no second context. The Worker must not move in
 * memory. */
MUST_CHECK bool worker_start(Worker *worker, Window *window, Error *error);

/* Waits for the task and ends the thread. */
void worker_stop(Worker *worker);

/* Gives the worker something to do. It must be idle. */
void worker_begin(Worker *worker, WorkerTask *task, void *data);

/* Waits up to `seconds`. Returns whether the worker is idle. */
bool worker_wait(Worker *worker, double seconds);

/* What the last task returned, with its error. */
MUST_CHECK bool worker_result(const Worker *worker, Error *error);
