/* Moves the camera by hand. All functions keep the eye apart from its target, and both within a scene's
 * limits. */
#pragma once

#include "scene/scene.h"

/* Turns the eye about the target. The degrees to the right and up are those by which the picture's content
 * seems to turn. */
void orbit_turn(Scene *scene, double right_deg, double up_deg);

/* Turns the view about the eye. */
void orbit_look(Scene *scene, double right_deg, double up_deg);

/* Multiplies the eye's distance from its target. */
void orbit_zoom(Scene *scene, double factor);

/* Moves eye and target by these metres to the picture's right, upward in the picture, and ahead. */
void orbit_move(Scene *scene, double right, double up, double ahead);

/* Returns the distance of the eye from its target in metres. */
double orbit_distance(const Scene *scene);
