/* Saves what a render has done so far: checkpoints (--checkpoint, --resume), and the picture so far when
 * SIGUSR1 asks for it. */
#pragma once

#include "cmd/render_job.h"

/* Checks the options before anything is rendered. */
MUST_CHECK bool saver_check(const Options *options, Error *error);

/* Takes the methods of the checkpoint that --resume names for those that the user leaves open, so that a
 * picture can go on to another error. */
void saver_recall(RenderJob *job);

/* Begins the time to the first checkpoint, and loads the one that --resume names into the picture, which was
 * just begun. If --checkpoint names the same file and there is none yet, the picture begins anew. */
MUST_CHECK bool saver_begin(RenderJob *job, Error *error);

/* Whether a round of samples should end so that something is saved. For Adaptive.pause. */
bool saver_wants(void);

/* Writes what is due, between two groups of samples. */
MUST_CHECK bool saver_save(RenderJob *job, Error *error);

/* Writes the last checkpoint, when the samples end. */
MUST_CHECK bool saver_end(RenderJob *job, Error *error);

/* Says how to go on, if the picture was interrupted and there is a checkpoint. */
void saver_say(const RenderJob *job);
