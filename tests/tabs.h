/* The texts of `export --shadertoy`, one for each tab of the site, and the pictures that they draw when they
 * are given back to `render`. The site itself is not asked: glslangValidator reads the texts with what the
 * site writes around them. */
#pragma once

#include "base/text.h"
#include "image/image.h"

#include <stddef.h>

/* The options with which the texts can hold all scenes but one of spheres. */
#define TABS_HELD "--orders 1 --set atmosphere.ground_albedo=0 --sun-disk=off"

/* Ends the test where there is no OpenGL, as support_no_gl() does. */
void tabs_need_gl(void);

/* Files and pictures that have to be there. Both are to be freed. The picture is one of the test's folder. */
Text tabs_read_file(const char *path);
Image tabs_picture(const char *name);

/* The text of a tab of the folder, such as "common.glsl". To be freed. */
Text tabs_read(const char *folder, const char *tab);

/* Fails unless the tab has the words. */
void tabs_expect(const char *folder, const char *tab, const char *words);

/* Fails unless the site would compile the tabs. Does nothing where glslangValidator is missing, and says so
 * once. */
void tabs_compile(const char *folder);

/* Bytes of the tab Common, which has no uniforms of its own. */
size_t tabs_common_size(const char *folder);

/* relRMSE in percent without pixel (0, 0), which holds no light. */
double tabs_difference(const Image *a, const Image *b);

/* Exports a scene, draws so many frames of Buffer A and of Image, and compares them with the scene's own
 * pictures. Returns the relRMSE of the radiances. */
double tabs_round_trip(const char *scene, const char *options, const char *size, int samples);
