/* What "auto" takes: the cheapest methods that are accurate enough for what was asked. */
#pragma once

#include "choice/method.h"
#include "scene/atmosphere.h"

/* Target relRMSE, percent, if the user names neither an error nor a number of samples. */
#define AUTO_ERROR_PERCENT 1.0

/* What is known of a picture before its first sample. */
typedef struct AutoWish {
    /* Target relRMSE in percent. 0 if the user gave a number of samples: the target is then estimated from
     * that number, and is AUTO_ERROR_PERCENT at most. */
    double error_percent;
    /* Samples of each pixel; 0 if the target error decides how many there will be. */
    double samples;
    double pixels;
    double sun_elevation_deg;
    const Atmosphere *atmosphere;
    /* Whether the scene names bounds: spheres that enclose what can block the sky. */
    bool bounds;
    /* Whether each of the bounds is a mirror sphere too. */
    bool mirrors;
    /* Whether the picture is of a room whose portals the scene names. */
    bool room;
    /* Whether the sun itself is there, beside the sky that it lights. */
    bool sun_disk;
    /* Whether the scene has materials that are neither matte nor mirrors. */
    bool shiny;
} AutoWish;

/* The target relRMSE, percent, that follows from the wish. */
double auto_error_percent(const AutoWish *wish);

/* Chooses how the further orders of scattering are computed. NULL or "auto" stands for the cheapest quality
 * whose bias, together with that of the sky, is half of the target error at most. The sky is `sky_text`,
 * or one that auto_sky() may take. Where no quality is so good, the best is taken. choice->why tells the user
 * which case it was, if the air has further orders. */
MUST_CHECK bool auto_further(MethodChoice *choice, const char *text, const char *sky_text,
                             const AutoWish *wish, Error *error);

/* Chooses a sky. `text` is as for method_choose(). NULL or "auto" stands for the cheapest of gauss:n and of
 * the tables of gauss:n, among those whose bias is within what `further` leaves of half of the target
 * error; within all of that if it leaves too little, or if there are none within a third. Where no
 * table's bias is so small, the most accurate table is taken, unless a sky ray by ray reaches the error in
 * less time. Where no bias is known, the most accurate table is taken. choice->why tells the user which case
 * it was. */
MUST_CHECK bool auto_sky(MethodChoice *choice, const char *text, const MethodChoice *further,
                         const AutoWish *wish, Error *error);

/* Chooses a light method. NULL or "auto" stands for portal in a room that the sun itself does not light (a
 * low one lights little), else for mis where a low sun shines on what stands upright, else for control where
 * the sky is a table and the scene has bounds, else for cosine. */
MUST_CHECK bool auto_light(MethodChoice *choice, const char *text, const MethodChoice *sky,
                           const AutoWish *wish, Error *error);
