/* What "auto" takes: the cheapest methods that are accurate enough for what was asked. */
#pragma once

#include "choice/method.h"
#include "scene/atmosphere.h"

/* relRMSE that is asked for unless the user asks for something else, percent. */
#define AUTO_ERROR_PERCENT 1.0

/* What is known before the first sample. */
typedef struct AutoWish {
    double error_percent; /* relRMSE asked for; 0 where samples were: then what so many are likely to reach,
                             and 1 at most */
    double samples;       /* a pixel; 0 is as many as the error takes */
    double pixels;
    double sun_elevation_deg;
    const Atmosphere *atmosphere;
    bool bounds;  /* whether the scene says what may block the sky ... */
    bool mirrors; /* ... and all of that is mirror spheres */
    bool shiny;   /* whether some of its materials are neither matte nor mirrors */
} AutoWish;

/* The error that the wish comes to, percent. */
double auto_error_percent(const AutoWish *wish);

/* `text` as for method_choose(). For NULL or "auto" the combination of nodes and table that costs the least
 * time among those whose bias stays under a third of the error; where none does, or where the bias is not
 * known, the most accurate. choice->why says which. */
MUST_CHECK bool auto_sky(MethodChoice *choice, const char *text, const AutoWish *wish, Error *error);

/* The light method for `text` NULL or "auto": mis where a low sun shines on more than ground, control where
 * the sky is a table and the scene has bounds, else cosine. */
MUST_CHECK bool auto_light(MethodChoice *choice, const char *text, const MethodChoice *sky,
                           const AutoWish *wish, Error *error);
