/* A scene as one page for browsers: the data of its pictures, and the script that draws them with WebGL 2.
 * The page asks for nothing from anywhere. */
#pragma once

#include "export/page_params.h"

/* Appends the page. Needs no OpenGL. STATUS_USAGE or STATUS_SCENE says what a page cannot draw. */
MUST_CHECK bool page_write(const PageParams *params, Text *html, Error *error);
