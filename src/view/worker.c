#include "view/worker.h"

#include <math.h>
#include <time.h>

static void *run(void *data) {
    Worker *worker = data;
    pthread_mutex_lock(&worker->mutex);
    while (!worker->leaves) {
        if (!worker->busy) {
            pthread_cond_wait(&worker->changed, &worker->mutex);
            continue;
        }
        pthread_mutex_unlock(&worker->mutex);
        bool ok = worker->task(worker->data, &worker->error);
        pthread_mutex_lock(&worker->mutex);
        worker->ok = ok;
        worker->busy = false;
        pthread_cond_broadcast(&worker->changed);
    }
    pthread_mutex_unlock(&worker->mutex);
    return NULL;
}

static bool adopt(void *data, Error *error) {
    Worker *worker = data;
    return window_adopt_hidden(worker->hidden, &worker->context, error);
}

static bool leave(void *data, Error *error) {
    Worker *worker = data;
    (void)error;
    context_close(&worker->context);
    window_release_hidden();
    return true;
}

static bool wait_for(Worker *worker, WorkerTask *task, Error *error) {
    worker_begin(worker, task, worker);
    while (!worker_wait(worker, 1)) continue;
    return worker_result(worker, error);
}

bool worker_start(Worker *worker, Window *window, Error *error) {
    pthread_condattr_t attributes;
    *worker = (Worker){.hidden = window_create_hidden(window, error)};
    if (!worker->hidden) return false;
    pthread_condattr_init(&attributes);
    pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
    pthread_cond_init(&worker->changed, &attributes);
    pthread_condattr_destroy(&attributes);
    pthread_mutex_init(&worker->mutex, NULL);
    worker->started = pthread_create(&worker->thread, NULL, run, worker) == 0;
    if (!worker->started) error_set(error, STATUS_FAILURE, "no thread for drawing can be started");
    if (worker->started && wait_for(worker, adopt, error)) return true;
    worker_stop(worker);
    return false;
}

void worker_stop(Worker *worker) {
    Error error;
    if (!worker->hidden) return;
    if (worker->started) {
        while (!worker_wait(worker, 1)) continue;
        /* The end of the context cannot fail. */
        if (!wait_for(worker, leave, &error)) worker->ok = true;
        pthread_mutex_lock(&worker->mutex);
        worker->leaves = true;
        pthread_cond_broadcast(&worker->changed);
        pthread_mutex_unlock(&worker->mutex);
        pthread_join(worker->thread, NULL);
    }
    pthread_mutex_destroy(&worker->mutex);
    pthread_cond_destroy(&worker->changed);
    window_destroy_hidden(worker->hidden);
    *worker = (Worker){0};
}

void worker_begin(Worker *worker, WorkerTask *task, void *data) {
    pthread_mutex_lock(&worker->mutex);
    worker->task = task;
    worker->data = data;
    worker->busy = true;
    pthread_cond_broadcast(&worker->changed);
    pthread_mutex_unlock(&worker->mutex);
}

bool worker_wait(Worker *worker, double seconds) {
    struct timespec end;
    clock_gettime(CLOCK_MONOTONIC, &end);
    double whole = floor(seconds), nanoseconds = (double)end.tv_nsec + 1e9 * (seconds - whole);
    end.tv_sec += (time_t)whole + (nanoseconds >= 1e9);
    end.tv_nsec = (long)fmod(nanoseconds, 1e9);
    pthread_mutex_lock(&worker->mutex);
    int status = 0;
    while (worker->busy && !status) status = pthread_cond_timedwait(&worker->changed, &worker->mutex, &end);
    bool idle = !worker->busy;
    pthread_mutex_unlock(&worker->mutex);
    return idle;
}

bool worker_result(const Worker *worker, Error *error) {
    if (!worker->ok) *error = worker->error;
    return worker->ok;
}
