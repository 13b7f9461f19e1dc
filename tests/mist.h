/* What the tests of mist and of air share: pictures by the program, their means, and a scene to put mist
 * into. */
#pragma once

#include "image/image.h"

/* The picture of a scene, by the program in this environment. Where there is no OpenGL the test ends. */
Image mist_render(const char *environment, const char *scene, const char *arguments);

/* The mean of each channel and, if `error` is not NULL, its standard error. */
void mist_means(const Image *image, double mean[3], double error[3]);

/* A ball on even ground, both of this albedo. The annotations begin in the file's third line. There are two
 * sliders: `dense`, from 0 to 1 and at 0.2, and `wide`, from -1 to 8 and at 3. Annotations may bring a camera
 * of their own. */
const char *mist_ball(const char *name, const char *annotations, const char *albedo);
