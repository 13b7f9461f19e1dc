/* Ctrl-C, SIGTERM and SIGHUP end the program at once, with STATUS_INTERRUPTED, while it has nothing to save.
 * Otherwise they make it stop and save, and a second one ends it at once. */
#pragma once

#include "base/error.h"

/* A pipe that nobody reads any more, such as that of the progress, is an error of writing from then on, and
 * does not end the program. */
void interrupt_install(void);

/* From now on there is something to save. */
void interrupt_keep(void);
bool interrupt_requested(void);

/* From now on all is saved again. */
void interrupt_saved(void);

/* Ends the program with a message if a driver takes longer than so many seconds of processor time to compile
 * one shader, as long as there is nothing to save: a compilation cannot be stopped in any other way. `scene`
 * is named in the message. */
void interrupt_limit_compiling(double seconds, const char *scene);

/* From now on SIGUSR1 asks for the picture so far, in place of ending the program. */
void interrupt_answer(void);
bool interrupt_picture_asked(void);

/* Notes that the picture was written. */
void interrupt_picture_done(void);

/* Tells whether there is an unfinished line on the terminal, which is then cleared when the program ends at
 * once. */
void interrupt_line(bool open);

/* Ends the program although another thread is in the middle of something: with STATUS_INTERRUPTED if it was
 * interrupted, and else well. */
_Noreturn void interrupt_leave(bool interrupted);

/* Whether a command that has failed or not may go on to save what is there: it has not failed, or by the
 * interruption alone, which is then no error any more. */
bool interrupt_forgive(bool ok, Error *error);
