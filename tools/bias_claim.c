/* Prints what the sky's methods are said to err. It is called by tools/bias_scan.sh.
 *
 * bias_claim PRESET [NAME=VALUE ...] takes settings of the atmosphere such as ground_albedo=0.3. It reads
 * lines height_m,sun_el_deg,SKY,FURTHER from standard input, and prints
 *     height_m,sun_el_deg,SKY,FURTHER,claim,SKY in full,FURTHER in full,claim of nodes,of the table,of
 * further orders
 *
 * SKY and FURTHER are methods. Both may be auto:ERROR instead: what auto takes for --error ERROR and a
 * picture of 512x512 pixels. Claims are in percent. The last three add up to the first. They are nan where
 * nothing is claimed. */
#include "choice/auto.h"
#include "choice/bias.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void fail(const char *words) {
    fprintf(stderr, "bias_claim: %s\n", words);
    exit(1);
}

static void set_air(Atmosphere *air, const char *preset, char **settings) {
    Error error;
    if (!atmosphere_choose(air, preset, &error)) fail(error.text);
    for (; *settings; settings++) {
        char *value = strchr(*settings, '=');
        if (!value) fail("a setting has no value");
        *value = 0;
        if (!atmosphere_set(air, *settings, value + 1, &error)) fail(error.text);
        *value = '=';
    }
}

/* The error of "auto:ERROR", or 0. */
static double error_of(const char *text) {
    return strncmp(text, "auto:", 5) == 0 ? strtod(text + 5, NULL) : 0;
}

static void print_claim(const Atmosphere *air, double sun, const char *sky, const char *further) {
    AutoWish wish = {
        .error_percent = error_of(sky), .pixels = 512.0 * 512, .sun_elevation_deg = sun, .atmosphere = air};
    MethodChoice of_further, of_sky;
    Error error;
    const char *named = error_of(sky) > 0 ? NULL : sky;
    if (!auto_further(&of_further, error_of(further) > 0 ? NULL : further, named, &wish, &error) ||
        !auto_sky(&of_sky, named, &of_further, &wish, &error))
        fail(error.text);
    MethodChoice bare = of_sky;
    bare.table = false;
    double nodes = bias_sky_percent(&bare, sun, air), all_of_sky = bias_sky_percent(&of_sky, sun, air),
           orders = bias_further_percent(&of_further, sun, air);
    printf("%.9g,%g,%s,%s,%.6g,%s,%s,%.6g,%.6g,%.6g\n", air->observer_height_m, sun, sky, further,
           all_of_sky + orders, of_sky.text, of_further.text, nodes, all_of_sky - nodes, orders);
}

int main(int count, char **words) {
    Atmosphere air;
    char line[200], sky[60], further[60];
    double sun;
    if (count < 2) fail("no atmosphere is named");
    set_air(&air, words[1], words + 2);
    while (fgets(line, sizeof line, stdin)) {
        if (sscanf(line, "%lf,%lf,%59[^,],%59[^,\n]", &air.observer_height_m, &sun, sky, further) != 4)
            fail("a line is not height_m,sun_el_deg,SKY,FURTHER");
        print_claim(&air, sun, sky, further);
    }
    return 0;
}
