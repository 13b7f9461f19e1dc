/* The data of a page: an object of JSON a line. src/export/README.md lists the kinds of lines. */
#pragma once

#include "export/page_params.h"

MUST_CHECK bool page_data(const PageParams *params, Text *lines, Error *error);
