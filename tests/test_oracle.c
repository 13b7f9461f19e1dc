/* The GLSL library by the GPU, and by C++ in float and in double: the same files, the same numbers. */
#include "oracle/oracle.h"
#include "random.h"
#include "scene/sphere_tree.h"
#include "support.h"

#include <math.h>
#include <string.h>

ORACLE_CASE(aerial);
ORACLE_CASE(atmosphere);
ORACLE_CASE(mirror_sphere);
ORACLE_CASE(checker);
ORACLE_CASE(crater_cosine);
ORACLE_CASE(crater_paper);
ORACLE_CASE(crater_uniform);
ORACLE_CASE(distance);
ORACLE_CASE(distance_more);
ORACLE_CASE(distance_noise);
ORACLE_CASE(emission);
ORACLE_CASE(rectangle);
ORACLE_CASE(gauss);
ORACLE_CASE(lobe_cosine);
ORACLE_CASE(lobe_paper);
ORACLE_CASE(march);
ORACLE_CASE(material);
ORACLE_CASE(mist);
ORACLE_CASE(paper);
ORACLE_CASE(phase);
ORACLE_CASE(sequence_random);
ORACLE_CASE(sequence_sobol);
ORACLE_CASE(chain_step);
ORACLE_CASE(shape);
ORACLE_CASE(solids);
ORACLE_CASE(spheres);

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

static const double pi = 3.14159265358979323846;
static const double heights[] = {0, 0.1, 1, 10, 300, 8e3, 2e4, 59999, 1e5, 1e6};

static float inputs[8 * ORACLE_ITEMS];
static Context context;

/* Skips the test where there is no GPU to compare with. */
static void start(void **state) {
    (void)state;
    memset(inputs, 0, sizeof inputs);
    random_state = 1;
    support_open(&context);
}

/* Dense at the horizon, the level one and (from above the air, its edge too) the visible one: down to a
 * millionth of a radian from it, on both sides. */
static double elevation_near_horizon(double height_m) {
    const double radius = 6360e3, top = 6420e3;
    double choice = random_unit(), side = random_unit() < 0.5 ? -1 : 1;
    double middle = choice < 0.4 ? 0 : -acos(radius / (radius + height_m));
    if (choice > 0.7 && radius + height_m > top) middle = -acos(top / (radius + height_m));
    double elevation = middle + side * pi / 2 * pow(10, -6 * random_unit());
    return fmax(-pi / 2, fmin(pi / 2, elevation));
}

static void set_direction(float *out, double elevation, double azimuth) {
    out[0] = (float)(cos(elevation) * sin(azimuth));
    out[1] = (float)sin(elevation);
    out[2] = (float)(cos(elevation) * cos(azimuth));
}

static void set_any_direction(float *out) {
    set_direction(out, asin(2 * random_unit() - 1), 2 * pi * random_unit());
}

static void test_phase(void **state) {
    static const double asymmetry[] = {-0.999, -0.95, -0.76, -0.3, 0, 0.3, 0.76, 0.95, 0.999};
    static const OracleQuantity quantities[] = {
        {"Rayleigh", .result = 0, .rms = 1e-6, .worst = 3e-5},
        {"Mie", .result = 1, .rms = 1e-6, .worst = 3e-5},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *view = inputs + 8 * i, *sun = view + 4;
        /* From the peak's middle to opposite, at all scales. */
        double angle = pi * pow(10, -5 * random_unit()), elevation = random_unit();
        set_direction(sun, elevation, 1);
        set_direction(view, elevation + (i % 2 ? angle : pi - angle), 1);
        view[3] = (float)asymmetry[i % COUNT(asymmetry)];
    }
    oracle_compare(&context, ORACLE(phase), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

static void test_atmosphere(void **state) {
    /* Altitudes matter against a scale height. Distances are relative, however short. */
    static const OracleQuantity quantities[] = {
        {"altitude along a ray", .result = 0, .condition = 5, .floor = 1200, .rms = 1e-6, .worst = 3e-5},
        {"distance to the top", .result = 1, .floor = 1, .rms = 1e-6, .worst = 3e-5},
        {"entry into the air", .result = 2, .condition = 6, .floor = 1, .rms = 1e-6, .worst = 3e-5,
         .most_set_aside = 0.02},
        {"exit from the air", .result = 3, .condition = 6, .floor = 1, .rms = 1e-6, .worst = 3e-5,
         .most_set_aside = 0.02},
        {"planet's shadow", .result = 4, .condition = 6, .floor = 1, .most_set_aside = 0.02},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *a = inputs + 8 * i;
        a[0] = (float)heights[i % COUNT(heights)];
        a[1] = (float)sin(elevation_near_horizon((double)a[0]));
        a[2] = (float)pow(10, 6 * random_unit());
    }
    oracle_compare(&context, ORACLE(atmosphere), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

/* One of the 16 points may stand on the shadow's edge: a jump. */
#define RADIANCE .condition = 4, .rms = 1e-6, .worst = 3e-5, .jump = 1e-3, .most_set_aside = 0.005

static void compare_sky(OracleCase oracle) {
    static const double suns_deg[] = {90, 60, 30, 10, 5, 2, 0.1, -2, -6, -12};
    static const OracleQuantity quantities[] = {
        {"red", RADIANCE, .result = 0, .floor = 1.43e-6},
        {"green", RADIANCE, .result = 1, .floor = 1.47e-6},
        {"blue", RADIANCE, .result = 2, .floor = 1.54e-6},
    };
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *view = inputs + 8 * i, *sun = view + 4;
        view[3] = (float)heights[i % COUNT(heights)];
        set_direction(view, elevation_near_horizon((double)view[3]), 2 * pi * random_unit());
        set_direction(sun, suns_deg[i / COUNT(heights) % COUNT(suns_deg)] * pi / 180, 0);
        sun[3] = (float)(i % 2);
    }
    oracle_compare(&context, oracle, inputs, quantities, COUNT(quantities));
}

static void test_paper(void **state) {
    start(state);
    compare_sky(ORACLE(paper));
    context_close(&context);
}

static void test_gauss(void **state) {
    start(state);
    compare_sky(ORACLE(gauss));
    context_close(&context);
}

static void test_shape(void **state) {
    static const OracleQuantity quantities[] = {
        {"distance", .result = 0, .condition = 5, .rms = 1e-6, .worst = 3e-5, .most_set_aside = 0.05},
        {"normal's x", .result = 1, .condition = 6, .floor = 1, .rms = 1e-6, .worst = 3e-5,
         .most_set_aside = 0.05},
        {"normal's y", .result = 2, .condition = 6, .floor = 1, .rms = 1e-6, .worst = 3e-5,
         .most_set_aside = 0.05},
        {"normal's z", .result = 3, .condition = 6, .floor = 1, .rms = 1e-6, .worst = 3e-5,
         .most_set_aside = 0.05},
        {"object", .result = 4, .condition = 5, .floor = 1, .most_set_aside = 0.05},
    };
    static const double radii[] = {0.01, 0.5, 2, 100};
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *origin = inputs + 8 * i, *direction = origin + 4;
        double radius = radii[i / 3 % COUNT(radii)], reach = radius * (i % 2 ? 0.9 : 20), to[3], length = 0;
        origin[3] = (float)(i % 3);
        direction[3] = (float)radius;
        for (int c = 0; c < 3; c++) {
            origin[c] = (float)(reach * (2 * random_unit() - 1));
            if (c == 1 && i % 3 == 2 && reach > radius) origin[c] = fabsf(origin[c]) + 0.3f;
            to[c] = 1.2 * radius * (2 * random_unit() - 1) + (c == 1 ? 0.3 : 0) - (double)origin[c];
            length += to[c] * to[c];
        }
        for (int c = 0; c < 3; c++) direction[c] = (float)(to[c] / sqrt(length));
    }
    oracle_compare(&context, ORACLE(shape), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

/* Rays toward solids of a metre, from 1 to 20 m; `kinds` of them. */
static void make_rays(int kinds) {
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *origin = inputs + 8 * i, *direction = origin + 4;
        double reach = i % 2 ? 1.2 : 20, to[3], length = 0;
        origin[3] = (float)(i / 2 % kinds);
        for (int c = 0; c < 3; c++) {
            origin[c] = (float)(reach * (2 * random_unit() - 1));
            to[c] = 1.2 * (2 * random_unit() - 1) - (double)origin[c];
            length += to[c] * to[c];
        }
        for (int c = 0; c < 3; c++) direction[c] = (float)(to[c] / sqrt(length));
    }
}

/* At edges and silhouettes a rounding decides: jumps. */
static void test_solids(void **state) {
#define EDGE .rms = 1e-6, .worst = 3e-5, .most_set_aside = 0.01
    static const OracleQuantity quantities[] = {
        {"distance", .result = 0, .condition = 5, .jump = 0.01, EDGE},
        {"normal's x", .result = 1, .condition = 6, .floor = 1, .jump = 0.01, EDGE},
        {"normal's y", .result = 2, .condition = 6, .floor = 1, .jump = 0.01, EDGE},
        {"normal's z", .result = 3, .condition = 6, .floor = 1, .jump = 0.01, EDGE},
        {"object", .result = 4, .floor = 1, .jump = 0.5, .most_set_aside = 0.01},
    };
    start(state);
    make_rays(8);
    oracle_compare(&context, ORACLE(solids), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

/* Normals are difference quotients, as good as MARCH_NORMAL_STEP. */
static void test_march(void **state) {
#define QUOTIENT .rms = 2e-4, .worst = 5e-3, .jump = 0.05, .most_set_aside = 0.01
    static const OracleQuantity quantities[] = {
        {"distance", .result = 0, .condition = 5, .jump = 0.01, EDGE},
        {"normal's x", .result = 1, .floor = 1, QUOTIENT},
        {"normal's y", .result = 2, .floor = 1, QUOTIENT},
        {"normal's z", .result = 3, .floor = 1, QUOTIENT},
        {"object", .result = 4, .floor = 1, .jump = 0.5, .most_set_aside = 0.01},
    };
    start(state);
    make_rays(1);
    oracle_compare(&context, ORACLE(march), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

static void test_distance(void **state) {
#define NEAR .floor = 1, .rms = 1e-6, .worst = 3e-6
    static const OracleQuantity quantities[] = {
        {"rounded box", .result = 0, NEAR}, {"cylinder", .result = 1, NEAR},
        {"capsule", .result = 2, NEAR},     {"cone", .result = 3, NEAR},
        {"subtraction", .result = 4, NEAR}, {"ellipsoid", .result = 5, NEAR},
        {"copies", .result = 6, NEAR},      {"smooth", .result = 7, NEAR},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        for (int c = 0; c < 3; c++) inputs[8 * i + c] = (float)((i % 2 ? 1.2 : 5) * (2 * random_unit() - 1));
    }
    oracle_compare(&context, ORACLE(distance), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

static void test_distance_more(void **state) {
    static const OracleQuantity quantities[] = {
        {"round cone", .result = 0, NEAR},       {"vesica", .result = 1, NEAR},
        {"bowl and pyramid", .result = 2, NEAR}, {"tube", .result = 3, NEAR},
        {"figures", .result = 4, NEAR},          {"edges", .result = 5, NEAR},
        {"deformed", .result = 6, NEAR},         {"copies", .result = 7, NEAR},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        for (int c = 0; c < 3; c++) inputs[8 * i + c] = (float)((i % 2 ? 1.2 : 5) * (2 * random_unit() - 1));
    }
    oracle_compare(&context, ORACLE(distance_more), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

static void test_lobes(void **state) {
    static const OracleQuantity quantities[] = {
        {"point's x", .result = 0, .floor = 1, .rms = 1e-6, .worst = 3e-6},
        {"point's y", .result = 1, .floor = 1, .rms = 1e-6, .worst = 3e-6},
        {"point's z", .result = 2, .floor = 1, .rms = 1e-6, .worst = 3e-6},
        {"bounce's x", .result = 4, .condition = 7, .floor = 1, .rms = 1e-6, .worst = 3e-6,
         .most_set_aside = 0.001},
        {"bounce's y", .result = 5, .condition = 7, .floor = 1, .rms = 1e-6, .worst = 3e-6,
         .most_set_aside = 0.001},
        {"bounce's z", .result = 6, .condition = 7, .floor = 1, .rms = 1e-6, .worst = 3e-6,
         .most_set_aside = 0.001},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        for (int c = 0; c < 4; c++) inputs[8 * i + c] = (float)random_unit();
        set_any_direction(inputs + 8 * i + 4);
    }
    oracle_compare(&context, ORACLE(lobe_cosine), inputs, quantities, COUNT(quantities));
    oracle_compare(&context, ORACLE(lobe_paper), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

/* Mist that thins with height, from so slowly that it is of one density to within a metre, along rays that
 * rise, fall and stay level; and its turns. */
static void test_mist(void **state) {
    static const double forwards[] = {-0.99, -0.6, 0, 1e-4, 0.3, 0.6, 0.9, 0.99};
    static const OracleQuantity quantities[] = {
        {"depth", .result = 0, .rms = 1e-6, .worst = 2e-5},
        {"event", .result = 1, .floor = 1e-3, .rms = 1e-6, .worst = 1e-5, .jump = 1e-2,
         .most_set_aside = 1e-3},
        {"point", .result = 2, .floor = 1e-3, .rms = 2e-6, .worst = 2e-4},
        {"weight", .result = 3, .rms = 1e-6, .worst = 2e-5},
        {"turn", .result = 4, .floor = 1, .rms = 1e-6, .worst = 1e-5},
        {"density", .result = 5, .floor = 1, .rms = 1e-6, .worst = 2e-5},
        {"Cornette and Shanks", .result = 6, .floor = 1, .rms = 1e-6, .worst = 1e-5},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *a = inputs + 8 * i, *b = a + 4;
        b[0] = (float)pow(10, 6 * random_unit() - 1);
        a[0] = (float)(b[0] < 100 ? 3 * (double)b[0] * (2 * random_unit() - 1) : 0);
        a[1] = (float)((i % 2 ? 1 : -1) * pow(10, -6 * random_unit()));
        a[2] = (float)fmin(pow(10, 4 * random_unit() - 1), 20 * (double)b[0]);
        a[3] = (float)forwards[i % COUNT(forwards)];
        b[1] = (float)pow(10, 4 * random_unit() - 4);
        b[2] = (float)random_unit();
        b[3] = (float)random_unit();
    }
    oracle_compare(&context, ORACLE(mist), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

/* The extinction summed along the ray of an item by Simpson's rule, up to a distance. */
static double mist_quadrature(const float *item, double distance) {
    enum { STEPS = 2000 };
    double sum = 0, step = distance / STEPS;
    for (int i = 0; i <= STEPS; i++) {
        double y = (double)item[0] + i * step * (double)item[1];
        sum += (i == 0 || i == STEPS ? 1 : i % 2 ? 4 : 2) * (double)item[5] * exp(-y / (double)item[4]);
    }
    return sum * step / 3;
}

/* In double: the depth is the sum of the extinction, the event lies where the depth is -log(1 - u), and the
 * weight is what the way takes away. */
static void test_mist_depth(void **state) {
    static double results[8 * ORACLE_ITEMS];
    int events = 0;
    (void)state;
    random_state = 1;
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *a = inputs + 8 * i, *b = a + 4;
        b[0] = (float)(i % 4 ? pow(10, 2 * random_unit()) : 1e5);
        a[0] = (float)(2 * random_unit() - 1);
        a[1] = (float)(i % 8 ? 2 * random_unit() - 1 : 0);
        a[2] = (float)(8 * random_unit());
        a[3] = 0.5F;
        b[1] = (float)(i % 16 ? random_unit() : 0);
        b[2] = (float)random_unit();
        b[3] = (float)random_unit();
    }
    oracle_mist_double(inputs, 2 * ORACLE_ITEMS / 64, 64, results);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        const float *item = inputs + 8 * i;
        const double *got = results + 8 * i;
        double depth = mist_quadrature(item, (double)item[2]), wanted = -log1p(-(double)item[6]);
        assert_true(fabs(got[0] - depth) <= 2e-8 * depth);
        assert_true((got[1] >= 0) == (wanted < depth));
        if (got[1] >= 0) assert_true(fabs(mist_quadrature(item, got[1]) - wanted) < 1e-5 * wanted);
        double part = -log1p(-(double)item[7] * -expm1(-depth));
        assert_true(fabs(mist_quadrature(item, got[2]) - part) <= 1e-5 * part);
        assert_true(fabs(got[3] + expm1(-depth)) <= 2e-8 * got[3]);
        events += got[1] >= 0;
    }
    assert_true(events > ORACLE_ITEMS / 4);
}

/* Rays of up to 100 km through the air between surfaces, from the ground to within the ozone layer. */
static void set_air_rays(void) {
    random_state = 1;
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *a = inputs + 8 * i, *b = a + 4;
        b[0] = (float)(i % 4 ? 1 : 3e4 * random_unit());
        a[0] = (float)(i % 3 ? 5 * random_unit() : 4e3 * random_unit());
        a[1] = (float)(i % 8 ? (i % 2 ? 1 : -1) * pow(10, -4 * random_unit()) : 0);
        a[2] = (float)pow(10, 7 * random_unit() - 2);
        /* Down to the ground. */
        if (a[1] < 0) a[2] = fminf(a[2], -a[0] / a[1]);
        a[3] = (float)random_unit();
        for (int c = 1; c < 4; c++) b[c] = (float)random_unit();
    }
}

static void test_distance_noise(void **state) {
    static const OracleQuantity quantities[] = {
        {"noise", .result = 0, NEAR},        {"octaves", .result = 1, NEAR}, {"warp", .result = 2, NEAR},
        {"lines", .result = 3, NEAR},        {"polygon", .result = 4, NEAR}, {"glyphs", .result = 5, NEAR},
        {"noise vector", .result = 6, NEAR},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        for (int c = 0; c < 3; c++) inputs[8 * i + c] = (float)((i % 2 ? 1.2 : 5) * (2 * random_unit() - 1));
    }
    oracle_compare(&context, ORACLE(distance_noise), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

static void test_air(void **state) {
    static const OracleQuantity quantities[] = {
        {"red depth", .result = 0, .rms = 1e-6, .worst = 2e-5},
        {"green depth", .result = 1, .rms = 1e-6, .worst = 2e-5},
        {"blue depth", .result = 2, .rms = 1e-6, .worst = 2e-5},
        /* The number that chose the channel lets little of itself over where it is near to a third. */
        {"point", .result = 3, .floor = 1e-3, .rms = 3e-5, .worst = 3e-3, .jump = 1e-2,
         .most_set_aside = 1e-3},
        {"weight", .result = 4, .floor = 1e-3, .rms = 3e-5, .worst = 3e-3, .jump = 1e-2,
         .most_set_aside = 1e-3},
        {"event", .result = 5, .floor = 1e-3, .rms = 1e-4, .worst = 3e-3, .jump = 1e-2,
         .most_set_aside = 1e-2},
        {"event's weight", .result = 6, .floor = 1e-3, .rms = 1e-4, .worst = 3e-3, .jump = 1e-2,
         .most_set_aside = 1e-2},
        {"turn", .result = 7, .floor = 1, .rms = 1e-6, .worst = 1e-5},
    };
    start(state);
    set_air_rays();
    oracle_compare(&context, ORACLE(aerial), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

/* The extinction summed along the ray of an item by Simpson's rule. The ozone has corners: many steps. */
static double air_quadrature(const float *item, int channel) {
    static const double scatter[] = {5.8e-6, 13.5e-6, 33.1e-6}, ozone[] = {0.650e-6, 1.881e-6, 0.085e-6};
    enum { STEPS = 1000 };
    double sum = 0, step = (double)item[2] / STEPS;
    for (int i = 0; i <= STEPS; i++) {
        double h = (double)item[4] + (double)item[0] + i * step * (double)item[1];
        double extinction = scatter[channel] * exp(-h / 7994) + 23.1e-6 * exp(-h / 1200) +
                            ozone[channel] * fmax(1 - fabs(h - 25e3) / 15e3, 0);
        sum += (i == 0 || i == STEPS ? 1 : i % 2 ? 4 : 2) * extinction;
    }
    return sum * step / 3;
}

/* In double the depths are the sums of the extinction. */
static void test_air_depth(void **state) {
    static double results[8 * ORACLE_ITEMS];
    (void)state;
    set_air_rays();
    oracle_aerial_double(inputs, 2 * ORACLE_ITEMS / 64, 64, results);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        for (int c = 0; c < 3; c++) {
            double depth = air_quadrature(inputs + 8 * i, c);
            assert_true(fabs(results[8 * i + c] - depth) <= 2e-6 * depth);
        }
    }
}

/* Whole numbers, and floats made of them, are the same to the bit. */
static void test_sequences(void **state) {
    static const OracleQuantity quantities[] = {
        {"first x", .result = 0},  {"first y", .result = 1},  {"second x", .result = 2},
        {"second y", .result = 3}, {"hash's x", .result = 4}, {"hash's y", .result = 5},
        {"hash's z", .result = 6}, {"low bits", .result = 7},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *a = inputs + 8 * i;
        a[0] = (float)(i % 4096);
        a[1] = (float)(int)(4096 * random_unit());
        a[2] = (float)(int)(i % 2 ? 16777216 * random_unit() : 256 * random_unit());
        a[3] = (float)(i % 7);
    }
    oracle_compare(&context, ORACLE(sequence_random), inputs, quantities, COUNT(quantities));
    oracle_compare(&context, ORACLE(sequence_sobol), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

/* The steps of Markov chains. A distance is a whole number of 2^-24, which exp2() may round to the next one;
 * a number that is moved across an end of [0,1) jumps. */
static void test_chain_step(void **state) {
    static const OracleQuantity quantities[] = {
        {"moved", .result = 0, .floor = 1, .rms = 1e-7, .worst = 1.3e-7, .jump = 0.5, .most_set_aside = 1e-3},
        {"pair x", .result = 1, .floor = 1, .rms = 1e-7, .worst = 1.3e-7, .jump = 0.5,
         .most_set_aside = 1e-3},
        {"pair y", .result = 2, .floor = 1, .rms = 1e-7, .worst = 1.3e-7, .jump = 0.5,
         .most_set_aside = 1e-3},
        {"threshold", .result = 3},
        {"large", .result = 4},
        {"acceptance", .result = 5, .rms = 1e-7, .worst = 2e-7},
        {"choice", .result = 6, .rms = 1e-7, .worst = 3e-7},
        {"brightness", .result = 7, .rms = 1e-7, .worst = 3e-7},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *a = inputs + 8 * i;
        a[0] = (float)(i % 4096);
        a[1] = (float)(int)(16777216 * random_unit());
        a[2] = (float)(i % 7);
        a[3] = (float)(i % 16);
        for (int k = 4; k < 8; k++) a[k] = (float)(int)(16777215 * random_unit() + 1) / 16777216.0F;
    }
    oracle_compare(&context, ORACLE(chain_step), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

static void test_checker(void **state) {
    /* The colours themselves are rounded. */
    static const OracleQuantity quantities[] = {{"colour", .result = 1, .worst = 1e-7, .rms = 1e-7}};
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        double size = i % 2 ? 10 : 1e5;
        for (int c = 0; c < 3; c++) inputs[8 * i + c] = (float)(size * (2 * random_unit() - 1));
        if (i % 5 == 0) inputs[8 * i] = floorf(inputs[8 * i]);
    }
    oracle_compare(&context, ORACLE(checker), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

/* Bounces of metal, glass and the author's material. A density at a ball's edge is a jump, too. */
static void test_material(void **state) {
    static const OracleQuantity quantities[] = {
        {"metal's cosine", .result = 0, .condition = 3, .floor = 1, .rms = 1e-6, .worst = 1e-5,
         .most_set_aside = 0.1},
        {"metal's density", .result = 1, .condition = 3, .floor = 1e-2, .rms = 1e-6, .worst = 1e-5,
         .most_set_aside = 0.1},
        {"metal's weight", .result = 2, .condition = 3, .floor = 1, .rms = 1e-6, .worst = 1e-5,
         .most_set_aside = 0.1},
        {"glass's cosine", .result = 4, .condition = 6, .floor = 1, .rms = 1e-6, .worst = 1e-5, .jump = 1e-3,
         .most_set_aside = 0.01},
        {"author's density", .result = 5, .condition = 7, .floor = 1, .rms = 1e-5, .worst = 1e-3,
         .jump = 1e-2, .most_set_aside = 0.02},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *a = inputs + 8 * i;
        for (int c = 0; c < 4; c++) a[c] = (float)random_unit();
        a[4] = (float)fmax(random_unit(), 1e-3);
        a[5] = (float)(2 * pi * random_unit());
        a[6] = (float)(0.03 + 0.97 * random_unit());
        a[7] = (float)(i % 2 ? 1 + 1.5 * random_unit() : 1 / (1 + 1.5 * random_unit()));
    }
    oracle_compare(&context, ORACLE(material), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

/* Directions toward named spheres. Which one is drawn is a jump, and so is a sphere at the horizon. */
static void test_emission(void **state) {
    static const OracleQuantity quantities[] = {
        {"direction x", .result = 0, .condition = 4, .floor = 1, .rms = 1e-6, .worst = 1e-5, .jump = 1e-2,
         .most_set_aside = 0.02},
        {"direction y", .result = 1, .condition = 4, .floor = 1, .rms = 1e-6, .worst = 1e-5, .jump = 1e-2,
         .most_set_aside = 0.02},
        {"density", .result = 3, .condition = 4, .floor = 1e-2, .rms = 3e-6, .worst = 1e-4, .jump = 1e-2,
         .most_set_aside = 0.02},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *a = inputs + 8 * i, *at = a + 4;
        for (int c = 0; c < 2; c++) a[c] = (float)random_unit();
        a[2] = (float)(2 * random_unit() - 1);
        a[3] = (float)(2 * pi * random_unit());
        for (int c = 0; c < 3; c++) at[c] = (float)((i % 2 ? 3 : 30) * (2 * random_unit() - 1));
    }
    oracle_compare(&context, ORACLE(emission), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

/* Directions through a rectangle, and its solid angle: near and far, flat and upright. Where it is drawn by
 * area or by solid angle is a jump. In its plane a rounding of the place moves it in or out of sight. */
static void test_rectangle(void **state) {
    static const OracleQuantity quantities[] = {
        {"direction x", .result = 0, .condition = 3, .floor = 1, .rms = 1e-6, .worst = 1e-4, .jump = 1e-2,
         .most_set_aside = 0.05},
        {"direction y", .result = 1, .condition = 3, .floor = 1, .rms = 1e-6, .worst = 1e-4, .jump = 1e-2,
         .most_set_aside = 0.05},
        {"solid angle", .result = 4, .condition = 3, .floor = 1, .rms = 1e-6, .worst = 1e-5,
         .most_set_aside = 0.05},
        {"density", .result = 5, .condition = 3, .floor = 1, .rms = 3e-6, .worst = 1e-4, .jump = 1e-2,
         .most_set_aside = 0.05},
        {"density of the drawn", .result = 7, .condition = 3, .floor = 1, .rms = 3e-6, .worst = 1e-4,
         .jump = 1e-2, .most_set_aside = 0.05},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *a = inputs + 8 * i, *at = a + 4;
        for (int c = 0; c < 2; c++) a[c] = (float)random_unit();
        a[2] = (float)(360 * random_unit());
        a[3] = (float)(180 * random_unit() - 90);
        for (int c = 0; c < 3; c++) at[c] = (float)((i % 2 ? 2 : 10) * (2 * random_unit() - 1));
        at[3] = (float)(0.2 + 3 * random_unit());
    }
    oracle_compare(&context, ORACLE(rectangle), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

/* Alhazen's point, at the sphere and far from it. */
static void test_mirror_sphere(void **state) {
    static const OracleQuantity quantities[] = {
        {"direction x", .result = 0, .condition = 7, .floor = 1, .rms = 1e-6, .worst = 1e-5,
         .most_set_aside = 0.01},
        {"direction z", .result = 2, .condition = 7, .floor = 1, .rms = 1e-6, .worst = 1e-5,
         .most_set_aside = 0.01},
        {"focus", .result = 3, .condition = 7, .floor = 1e-3, .rms = 1e-5, .worst = 3e-4,
         .most_set_aside = 0.02, .jump = 1e-3},
        {"normal y", .result = 5, .condition = 7, .floor = 1, .rms = 1e-6, .worst = 1e-5,
         .most_set_aside = 0.01},
    };
    start(state);
    for (int i = 0; i < ORACLE_ITEMS; i++) {
        float *point = inputs + 8 * i, *light = point + 4;
        double r = 1 + pow(10, 4 * random_unit() - 2);
        set_any_direction(point);
        set_any_direction(light);
        for (int c = 0; c < 3; c++) point[c] *= (float)r;
    }
    oracle_compare(&context, ORACLE(mirror_sphere), inputs, quantities, COUNT(quantities));
    context_close(&context);
}

enum { TABLE_COLUMNS = 256, TABLE_ROWS = 64, TABLE_FLOATS = 4 * TABLE_COLUMNS * TABLE_ROWS, SPHERES = 250 };

/* Spheres of all sizes in a cube, some within others, and some in a row along x. */
static void make_spheres(float *spheres) {
    for (int i = 0; i < SPHERES; i++) {
        for (int c = 0; c < 3; c++) spheres[4 * i + c] = (float)(4 * random_unit() - 2);
        spheres[4 * i + 3] = (float)(0.3 * pow(10, -3 * random_unit()));
        if (i % 10 == 0) spheres[4 * i + 1] = spheres[4 * i + 2] = 0.25F;
    }
}

static void set_ray(float *ray, const double origin[3], const double toward[3]) {
    double length = sqrt(toward[0] * toward[0] + toward[1] * toward[1] + toward[2] * toward[2]);
    for (int c = 0; c < 3; c++) {
        ray[c] = (float)origin[c];
        ray[4 + c] = (float)(toward[c] / length);
        /* Zeros of both signs. */
        if (toward[c] == 0 && random_unit() < 0.5) ray[4 + c] = -0.0F;
    }
}

/* From a sphere's inside or its surface, anywhere. */
static void set_ray_from(const float *sphere, double radii, float *ray) {
    float out[3], any[3];
    double origin[3], toward[3];
    set_any_direction(out);
    set_any_direction(any);
    for (int c = 0; c < 3; c++) {
        origin[c] = (double)sphere[c] + radii * (double)(sphere[3] * out[c]);
        toward[c] = (double)any[c];
    }
    set_ray(ray, origin, toward);
}

/* Past a sphere by about its radius. */
static void set_ray_grazing(const float *sphere, float *ray) {
    float any[3];
    double origin[3], toward[3], side[3], far = 0, along = 0, across = 0;
    set_any_direction(any);
    for (int c = 0; c < 3; c++) {
        origin[c] = 8 * random_unit() - 4;
        toward[c] = (double)sphere[c] - origin[c];
        far += toward[c] * toward[c];
        along += toward[c] * (double)any[c];
    }
    for (int c = 0; c < 3; c++) {
        side[c] = (double)any[c] - along / far * toward[c];
        across += side[c] * side[c];
    }
    double radius = (double)sphere[3] * (1 + 0.01 * (2 * random_unit() - 1));
    for (int c = 0; c < 3; c++) toward[c] += radius * side[c] / sqrt(across);
    set_ray(ray, origin, toward);
}

/* Along an axis or one of its planes, toward a sphere's middle or in the face of its box. */
static void set_ray_level(const float *sphere, float *ray) {
    double origin[3], toward[3] = {0}, side = random_unit() < 0.5 ? -1 : 1;
    int axis = (int)(3 * random_unit());
    toward[axis] = side;
    if (random_unit() < 0.5) toward[(axis + 1) % 3] = 0.5 * random_unit();
    for (int c = 0; c < 3; c++) origin[c] = (double)sphere[c] - 4 * toward[c];
    if (random_unit() < 0.5) {
        float face = side < 0 ? sphere[(axis + 2) % 3] - sphere[3] : sphere[(axis + 2) % 3] + sphere[3];
        origin[(axis + 2) % 3] = (double)face;
    }
    set_ray(ray, origin, toward);
}

/* What trees and boxes find hard. */
static void set_hard_ray(int kind, const float *sphere, float *ray) {
    if (kind == 0) set_ray_from(sphere, 0.9, ray);
    if (kind == 1) set_ray_from(sphere, 1, ray);
    if (kind == 2) set_ray_from(sphere, 20, ray);
    if (kind == 3) set_ray_grazing(sphere, ray);
    if (kind >= 4) set_ray_level(sphere, ray);
}

/* The rays that a tree answers otherwise than all spheres asked one by one. */
static int count_differences(const char *what, const double *results) {
    int differences = 0, hits = 0, most = 0;
    double steps = 0;
    for (int i = TABLE_FLOATS / 2; i < TABLE_FLOATS; i += 8) {
        const double *r = results + i;
        differences += r[0] != r[1] || r[2] != r[3] || r[4] != r[5] || !(r[6] < 1e-6);
        hits += r[0] < 1e29;
        steps += r[7];
        most = r[7] > most ? (int)r[7] : most;
    }
    int rays = TABLE_FLOATS / 16;
    print_message("spheres, %s: %d of %d rays hit, %d differ; %.1f entries a ray, at most %d\n", what, hits,
                  rays, differences, steps / rays, most);
    assert_true(hits > rays / 4 && hits < rays);
    assert_true(steps / rays < SPHERES / 4);
    return differences;
}

static void test_spheres(void **state) {
    static float spheres[4 * SPHERES], gpu[TABLE_FLOATS];
    static double results[TABLE_FLOATS];
    start(state);
    make_spheres(spheres);
    SphereTree tree = sphere_tree_create(spheres, SPHERES);
    assert_true(2 * 4 * SPHERE_TREE_OCTANTS * 2 * tree.entries < TABLE_FLOATS);
    memcpy(inputs, tree.texels, (size_t)(4 * 2 * SPHERE_TREE_OCTANTS * tree.entries) * sizeof *inputs);
    inputs[TABLE_FLOATS / 2 - 4] = (float)tree.entries;
    sphere_tree_destroy(&tree);
    for (int i = 0; i < TABLE_FLOATS / 16; i++)
        set_hard_ray(i % 6, spheres + 4 * (i / 6 % SPHERES), inputs + TABLE_FLOATS / 2 + 8 * i);
    oracle_evaluate_gpu(&context, ORACLE(spheres), inputs, TABLE_COLUMNS, TABLE_ROWS, gpu);
    for (int i = 0; i < TABLE_FLOATS; i++) results[i] = (double)gpu[i];
    assert_int_equal(count_differences("GPU", results), 0);
    ORACLE(spheres).in_float(inputs, TABLE_COLUMNS, TABLE_ROWS, results);
    assert_int_equal(count_differences("C++ float", results), 0);
    ORACLE(spheres).in_double(inputs, TABLE_COLUMNS, TABLE_ROWS, results);
    assert_int_equal(count_differences("C++ double", results), 0);
    context_close(&context);
}

enum { SIDE = 32, PIXELS = SIDE * SIDE };

/* Paths split on an edge: a rounding decides what is hit, and all that follows differs. So pixels are
 * counted. */
static void check_picture(OracleCase oracle) {
    static float gpu[4 * PIXELS];
    static double in_float[4 * PIXELS], in_double[4 * PIXELS];
    double mean[3] = {0}, squares = 0;
    int split = 0, same = 0;
    float *scene = inputs, *light = inputs + 4;
    scene[0] = 0.5f, scene[1] = 0.8f, scene[2] = 0.1f, scene[3] = 16;
    set_direction(light, 0.5, 0.3);
    light[3] = 32;
    oracle_evaluate_gpu(&context, oracle, inputs, SIDE, SIDE, gpu);
    oracle.in_float(inputs, SIDE, SIDE, in_float);
    oracle.in_double(inputs, SIDE, SIDE, in_double);
    for (int i = 0; i < PIXELS; i++) {
        double worst = 0;
        for (int c = 0; c < 3; c++) {
            int k = 4 * i + c;
            mean[0] += (double)gpu[k] / (3 * PIXELS);
            mean[1] += in_float[k] / (3 * PIXELS);
            mean[2] += in_double[k] / (3 * PIXELS);
            worst = fmax(worst, fabs((double)gpu[k] - in_float[k]) / fmax(in_float[k], 1e-6));
        }
        if (worst > 1e-3) {
            split++;
        } else {
            same++;
            squares += worst * worst;
        }
    }
    print_message(
        "%s: %d of %d pixels split, the others' RMS %.1e; means %.6f GPU, %.6f float, %.6f double\n",
        oracle.name, split, PIXELS, sqrt(squares / fmax(same, 1)), mean[0], mean[1], mean[2]);
    assert_true(mean[2] > 0);
    assert_true(split <= PIXELS / 20);
    assert_true(sqrt(squares / same) < 3e-5);
    assert_true(fabs(mean[0] / mean[1] - 1) < 1e-3 && fabs(mean[0] / mean[2] - 1) < 1e-3);
}

static void test_paths(void **state) {
    start(state);
    check_picture(ORACLE(crater_uniform));
    check_picture(ORACLE(crater_cosine));
    check_picture(ORACLE(crater_paper));
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_phase),         cmocka_unit_test(test_atmosphere),
        cmocka_unit_test(test_paper),         cmocka_unit_test(test_gauss),
        cmocka_unit_test(test_shape),         cmocka_unit_test(test_solids),
        cmocka_unit_test(test_march),         cmocka_unit_test(test_distance),
        cmocka_unit_test(test_distance_more), cmocka_unit_test(test_distance_noise),
        cmocka_unit_test(test_air),           cmocka_unit_test(test_air_depth),
        cmocka_unit_test(test_mist),          cmocka_unit_test(test_mist_depth),
        cmocka_unit_test(test_lobes),         cmocka_unit_test(test_mirror_sphere),
        cmocka_unit_test(test_sequences),     cmocka_unit_test(test_chain_step),
        cmocka_unit_test(test_checker),       cmocka_unit_test(test_material),
        cmocka_unit_test(test_spheres),       cmocka_unit_test(test_emission),
        cmocka_unit_test(test_rectangle),     cmocka_unit_test(test_paths),
    };
    return cmocka_run_group_tests_name("oracle", tests, support_folder, support_clean);
}
