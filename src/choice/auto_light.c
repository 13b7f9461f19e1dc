#include "choice/auto.h"

#include <stdio.h>

/* Whether mis is likely to reach an error in the least time. Measured over the scenes, with the sun from 60
 * to -2 degrees, as the time to the same error:
 *
 * With the sun at 1 to 15 degrees, mis takes a sixth to a half of the time of the other methods: surfaces
 * that stand upright see the glow about the sun, which bounces by the cosine seldom find. On hills, which are
 * hardly upright, it takes up to twice the time.
 *
 * In rooms it takes up to twice the time of cosine, because walls hide the sky that it looks for. A room is
 * known by its portals.
 *
 * With glass or metal it takes twice the time. What they throw on other surfaces is found by bounces of the
 * material, and mis makes half as many of these.
 *
 * Where nothing but mirror spheres stands on the ground, control is ahead by a quarter.
 *
 * With the sun just below the horizon the glow is wider. Mis then takes six to nine tenths of the time of
 * control for matte objects on open ground, which scenes enclose in bounds. */
static bool is_for_mis(const MethodChoice *sky, const AutoWish *wish) {
    bool low = wish->sun_elevation_deg >= (wish->bounds ? -2 : -1) && wish->sun_elevation_deg <= 20;
    return low && sky->method->integrates && !wish->shiny && !wish->room && !(wish->bounds && wish->mirrors);
}

/* With the sun's disk above this elevation, degrees, most of a room's noise is that of the light from what
 * the sun shines on, within the room or before its window. */
static const double sunlit_deg = 5;

/* Whether portal is likely to reach an error in the least time. Measured in rooms, as the time to the same
 * error with that of cosine as 1. Its paths take 2.2 times as long, 1.7 times with the sun's disk.
 *
 *     sky                    time
 *     even                   0.2
 *     sun at 5, 30, 60       0.25, 0.45, 0.65
 *     with the sun's disk:
 *     sun at 2, 5, 10, 30    0.85, 0.95, 1.4, 1.6
 *
 * The rays find the sky alone. Mis takes 1.4 to 1.7 times the time of cosine there. */
static bool is_for_portal(const MethodChoice *sky, const AutoWish *wish) {
    bool sunlit = wish->sun_disk && wish->sun_elevation_deg > sunlit_deg;
    return wish->room && !sunlit && (sky->table || !sky->method->integrates);
}

/* A light method, and why it was taken. */
typedef struct Taken {
    const char *text, *why;
} Taken;

static Taken take(const MethodChoice *sky, const AutoWish *wish) {
    if (is_for_portal(sky, wish)) return (Taken){"portal", "a room's light is the sky's, by its portals"};
    if (is_for_mis(sky, wish)) return (Taken){"mis", "a low sun glows on what stands upright"};
    if (wish->bounds && sky->table) return (Taken){"control", "the sky is a table and the scene has bounds"};
    if (!sky->table && wish->room)
        return (Taken){NULL, "portal looks the sky up at each hit, and there is no table of it"};
    if (!sky->table)
        return (Taken){NULL, "control looks the sky up twice for each path, and there is no table of it"};
    if (wish->room) return (Taken){NULL, "the room's noise is that of sunlit places, which no portal finds"};
    return (Taken){NULL, "the scene has no bounds"};
}

bool auto_light(MethodChoice *choice, const char *text, const MethodChoice *sky, const AutoWish *wish,
                Error *error) {
    if (!method_is_auto(text)) return method_choose(choice, METHOD_LIGHT, text, error);
    Taken taken = take(sky, wish);
    if (!method_choose(choice, METHOD_LIGHT, taken.text, error)) return false;
    snprintf(choice->why, sizeof choice->why, "%s", taken.why);
    return true;
}
