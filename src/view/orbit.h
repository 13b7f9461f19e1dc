/* The camera moved by hand. All keep the eye apart from its target, and both within a scene's limits. */
#pragma once

#include "scene/scene.h"

/* Turns the eye about the target: degrees to the right and up, as the picture's content is seen to turn. */
void orbit_turn(Scene *scene, double right_deg, double up_deg);

/* Turns the view about the eye. */
void orbit_look(Scene *scene, double right_deg, double up_deg);

/* Multiplies the eye's distance from its target. */
void orbit_zoom(Scene *scene, double factor);

/* Moves eye and target, m: to the picture's right, upward in it, ahead. */
void orbit_move(Scene *scene, double right, double up, double ahead);

/* Of the eye from its target, m. */
double orbit_distance(const Scene *scene);
