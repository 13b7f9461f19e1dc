#include "cmd/info_sun.h"

#include "scene/sun_clock.h"
#include "scene/sun_day.h"

#include <math.h>
#include <stdio.h>

static void print_time(const SunDay *day, double utc_s) {
    Moment moment = {utc_s, day->midnight.zone_s};
    Text time = {0};
    moment_print_time(&moment, &time);
    printf("%s", text_string(&time));
    text_free(&time);
}

static void print_head(const SunClock *clock) {
    Text words = {0};
    sun_clock_print(clock, &words);
    printf("the sun on %s, %g m high\n", text_string(&words), clock->height_m);
    text_free(&words);
}

static void print_now(const SunClock *clock) {
    Place place = sun_clock_place(clock);
    SunPlace sun = almanac_sun(clock->utc_s, &place), scene = sun_clock_sun(clock);
    double refraction = sun_refraction_deg(sun.elevation_deg);
    printf("  elevation   %.2f degrees, without refraction by the air, as in pictures", sun.elevation_deg);
    if (refraction > 0) printf("; with it %.2f", sun.elevation_deg + refraction);
    printf(
        "\n  azimuth     %.2f degrees from true north through east; in the scene %.2f, from +z toward +x\n",
        sun.azimuth_deg, scene.azimuth_deg);
}

static void print_noon(const SunDay *day) {
    printf("  highest     ");
    print_time(day, day->highest_utc_s);
    printf(", at %.2f degrees\n", day->highest_deg);
}

static void print_rise(const SunDay *day) {
    Passage passages[MOST_PASSAGES];
    int count = sun_day_passages(day, sunrise_elevation_deg, passages);
    for (int i = 0; i < count; i++) {
        SunPlace sun = almanac_sun(passages[i].utc_s, &day->place);
        printf("  %s     ", passages[i].rising ? "sunrise" : "sunset ");
        print_time(day, passages[i].utc_s);
        printf(", at azimuth %.1f; refraction lifts the sun's upper edge onto a level horizon\n",
               sun.azimuth_deg);
    }
    if (!count) printf("  sunrise     none: the sun is %s all day\n", day->first_deg > 0 ? "up" : "down");
}

/* The times of the day with the sun between two elevations. */
static void print_hours(const SunDay *day, const char *name, double low_deg, double high_deg) {
    Passage low[MOST_PASSAGES], high[MOST_PASSAGES];
    int lows = sun_day_passages(day, low_deg, low), highs = sun_day_passages(day, high_deg, high);
    bool inside = day->first_deg >= low_deg && day->first_deg < high_deg;
    const char *separator = "";
    printf("  %-12s", name);
    if (inside) printf("00:00");
    for (int l = 0, h = 0; l < lows || h < highs;) {
        bool from_low = h >= highs || (l < lows && low[l].utc_s < high[h].utc_s);
        Passage passage = from_low ? low[l++] : high[h++];
        if (inside) {
            printf(" to ");
            separator = ", ";
        } else {
            printf("%s", separator);
        }
        print_time(day, passage.utc_s);
        inside = !inside;
    }
    if (inside)
        printf(" to 24:00");
    else if (!lows && !highs)
        printf("none");
    printf("; the sun from %.3g to %.3g degrees\n", low_deg, high_deg);
}

void info_print_sun(const SunClock *clock) {
    Moment moment = sun_clock_moment(clock);
    Place place = sun_clock_place(clock);
    SunDay day = sun_day(&moment, &place);
    print_head(clock);
    print_now(clock);
    print_rise(&day);
    print_noon(&day);
    print_hours(&day, "golden hour", -4, 6);
    print_hours(&day, "blue hour", -6, -4);
    print_hours(&day, "twilight", -18, sunrise_elevation_deg);
}
