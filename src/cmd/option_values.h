/* The values that options accept: one function for each option whose value is more than a word to keep. A
 * refused value is STATUS_USAGE with the option's name in front. */
#pragma once

#include "cmd/options.h"

typedef bool OptionTake(Options *options, const char *name, const char *value, Error *error);

OptionTake take_output, take_layer, take_setting, take_allowed, take_size, take_sun, take_samples, take_seed,
    take_depth, take_seconds, take_compile_seconds, take_first_sample, take_of, take_crop,
    take_checkpoint_seconds, take_error, take_percent, take_exposure, take_max_relrmse, take_max_bias,
    take_max_levels, take_frames, take_frame_rate, take_max_memory;

/* Keeps a value that is one of the words between commas. */
MUST_CHECK bool take_word(const char *words, const char *name, const char *value, const char **target,
                          Error *error);

/* The next word of a list with commas, to be cut at `length`; NULL at the list's end. */
const char *word_next(const char **list, size_t *length);
