#include "scene/moment.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { FIRST_YEAR = 1900, LAST_YEAR = 2100, DAY_S = 86400 };

static bool is_leap(int year) {
    return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
}

static int month_days(int year, int month) {
    static const int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return days[month - 1] + (month == 2 && is_leap(year));
}

/* Days from 1970-01-01. */
static long days_to(int year, int month, int day) {
    long days = day - 1;
    for (int m = 1; m < month; m++) days += month_days(year, m);
    for (int y = 1970; y < year; y++) days += 365 + is_leap(y);
    for (int y = year; y < 1970; y++) days -= 365 + is_leap(y);
    return days;
}

static bool outside(const char *name, const char *what, int value, int min, int max, Error *error) {
    if (value >= min && value <= max) return true;
    return error_set(error, STATUS_USAGE, "%s: %s %d is not one from %d to %d", name, what, value, min, max);
}

/* Reads digits of exactly this number. */
static bool digits(const char **at, int count, int *value) {
    *value = 0;
    for (int i = 0; i < count; i++, (*at)++) {
        if (**at < '0' || **at > '9') return false;
        *value = 10 * *value + (**at - '0');
    }
    return true;
}

static bool sign(const char **at, char wanted) {
    if (**at != wanted) return false;
    (*at)++;
    return true;
}

static bool read_zone(const char *at, int *zone_s) {
    int hours, minutes, minus = *at == '-';
    *zone_s = 0;
    if (strcmp(at, "Z") == 0) return true;
    if (*at != '+' && *at != '-') return false;
    at++;
    if (!digits(&at, 2, &hours)) return false;
    sign(&at, ':');
    if (!digits(&at, 2, &minutes) || *at || hours > 14 || minutes > 59) return false;
    *zone_s = (minus ? -60 : 60) * (60 * hours + minutes);
    return true;
}

bool moment_parse(const char *name, const char *text, Moment *moment, Error *error) {
    const char *at = text;
    int year, month, day, hour, minute, second = 0, zone_s;
    if (!digits(&at, 4, &year) || !sign(&at, '-') || !digits(&at, 2, &month) || !sign(&at, '-') ||
        !digits(&at, 2, &day)) {
        return error_set(error, STATUS_USAGE, "%s: '%s' does not begin with a date such as 2026-06-21", name,
                         text);
    }
    bool timed = (sign(&at, 'T') || sign(&at, ' ')) && digits(&at, 2, &hour) && sign(&at, ':') &&
                 digits(&at, 2, &minute) && (!sign(&at, ':') || digits(&at, 2, &second));
    if (!timed) {
        return error_set(error, STATUS_USAGE, "%s: '%s' has no time such as T20:30 behind its date", name,
                         text);
    }
    if (!read_zone(at, &zone_s)) {
        return error_set(error, STATUS_USAGE,
                         "%s: '%s' needs its time zone at the end: Z for UTC, or such as +02:00", name, text);
    }
    if (!outside(name, "the year", year, FIRST_YEAR, LAST_YEAR, error) ||
        !outside(name, "the month", month, 1, 12, error) ||
        !outside(name, "the day", day, 1, month_days(year, month), error) ||
        !outside(name, "the hour", hour, 0, 23, error) ||
        !outside(name, "the minute", minute, 0, 59, error) ||
        !outside(name, "the second", second, 0, 59, error)) {
        return false;
    }
    double local = (double)days_to(year, month, day) * DAY_S + 3600 * hour + 60 * minute + second;
    *moment = (Moment){local - zone_s, zone_s};
    return true;
}

void moment_print_date(const Moment *moment, Text *out) {
    long days = (long)floor((moment->utc_s + moment->zone_s) / DAY_S);
    int year = 1970, month = 1;
    while (days < 0) days += 365 + is_leap(--year);
    while (days >= 365 + is_leap(year)) days -= 365 + is_leap(year++);
    while (days >= month_days(year, month)) days -= month_days(year, month++);
    text_print(out, "%04d-%02d-%02ld", year, month, days + 1);
}

void moment_print_time(const Moment *moment, Text *out) {
    double local = moment->utc_s + moment->zone_s;
    int minutes = (int)floor((local - DAY_S * floor(local / DAY_S)) / 60);
    text_print(out, "%02d:%02d", minutes / 60, minutes % 60);
}

void moment_print_zone(const Moment *moment, Text *out) {
    int minutes = (int)(fabs(moment->zone_s) / 60);
    text_print(out, "%c%02d:%02d", moment->zone_s < 0 ? '-' : '+', minutes / 60, minutes % 60);
}

Moment moment_midnight(const Moment *moment) {
    double local = moment->utc_s + moment->zone_s;
    return (Moment){DAY_S * floor(local / DAY_S) - moment->zone_s, moment->zone_s};
}
