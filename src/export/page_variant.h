/* A picture as a page draws it: its tables, its programs and their uniforms as lines of JSON, in the order in
 * which they are filled, drawn and set. A page has one for each set of programs that its presets need. */
#pragma once

#include "export/page_texts.h"
#include "render/plan.h"

/* Plans the picture as a page draws it: its film has nothing but its sums. Fails with STATUS_USAGE or
 * STATUS_SCENE where a page cannot draw it, and says why. */
MUST_CHECK bool page_plan(Plan *plan, const RenderParams *params, Error *error);

/* Appends the lines to `lines`. */
MUST_CHECK bool page_variant_write(const Plan *plan, const RenderParams *params, PageTexts *texts,
                                   Text *lines, Error *error);
