/* Automatic exposure. It follows the brightness of the picture, as eyes do, and starts from what the scene's
 * author has set: the exposure of a scene or a preset belongs to the picture that the author saw, which is
 * called the anchor here. */
#pragma once

#include "scene/scene_values.h"

typedef struct AutoExposure {
    bool on;
    /* Whether there is an anchor, its values with the author's exposure, and its reading of the meter. The
     * reading is NaN before the meter has seen it. */
    bool anchored;
    SceneValues anchor;
    double anchor_reading;
    /* The exposure that is wanted. NaN while it is not known. */
    double target_ev;
    /* Whether the next step goes to the target at once. */
    bool at_once;
} AutoExposure;

/* Makes these values the anchor. Their exposure is shown from now on. */
void exposure_anchor(AutoExposure *exposure, const SceneValues *values);

/* Takes a reading of the meter, in stops (view/meter.h), of the picture that these values make. A NaN says
 * that the picture is black, and changes nothing. */
void exposure_read(AutoExposure *exposure, const SceneValues *values, double reading);

/* After the scene's file was read again: `before` and `now` are its values then and now. A change of its
 * exposure changes the anchor's. `follow` says that the anchor was shown, and moves it to `shown`. */
void exposure_reload(AutoExposure *exposure, const SceneValues *before, const SceneValues *now,
                     const SceneValues *shown, bool follow);

/* Whether these values are those of the anchor, in all that changes a picture but time, mouse and exposure.
 */
bool exposure_is_anchor(const AutoExposure *exposure, const SceneValues *values);

/* Moves the exposure that is shown towards the one that is wanted. Returns whether it has not arrived. */
bool exposure_adapt(AutoExposure *exposure, double *shown_ev, double seconds);
