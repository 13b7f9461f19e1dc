/* A Shadertoy program of several texts. As on the site's tabs, common.glsl stands in front of the others, and
 * Image shows what buffer-a.glsl draws. */
#pragma once

#include "scene/scene_file.h"

/* Finds the tabs of a program that paints by itself: those beside a file image.glsl, and the Common beside a
 * file buffer-a.glsl. */
void toy_tabs_find(SceneFile *file);

/* The path of image.glsl in a folder, to be freed; NULL where there is none. */
char *toy_tabs_image(const char *folder);
