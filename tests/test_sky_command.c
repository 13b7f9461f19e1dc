/* `magichour sky`: listed directions, and maps that other programs turn the right way. */
#include "support.h"

#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Image read_map(const char *arguments) {
    Image image;
    Error error;
    support_expect(0, "", "sky %s --quiet -o '%s'", arguments, support_path("map.exr"));
    if (!image_read(&image, support_path("map.exr"), &error)) fail_msg("%s", error.text);
    return image;
}

static void test_rows(void **state) {
    (void)state;
    static const char *const methods[] = {"reference", "gauss", "table", "paper:64x16"};
    const char *csv = support_write(
        "rows.csv", "\xef\xbb\xbf# a comment\r\n\r\nheight_m,sun_el_deg,view_el_deg,az_deg,further\n"
                    "1,60,90,0,abc\n\n  1 , 90 , 0 , 0\n# another\n1,60,45,-90\n");
    /* From data/sky_single_scattering.csv. */
    static const double expected[2] = {0.20840326735068807, 0.38488239611819441};
    for (int m = 0; m < 4; m++) {
        double red[3];
        int lines = 0;
        support_expect(0, "", "sky --at '%s' --sky %s", csv, methods[m]);
        assert_ptr_equal(
            support_out,
            strstr(support_out, "# a comment\n# another\nheight_m,sun_el_deg,view_el_deg,az_deg,R,G,B\n"));
        for (char *line = strchr(strstr(support_out, "height_m"), '\n') + 1; *line;
             line = strchr(line, '\n') + 1) {
            assert_int_equal(sscanf(line, "%*[^,],%*[^,],%*[^,],%*[^,],%lf,", &red[lines++]), 1);
        }
        assert_int_equal(lines, 3);
        double bound = m == 0 ? 1e-7 : m == 3 ? 0.05 : 2e-3;
        for (int i = 0; i < 2; i++) {
            if (fabs(red[i] / expected[i] - 1) > bound) fail_msg("%s: %s", methods[m], support_out);
        }
        assert_non_null(strstr(support_out, "\n1,60,90,0,"));
    }
    support_expect(0, "", "sky --at '%s' -o '%s'", csv, support_path("rows_out.csv"));
}

static void test_bad_rows(void **state) {
    (void)state;
    static const struct {
        const char *text, *part;
    } cases[] = {
        {"1,2,3\n", "rows.csv:1: a row needs height_m,sun_el_deg,view_el_deg,az_deg"},
        {"# x\n1,2,3,4\n1,2,x,4\n",
         "rows.csv:3: view_el_deg: 'x' is not a number, and one from -90 to 90 is needed"},
        {"height_m\n-1,2,3,4\n", "rows.csv:2: height_m: -1 is outside the range from 0"},
        {"1,nan,3,4\n", "rows.csv:1: sun_el_deg: 'nan'"},
        {"1,2,3,4\nheight_m,a,b,c\n", "rows.csv:2: height_m: 'height_m'"},
        {"1,,3,4\n", "rows.csv:1: sun_el_deg: ''"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        support_expect(2, cases[i].part, "sky --at '%s'", support_write("rows.csv", cases[i].text));
    }
    support_expect(2, "none.csv: cannot be read", "sky --at none.csv");
    support_expect(2, "where to?", "sky");
    support_expect(2, "for --at alone", "sky --sky reference -o '%s'", support_path("map.exr"));
    support_expect(2, "sky has no option '--spp'", "sky --spp 3");
}

/* Row 0 is +y, the centre column +z, a quarter from the left +x: the sun stands where its azimuth says. */
static void test_orientation(void **state) {
    (void)state;
    static const struct {
        const char *sun;
        int column;
    } cases[] = {{"--sun 30", 64}, {"--sun 30,90", 32}, {"--sun 30,-90", 96}, {"--sun 30,180", 0}};
    for (int i = 0; i < 4; i++) {
        char arguments[64];
        int brightest = 0;
        snprintf(arguments, sizeof arguments, "%s --sun-disk --size 128x64", cases[i].sun);
        Image map = read_map(arguments);
        for (int k = 0; k < 128 * 64; k++) {
            if (map.rgba[4 * k] > map.rgba[4 * brightest]) brightest = k;
        }
        int off = abs(brightest % 128 - cases[i].column) % 128;
        if (off > 1 && off < 126) fail_msg("%s: brightest at column %d", cases[i].sun, brightest % 128);
        assert_true(abs(brightest / 128 - 21) <= 1);       /* 30 degrees up */
        assert_true(map.rgba[4 * (128 * 60 + 5)] < 1e-3f); /* the ground is dark */
        image_free(&map);
    }
}

/* The disk adds the sun's irradiance, 20 T (data/irradiance.csv), and is cut by the horizon. */
static void test_sun_disk(void **state) {
    (void)state;
    static const struct {
        double sun, expected[3], tolerance;
    } cases[] = {{30, {17.254015, 15.2636723, 11.1727889}, 0.01},
                 {5, {9.16478613, 4.91135661, 1.00365562}, 0.02},
                 {-2, {0, 0, 0}, 0}};
    for (int i = 0; i < 3; i++) {
        char arguments[2][64];
        double sum[3] = {0};
        for (int disk = 0; disk < 2; disk++) {
            snprintf(arguments[disk], sizeof arguments[disk], "--sun %g --size 1024x512 %s", cases[i].sun,
                     disk ? "--sun-disk" : "");
        }
        Image without = read_map(arguments[0]), with = read_map(arguments[1]);
        for (int k = 0; k < 1024 * 512; k++) {
            double solid_angle = 2 * 9.8696044 / (1024.0 * 512.0) * sin(3.14159265 * (k / 1024 + 0.5) / 512);
            for (int c = 0; c < 3; c++) {
                sum[c] += solid_angle * ((double)with.rgba[4 * k + c] - (double)without.rgba[4 * k + c]);
            }
        }
        for (int c = 0; c < 3; c++) {
            if (fabs(sum[c] - cases[i].expected[c]) > cases[i].tolerance * cases[i].expected[c]) {
                fail_msg("sun %g: disk of %g, expected %g", cases[i].sun, sum[c], cases[i].expected[c]);
            }
        }
        image_free(&with);
        image_free(&without);
    }
}

/* Settings reach the sky: without its gases it is black, with ozone it is darker. */
static void test_settings(void **state) {
    (void)state;
    Image plain = read_map("--size 16x8 --sun 10"),
          earth = read_map("--size 16x8 --sun 10 --atmosphere simmons2017-ozone");
    Image empty = read_map("--size 16x8 --set atmosphere.rayleigh=0 --set atmosphere.mie=0");
    for (int k = 0; k < 16 * 4; k++) {
        assert_true(earth.rgba[4 * k + 1] < plain.rgba[4 * k + 1]);
        assert_true(empty.rgba[4 * k] == 0);
    }
    image_free(&plain);
    image_free(&earth);
    image_free(&empty);
    /* What is off is not compiled. */
    support_expect(0, "", "flatten scenes/crater.glsl");
    assert_null(strstr(support_out, "absorber_slope"));
    support_expect(0, "", "flatten scenes/crater.glsl --sky gauss --atmosphere simmons2017-ozone");
    assert_non_null(strstr(support_out, "absorber_slope"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rows),     cmocka_unit_test(test_bad_rows), cmocka_unit_test(test_orientation),
        cmocka_unit_test(test_sun_disk), cmocka_unit_test(test_settings),
    };
    return cmocka_run_group_tests_name("sky command", tests, support_folder, support_clean);
}
