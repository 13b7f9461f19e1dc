/* What a failed comparison of pictures leaves behind. */
#pragma once

#include "image/image.h"

/* Writes got, wanted and error (their difference) as EXR, and as PNG for a first look, into out/failed/NAME,
 * and says so. Characters of the name that a folder's should not have become "-". The error's PNG shows its
 * size, as bright as the picture where it is a tenth of the mean. */
void failed_keep(const char *name, const Image *got, const Image *wanted);
