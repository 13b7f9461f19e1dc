/* A picture's metadata: enough to make it again. Names are "magichour.NAME" or "magichour.GROUP.NAME". */
#pragma once

#include "image/attribute.h"
#include "render/renderer.h"

/* One number or three. */
void describe_value(AttributeList *list, const char *group, const char *name, const double *value, int count);
void describe_atmosphere(const Atmosphere *atmosphere, AttributeList *list);

/* Scene, sun, methods, seed, iTime and iMouse where they are not 0, OpenGL, parameters and atmosphere. */
void describe_picture(AttributeList *list, const Scene *scene, const Renderer *renderer,
                      const Context *context);
