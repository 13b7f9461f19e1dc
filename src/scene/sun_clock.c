#include "scene/sun_clock.h"

#include "base/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

SunClock sun_clock_none(void) {
    return (SunClock){.utc_s = NAN, .latitude_deg = NAN, .longitude_deg = NAN};
}

static bool has_moment(const SunClock *clock) {
    return !isnan(clock->utc_s);
}

static bool has_place(const SunClock *clock) {
    return !isnan(clock->latitude_deg);
}

bool sun_clock_runs(const SunClock *clock) {
    return has_moment(clock) && has_place(clock);
}

Moment sun_clock_moment(const SunClock *clock) {
    return (Moment){clock->utc_s, clock->zone_s};
}

Place sun_clock_place(const SunClock *clock) {
    return (Place){clock->latitude_deg, clock->longitude_deg, clock->height_m};
}

/* Seen from above, compass azimuths turn with the clock, and the scene's turn against it. */
SunPlace sun_clock_sun(const SunClock *clock) {
    Place place = sun_clock_place(clock);
    SunPlace sun = almanac_sun(clock->utc_s, &place);
    double azimuth = clock->north_deg - sun.azimuth_deg;
    sun.azimuth_deg = azimuth - 360 * floor(azimuth / 360);
    return sun;
}

void sun_clock_print(const SunClock *clock, Text *out) {
    Moment moment = sun_clock_moment(clock);
    moment_print_date(&moment, out);
    text_print(out, " ");
    moment_print_time(&moment, out);
    text_print(out, " ");
    moment_print_zone(&moment, out);
    text_print(out, " at %.6g, %.6g", clock->latitude_deg, clock->longitude_deg);
}

static void apply(SceneValues *values) {
    if (!sun_clock_runs(&values->clock)) return;
    SunPlace sun = sun_clock_sun(&values->clock);
    values->sun = sun_at(sun.elevation_deg, sun.azimuth_deg, values->sun.radius_deg);
}

static bool available(const char *name, Error *error) {
    const char *missing = almanac_missing();
    return !missing || error_set(error, STATUS_USAGE, "%s: %s", name, missing);
}

bool sun_clock_set_when(SceneValues *values, const char *name, const char *text, Error *error) {
    Moment moment;
    if (!available(name, error) || !moment_parse(name, text, &moment, error)) return false;
    values->clock.utc_s = moment.utc_s;
    values->clock.zone_s = moment.zone_s;
    apply(values);
    return true;
}

bool sun_clock_set_where(SceneValues *values, const char *name, const char *text, Error *error) {
    static const struct {
        const char *what;
        double min, max;
    } parts[] = {{"latitude", -90, 90}, {"longitude", -180, 180}, {"height", -500, 9000}};
    double numbers[3] = {0};
    int count = 0;
    if (!available(name, error)) return false;
    for (const char *at = text; at; count++) {
        char number[64], part[96];
        size_t length = strcspn(at, ",");
        if (count == 3 || length >= sizeof number) break;
        snprintf(number, sizeof number, "%.*s", (int)length, at);
        snprintf(part, sizeof part, "%s: %s", name, parts[count].what);
        if (!number_parse_range(part, number, parts[count].min, parts[count].max, &numbers[count], error))
            return false;
        at = at[length] ? at + length + 1 : NULL;
    }
    size_t commas = 0;
    for (const char *c = text; *c; c++) commas += *c == ',';
    if (count < 2 || commas > 2) {
        return error_set(
            error, STATUS_USAGE,
            "%s: '%s' is not LATITUDE,LONGITUDE or LATITUDE,LONGITUDE,HEIGHT (degrees north and east, "
            "metres), such as 48.14,11.58",
            name, text);
    }
    values->clock.latitude_deg = numbers[0];
    values->clock.longitude_deg = numbers[1];
    values->clock.height_m = numbers[2];
    apply(values);
    return true;
}

bool sun_clock_set_north(SceneValues *values, const char *name, const char *text, Error *error) {
    if (!number_parse_range(name, text, -360, 360, &values->clock.north_deg, error)) return false;
    apply(values);
    return true;
}

void sun_clock_set_utc(SceneValues *values, double utc_s) {
    values->clock.utc_s = utc_s;
    apply(values);
}

bool sun_clock_check(const SunClock *clock, Error *error) {
    if (has_moment(clock) && !has_place(clock)) {
        return error_set(
            error, STATUS_USAGE,
            "a time says where the sun stands only together with a place (--where LATITUDE,LONGITUDE, or "
            "in the scene `//@ sun where LATITUDE,LONGITUDE`)");
    }
    return true;
}
