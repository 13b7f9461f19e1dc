#include "view/exposure.h"

#include <math.h>
#include <string.h>

/* A picture that is darker by a stop gets this much more exposure, so that a night stays darker than a day.
 */
static const double strength = 0.9;

/* The most that the exposure may leave the anchor's, in stops. */
static const double most_stops = 14;

/* The reading of a picture whose mean luminance is the usual middle grey, 0.18. It stands for the anchor's
 * where there is none. The scenes here read from 0.1 to 0.3 under their authors' exposures. */
static const double middle_reading = -2.4739;

/* The exposure is wanted in steps of this size, so that the noise of the meter does not move it. */
static const double step_ev = 0.1;

/* The way that is left becomes shorter by a factor e in this time. */
static const double adaptation_s = 0.2;

/* What is left is invisible. */
static const double arrived_ev = 0.02;

void exposure_anchor(AutoExposure *exposure, const SceneValues *values) {
    exposure->anchored = true;
    exposure->anchor = *values;
    exposure->anchor_reading = NAN;
    exposure->target_ev = values->exposure_ev;
    exposure->at_once = true;
}

bool exposure_is_anchor(const AutoExposure *exposure, const SceneValues *values) {
    SceneValues same = *values;
    if (!exposure->anchored) return false;
    same.exposure_ev = exposure->anchor.exposure_ev;
    same.time_s = exposure->anchor.time_s;
    memcpy(same.mouse, exposure->anchor.mouse, sizeof same.mouse);
    return scene_values_same(&same, &exposure->anchor);
}

void exposure_read(AutoExposure *exposure, const SceneValues *values, double reading) {
    if (exposure_is_anchor(exposure, values)) {
        exposure->target_ev = exposure->anchor.exposure_ev;
        if (isfinite(reading)) exposure->anchor_reading = reading;
        return;
    }
    if (!isfinite(reading)) return;
    bool known = exposure->anchored && isfinite(exposure->anchor_reading);
    double from_ev = known ? exposure->anchor.exposure_ev : 0;
    double stops = strength * ((known ? exposure->anchor_reading : middle_reading) - reading);
    double wanted = from_ev + fmin(fmax(stops, -most_stops), most_stops);
    exposure->target_ev = step_ev * round(wanted / step_ev);
}

void exposure_reload(AutoExposure *exposure, const SceneValues *before, const SceneValues *now,
                     const SceneValues *shown, bool follow) {
    double exposure_ev = exposure->anchor.exposure_ev + now->exposure_ev - before->exposure_ev;
    if (!exposure->anchored) return;
    if (follow) exposure->anchor = *shown;
    exposure->anchor.exposure_ev = exposure_ev;
}

bool exposure_adapt(AutoExposure *exposure, double *shown_ev, double seconds) {
    if (!exposure->on || isnan(exposure->target_ev)) return false;
    double left = exposure->target_ev - *shown_ev;
    bool arrives = exposure->at_once || fabs(left) < arrived_ev;
    exposure->at_once = false;
    if (arrives)
        *shown_ev = exposure->target_ev;
    else
        *shown_ev += left * (1 - exp(-seconds / adaptation_s));
    return !arrives;
}
