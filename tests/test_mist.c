/* Mist: what its annotation may say, how it turns light, what it lets through, and its switch. */
#include "mist.h"
#include "support.h"
#include "ztest.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static double mean_of(const char *scene, const char *arguments) {
    double means[3];
    Image image = mist_render("", scene, arguments);
    mist_means(&image, means, NULL);
    image_free(&image);
    return means[0];
}

/* Each fault is told with its line and with what to do. */
static void test_errors(void **state) {
    (void)state;
    static const struct {
        const char *annotation, *error;
    } cases[] = {
        {"//@ mist albedo 0.5 0.5 0.5 below 2", ":3: mist needs extinction"},
        {"//@ mist extinction", ":3: mist: extinction needs the share"},
        {"//@ mist extinction below 2", ":3: mist: extinction needs the share"},
        {"//@ mist extinction 0.1", ":3: mist of one density that has no end would hide the sky"},
        {"//@ mist extinction -0.1 below 2", ":3: mist: '-0.1' is neither a number from 0 to 1e+06"},
        {"//@ mist extinction thick below 2", ":3: mist: 'thick' is neither a number from 0 to 1e+06"},
        {"//@ mist extinction -dense below 2", ":3: mist: the slider 'dense' goes from 0 to 1, past"},
        {"//@ mist extinction wide below 2",
         ":3: mist: the slider 'wide' goes from -1 to 8, past 0 to 1e+06"},
        {"//@ mist extinction 0.1 0.2 below 2",
         ":3: mist: extinction needs the share of the light that a metre takes away, 1/m, or three"},
        {"//@ mist extinction 0.1 0.2 0.3 0.4 below 2", ":3: mist: unknown key '0.4'"},
        {"//@ mist extinction 0.1 wide dense below 2",
         ":3: mist: the slider 'wide' goes from -1 to 8, past 0"},
        {"//@ mist extinction 0.1 0.2 -0.3 below 2", ":3: mist: '-0.3' is neither a number from 0"},
        {"//@ mist extinction 0.1 0.2 0.3", ":3: mist of one density that has no end"},
        {"uniform float g; //@ slider 0.2\n//@ mist extinction g below 2",
         ":4: mist: extinction needs the share of the light that a metre takes away, 1/m, or three for red, "
         "green and blue; "
         "'g' is a key of mist, so that a slider needs another name"},
        {"//@ mist extinction 0.1 extinction 0.2 below 2", ":3: mist: extinction is there twice"},
        {"//@ mist extinction 0.1 albedo 0.9 below 2", ":3: mist: albedo needs red, green and blue"},
        {"//@ mist extinction 0.1 albedo 0.9 0.9 1.1 below 2",
         ":3: mist: '1.1' is neither a number from 0 to 1 "},
        {"//@ mist extinction 0.1 g 1 below 2", ":3: mist: '1' is neither a number from -0.99 to 0.99"},
        {"//@ mist extinction 0.1 sphere 0 0 0 0", ":3: mist: '0' is neither a number from 0.001"},
        {"//@ mist extinction 0.1 sphere 0 0 0 wide",
         ":3: mist: the slider 'wide' goes from -1 to 8, past 0.001"},
        {"//@ mist extinction 0.1 box 0 0 0 1 1", ":3: mist: box needs x y z and the half size"},
        {"//@ mist extinction 0.1 below 1 sphere 0 0 0 1", ":3: mist: 'sphere' is a second region"},
        {"//@ mist extinction 0.1 base 1 below 2", ":3: mist: base is for mist that thins with height"},
        {"//@ mist extinction 0.1 falloff 0", ":3: mist: '0' is neither a number from 0.001"},
        {"//@ mist extinction 0.1 phase mie below 2", ":3: mist: phase needs henyey or shanks"},
        {"//@ mist extinction 0.1 phase shanks phase shanks below 2", ":3: mist: phase is there twice"},
        {"//@ mist off extinction 0.1 0.2 below 2", ":3: mist: extinction needs the share"},
        {"//@ mist extinction 0.1 off below 2", ":3: mist: unknown key 'off'"},
        {"//@ mist extinction 0.1 fallof 2", ":3: mist: unknown key 'fallof': did you mean falloff?"},
        {"//@ mist extinction 0.1 below 1\n//@ mist extinction 0.2 below 2",
         ":4: there is mist in line 3 already"},
        {"uniform float mist; //@ slider 1\n//@ mist extinction 0.1 below 1",
         ":4: mist is switched by a parameter of its name: uniform 'mist' is declared twice"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *scene = mist_ball("wrong.glsl", cases[i].annotation, "0.5");
        int status = support_run("", "info '%s'", scene);
        if (status != STATUS_SCENE || !strstr(support_err, cases[i].error))
            fail_msg("%s: status %d, \"%s\" lacks \"%s\"", cases[i].annotation, status, support_err,
                     cases[i].error);
    }
}

/* Mist that is switched off is not there, to the bit, by --set and by a preset; a scene without it has no
 * such setting. Light paths are refused while it is on. */
static void test_switch(void **state) {
    (void)state;
    static const char arguments[] = "--size 24x24 --spp 16 --sun-disk";
    const char *clear = mist_ball("clear.glsl", "", "0.5");
    const char *misty =
        mist_ball("misty.glsl", "//@ mist extinction dense falloff 2\n//@ preset clear mist off", "0.5");
    Image wanted = mist_render("", clear, arguments);
    static const char *const ways[] = {"--set mist=off", "--preset clear", ""};
    for (int i = 0; i < 3; i++) {
        char words[256];
        snprintf(words, sizeof words, "%s %s", arguments, ways[i]);
        Image got = mist_render("", misty, words);
        bool same = memcmp(got.rgba, wanted.rgba, sizeof(float[4 * 24 * 24])) == 0;
        if (same != (i < 2)) fail_msg("'%s': the picture is %s as without mist", ways[i], same ? "" : "not");
        image_free(&got);
    }
    const char *off =
        mist_ball("off.glsl", "//@ mist off extinction dense falloff 2\n//@ preset foggy mist on", "0.5");
    const char *on = mist_ball("on.glsl", "//@ mist extinction dense falloff 2", "0.5");
    static const char *const switched[][2] = {
        {"", "--set mist=off"}, {"--preset foggy", ""}, {"--set mist=on", ""}};
    for (int i = 0; i < 3; i++) {
        char words[256];
        snprintf(words, sizeof words, "%s %s", arguments, switched[i][0]);
        Image a = mist_render("", off, words);
        snprintf(words, sizeof words, "%s %s", arguments, switched[i][1]);
        Image b = mist_render("", on, words);
        assert_memory_equal(a.rgba, b.rgba, sizeof(float[4 * 24 * 24]));
        image_free(&a);
        image_free(&b);
    }
    image_free(&wanted);
    support_expect(STATUS_USAGE, "has no setting 'mist'", "render '%s' --set mist=off -o '%s'", clear,
                   support_path("none.pfm"));
    support_expect(STATUS_USAGE, "--sun-disk traced: light paths are not scattered by mist, which",
                   "render '%s' --sun-disk=traced -o '%s'", misty, support_path("none.pfm"));
    assert_int_equal(support_run("", "info '%s'", misty), 0);
    assert_non_null(strstr(support_out, "mist extinction dense albedo 1 1 1 g 0 falloff 2 base 0"));
    assert_non_null(strstr(support_out, "--set mist=1"));
}

/* The scene's own density: it needs the annotation, and values out of its range are said. */
static void test_density(void **state) {
    (void)state;
    static const struct {
        const char *annotations, *says;
        int status;
    } cases[] = {
        {"float scene_mist(vec3 p) { return 0.5; }", ":1: scene_mist() needs `//@ mist extinction E`",
         STATUS_SCENE},
        {"//@ mist extinction 0.2 below 2\nfloat scene_mist(vec3 p) { return 0.5 + 0.5 * sin(9.0 * p.x); }",
         NULL, 0},
        {"//@ mist extinction 0.2 below 2\nfloat scene_mist(vec3 p) { return p.x > 0.0 ? 1.5 : 0.5; }",
         "scene_mist() leaves the range from 0 to 1 by 0.5;", 0},
        {"//@ mist extinction 0.2 falloff 2\nfloat scene_mist(vec3 p) { return p.x > 0.0 ? -0.25 : 0.5; }",
         "scene_mist() leaves the range from 0 to 1 by 0.25;", 0},
        {"//@ mist extinction 0.2 falloff 2\n//@ preset a mist off\nfloat scene_mist(vec3 p) { return 2.0; }",
         "scene_mist() leaves the range from 0 to 1 by 1;", 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *scene = mist_ball("density.glsl", cases[i].annotations, "0.5");
        int status =
            support_run("", "render '%s' --size 24x24 --spp 2 -o '%s'", scene, support_path("density.pfm"));
        if (status == STATUS_NO_GL) support_no_gl(support_err);
        bool said = strstr(support_err, cases[i].says ? cases[i].says : "scene_mist") != NULL;
        if (status != cases[i].status || said != (cases[i].says != NULL))
            fail_msg("%s: status %d, \"%s\"", cases[i].annotations, status, support_err);
    }
}

/* Tracks that end after their 64 steps are said, with the light that comes through for this. */
static void test_cut_tracks(void **state) {
    (void)state;
    static const struct {
        const char *mist, *share;
        bool said;
    } cases[] = {
        {"extinction 4 sphere 0 0 0 4", "0.001", false},
        {"extinction 20 sphere 0 0 0 4", "0.001", true},
        {"extinction 20 sphere 0 0 0 4", "0.5", false},
        {"extinction 20 5 0.1 sphere 0 0 0 4", "0.5", true},
        {"extinction 20 0.1 20 sphere 0 0 0 4", "1.0", true},
        {"extinction 20 20 15 sphere 0 0 0 4", "1.0", false},
        {"extinction 0.1 below 1", "0.01", true},
        {"extinction 0.1 below 1", "0.5", false},
        {"extinction 20 falloff 0.2", "0.01", true},
        {"extinction 20 box 0 0 0 0.2 0.2 0.2", "0.01", false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char annotations[256];
        snprintf(annotations, sizeof annotations, "//@ mist %s\nfloat scene_mist(vec3 p) { return %s; }",
                 cases[i].mist, cases[i].share);
        const char *scene = mist_ball("cut.glsl", annotations, "0.5");
        support_expect(0, "", "render '%s' --size 24x24 --spp 2 -o '%s'", scene, support_path("cut.pfm"));
        bool said = strstr(support_err, "cut.glsl:3: tracks through mist end after 64 steps: on ") != NULL;
        if (said != cases[i].said) fail_msg("%s, %s: \"%s\"", cases[i].mist, cases[i].share, support_err);
    }
    /* Each way of a depth of 160 is cut. 0.99^64 comes through in place of exp(-1.6): 32 % too much. */
    const char *scene = mist_ball("known.glsl",
                                  "//@ mist extinction 20 sphere 0 9 0 4\n"
                                  "float scene_mist(vec3 p) { return 0.01; }",
                                  "0.5");
    support_expect(0, "",
                   "render '%s' --size 24x24 --spp 2 -o '%s' --set camera.eye=0,9,-9 --set "
                   "camera.target=0,9,0 --set camera.fov=0.01",
                   scene, support_path("cut.pfm"));
    if (!strstr(support_err, "on 100 % of the ways") || !strstr(support_err, " should, 32 % of all."))
        fail_msg("\"%s\"", support_err);
}

/* Each phase function integrates to 1, is what its samples weigh, and has the mean cosine that is stated;
 * Cornette and Shanks's is larger. */
static void test_phase(void **state) {
    (void)state;
    enum { SIDE = 512, TEXELS = SIDE * SIDE, BINS = 64 };
    static const double forwards[] = {0, 0.001, 0.6, -0.6, 0.95};
    static float results[4 * TEXELS];
    Context context;
    support_open(&context);
    for (int i = 0; i < 10; i++) {
        double g = forwards[i / 2], total = 0, mean = 0, sampled[BINS] = {0}, expected[BINS] = {0}, chi2 = 0;
        char glsl[4096];
        snprintf(glsl, sizeof glsl,
                 "#include \"math/hash.glsl\"\n#include \"mist/phase_%s.glsl\"\nconst float g = float(%g);\n"
                 "vec4 evaluate(vec2 t) {\n    vec3 axis = normalize(vec3(0.3, -0.8, 0.5));\n"
                 "    float w = (t.y * 512.0 + t.x + 0.5) / 131072.0 - 1.0;\n"
                 "    vec3 out_ = in_frame(axis, sqrt(1.0 - w * w), 0.0, w);\n"
                 "    float value = henyey_pdf(g, axis, out_) * mist_phase_weight(g, w);\n"
                 "    uvec3 h = hash_3(uvec3(uvec2(t), 7u));\n"
                 "    vec3 drawn = henyey_sample(g, axis, vec2(unit_float(h.x), unit_float(h.y)));\n"
                 "    float c = dot(axis, drawn);\n"
                 "    return vec4(4.0 * PI * value, w, c, mist_phase_weight(g, c));\n}",
                 i % 2 ? "shanks" : "henyey", g);
        support_evaluate(&context, glsl, NULL, SIDE, SIDE, results);
        for (int k = 0; k < TEXELS; k++) {
            const float *v = results + 4 * k;
            total += (double)v[0] / TEXELS;
            mean += (double)v[0] * (double)v[1] / TEXELS;
            expected[(int)fmin(32 + 32 * (double)v[1], 63)] += (double)v[0];
            sampled[(int)fmin(fmax(32 + 32 * (double)v[2], 0), 63)] += (double)v[3];
        }
        for (int k = 0; k < BINS; k++)
            chi2 += pow(sampled[k] - expected[k], 2) / (expected[k] * (i % 2 ? 1.5 : 1));
        double wanted = i % 2 ? 3 * g * (4 + g * g) / (5 * (2 + g * g)) : g;
        print_message("g %g, %s: integral %.5f, mean cosine %.4f, chi-square %.0f of %d\n", g,
                      i % 2 ? "Cornette and Shanks" : "Henyey and Greenstein", total, mean, chi2, BINS);
        assert_true(fabs(total - 1) < 2e-3 && fabs(mean - wanted) < 2e-3);
        assert_true(ztest_chi_square(chi2, BINS - 1) < ztest_limit(10));
    }
    context_close(&context);
}

/* Black mist before a sky of 1 lets through exp(-depth), whatever its shape, wherever the camera is. */
static void test_transmittance(void **state) {
    (void)state;
    static const struct {
        const char *mist, *camera;
        double depth;
    } cases[] = {
        {"extinction 0.1 sphere 0 5 0 3", "0,5,-10", 0.6},
        {"extinction 0.1 sphere 0 5 0 3", "0,5,0", 0.3},
        {"extinction 0.1 box 0 5 0 2 1 4", "0,5,-10", 0.8},
        {"extinction 0.1 box 0 5 0 2 1 4", "0,5,10", 0},
        {"extinction 0.1 falloff 2 base 5 box 0 5 0 2 1 4", "0,5,-10", 0.8},
        {"extinction 0.1 falloff 2 base 5 sphere 0 7 0 5", "0,7,0", 0.18393972},
        {"extinction 0.1 falloff 1e5 base 5 sphere 0 5 0 3", "0,5,-10", 0.6},
        {"extinction 0 sphere 0 5 0 3", "0,5,-10", 0},
        {"extinction 0 falloff 2", "0,5,-10", 0},
        {"extinction dense phase shanks g 0.5 sphere 0 5 0 3", "0,5,-10", 1.2},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char annotation[256], arguments[256];
        snprintf(annotation, sizeof annotation, "//@ sky uniform:1\n//@ mist albedo 0 0 0 %s", cases[i].mist);
        /* Straight on, along +z, and so little upward that no ray meets the ground. */
        double y = 0;
        sscanf(cases[i].camera, "0,%lf", &y);
        snprintf(
            arguments, sizeof arguments,
            "--size 16x16 --spp 256 --set camera.eye=%s --set camera.target=0,%g,100 --set camera.fov=0.05",
            cases[i].camera, y + 0.1);
        double mean = mean_of(mist_ball("black.glsl", annotation, "0"), arguments),
               wanted = exp(-cases[i].depth);
        print_message("%s from %s: %.4f, wanted %.4f\n", cases[i].mist, cases[i].camera, mean, wanted);
        assert_true(fabs(mean - wanted) <= 5 * sqrt(wanted * (1 - wanted) / (256 * 256)));
    }
}

static void means_of(const char *scene, const char *arguments, double mean[3]) {
    Image image = mist_render("", scene, arguments);
    mist_means(&image, mean, NULL);
    image_free(&image);
}

/* Black mist whose extinction has a colour lets through exp(-depth) of each channel, also of those of which
 * it takes none. */
static void test_colour(void **state) {
    (void)state;
    static const struct {
        const char *mist;
        double depths[3];
    } cases[] = {
        {"extinction 0.05 0.2 0.5 sphere 0 5 0 3", {0.3, 1.2, 3}},
        {"extinction 0 0.1 dense sphere 0 5 0 3", {0, 0.6, 1.2}},
        {"extinction 0 0 0.3 sphere 0 5 0 3", {0, 0, 1.8}},
        {"extinction 0 0 dense sphere 0 5 0 3\nfloat scene_mist(vec3 p) { return 0.5; }", {0, 0, 0.6}},
        {"extinction 0 0 0.0 sphere 0 5 0 3", {0, 0, 0}},
        {"extinction 0.1 0.2 0.3 falloff 2 base 5 box 0 5 0 2 1 4", {0.8, 1.6, 2.4}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char annotation[256];
        double mean[3];
        snprintf(annotation, sizeof annotation, "//@ sky uniform:1\n//@ mist albedo 0 0 0 %s", cases[i].mist);
        means_of(mist_ball("black.glsl", annotation, "0"),
                 "--size 16x16 --spp 256 --set camera.eye=0,5,-10 --set camera.target=0,5.1,100 --set "
                 "camera.fov=0.05",
                 mean);
        print_message("%s: %.4f %.4f %.4f\n", cases[i].mist, mean[0], mean[1], mean[2]);
        for (int c = 0; c < 3; c++) {
            /* Samples weigh at most 3. */
            double wanted = exp(-cases[i].depths[c]);
            assert_true(fabs(mean[c] - wanted) <= 5 * sqrt(wanted * fabs(3 - wanted) / (256 * 256)) + 1e-6);
        }
    }
}

/* A channel of coloured mist is as bright as mist that has its extinction in all channels. Three equal words
 * are one, to the bit. */
static void test_channels(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"sphere 0 1 0 5", "--light cosine"},
        {"sphere 0 1 0 5", "--light mis --sun-disk"},
        {"falloff 2", "--light control"},
        {"falloff 2\nfloat scene_mist(vec3 p) { return fract(p.x); }", "--light cosine --sun-disk"},
    };
    static const double extinctions[] = {0.05, 0.2, 0.5};
    const char *one = mist_ball("one.glsl", "//@ mist extinction 0.2 below 2", "0.5");
    Image a = mist_render("", one, "--size 24x24 --spp 4");
    Image b = mist_render("", mist_ball("three.glsl", "//@ mist extinction 0.2 0.2 0.2 below 2", "0.5"),
                          "--size 24x24 --spp 4");
    assert_memory_equal(a.rgba, b.rgba, sizeof(float[4 * 24 * 24]));
    image_free(&a);
    image_free(&b);
    for (int i = 0; i < 4; i++) {
        double coloured[3], grey[3], square[3] = {0}, sum[3] = {0};
        char annotation[256], arguments[128];
        enum { SEEDS = 8 };
        for (int seed = 0; seed < SEEDS; seed++) {
            snprintf(annotation, sizeof annotation,
                     "//@ mist g 0.5 albedo 0.9 0.8 0.7 extinction 0.05 0.2 0.5 %s", cases[i][0]);
            snprintf(arguments, sizeof arguments, "--size 24x24 --spp %d --seed %d %s",
                     (int)support_samples(128), seed, cases[i][1]);
            means_of(mist_ball("coloured.glsl", annotation, "0.5"), arguments, coloured);
            for (int c = 0; c < 3; c++) {
                snprintf(annotation, sizeof annotation, "//@ mist g 0.5 albedo 0.9 0.8 0.7 extinction %g %s",
                         extinctions[c], cases[i][0]);
                snprintf(arguments, sizeof arguments, "--size 24x24 --spp %d --seed %d %s",
                         (int)support_samples(128), seed + 100, cases[i][1]);
                means_of(mist_ball("grey.glsl", annotation, "0.5"), arguments, grey);
                double off = coloured[c] / grey[c] - 1;
                sum[c] += off / SEEDS;
                square[c] += off * off / SEEDS;
            }
        }
        for (int c = 0; c < 3; c++) {
            double error = sqrt(fmax(square[c] - sum[c] * sum[c], 0) / (SEEDS - 1));
            print_message("%s, %s, channel %d: %+.3f %%, standard error %.3f %%\n", cases[i][0], cases[i][1],
                          c, 100 * sum[c], 100 * error);
            /* Seven errors of eight seeds are met once in 5000 cases. */
            assert_true(fabs(sum[c]) < 7 * error + 1e-4 && error < 0.006 * support_block());
        }
    }
}

/* A material of this name, which does as matte does. */
static const char *write_own_material(const char *name, const char *capitals, const char *annotation) {
    char path[64], text[2048];
    snprintf(path, sizeof path, "material/%s.glsl", name);
    snprintf(text, sizeof text,
             "#include \"material/matte.glsl\"\n"
             "Material %s(vec3 albedo) { return material_new(MATERIAL_%s, albedo); }\n"
             "Bounce %s_sample(Material m, vec3 normal, vec3 incoming, vec2 u, vec2 v) {\n"
             "    return matte_sample(m, normal, incoming, u, v);\n}\n"
             "float %s_pdf(Material m, vec3 normal, vec3 incoming, vec3 outgoing) {\n"
             "    return matte_pdf(m, normal, incoming, outgoing);\n}\n"
             "vec3 %s_value(Material m, vec3 normal, vec3 incoming, vec3 outgoing) {\n"
             "    return matte_value(m, normal, incoming, outgoing);\n}\n",
             name, capitals, name, name, name);
    support_write(path, text);
    snprintf(text, sizeof text,
             "%s\n#include \"material/%s.glsl\"\nMaterial own(vec3 albedo) { return %s(albedo); }",
             annotation, name, name);
    return mist_ball("own.glsl", text, "0.5)).kind < 0 ? own(vec3(0.5)) : matte(vec3(0.4");
}

/* A scene may have a material named `mist` or `air` beside the library's mist and air, and functions of such
 * names. One that the library has itself is told with both places. */
static void test_own_names(void **state) {
    (void)state;
    static const char *const annotations[] = {"//@ mist extinction 0.2 below 2", "//@ air on", ""};
    assert_int_equal(mkdir(support_path("material"), 0777), 0);
    for (int i = 0; i < 6; i++) {
        const char *scene =
            write_own_material(i % 2 ? "air" : "mist", i % 2 ? "AIR" : "MIST", annotations[i / 2]);
        support_expect(0, "", "render '%s' --size 8x8 --spp 1 -o '%s'", scene, support_path("own.pfm"));
    }
    const char *scene =
        mist_ball("own.glsl", "//@ mist extinction 0.2 below 2\nbool mist_here() { return false; }", "0.5");
    support_expect(STATUS_SCENE, "", "render '%s' --size 8x8 --spp 1 -o '%s'", scene,
                   support_path("own.pfm"));
    if (!strstr(support_err, "mist_here") || !strstr(support_err, "own.glsl:4 has the name mist_here too"))
        fail_msg("%s", support_err);
    unlink(support_path("material/mist.glsl"));
    unlink(support_path("material/air.glsl"));
    rmdir(support_path("material"));
}

/* explain says in words what the mist is, with the values of its sliders. */
static void test_explain(void **state) {
    (void)state;
    static const struct {
        const char *annotations, *arguments, *says;
    } cases[] = {
        {"//@ mist extinction dense albedo 0.9 0.8 0.7 g 0.5 sphere 0 1 0 3", "",
         "\nmist: a sphere of 3 m about 0,1,0\n  a metre of it takes away the share 0.2 of the light "
         "(extinction, 1/m): light goes 5 m through it on average (mean free path)\n  of the light that it "
         "takes away it scatters the share 0.9 0.8 0.7 (red, green, blue) (albedo) and absorbs the rest;\n  "
         "most of it goes on forward (phase function of Henyey and Greenstein, mean cosine 0.5)\n"},
        {"//@ mist off extinction 0.1 0.2 0.4 phase shanks g -0.5 falloff 3 base -dense", "--set dense=0.5",
         "\nmist, switched off here: everywhere\n  a metre of it takes away the share 0.1 0.2 0.4 (red, "
         "green, "
         "blue) of the light (extinction, 1/m): light goes 10 5 2.5 (red, green, blue) m through it on "
         "average "
         "(mean free path);\n  so much at the height -0.5 m, and in each 3 m of height it thins to 1/e\n  of "
         "the "
         "light that it takes away it scatters the share 1 (albedo) and absorbs the rest;\n  most of it is "
         "sent back (phase function of Cornette and Shanks, mean cosine -0.5)\n"},
        {"//@ mist extinction 0 box 0 1 0 2 1 2\nfloat scene_mist(vec3 p) { return 0.5; }", "",
         "\nmist: a box of 4 x 2 x 4 m about 0,1,0\n  a metre of it takes away the share 0 of the light "
         "(extinction, 1/m);\n  scene_mist() says how much of this is there at a place, from 0 to 1\n"},
        {"//@ mist extinction 1 below 2", "", "\nmist: all below a height of 2 m\n"},
        {"//@ air on", "--atmosphere simmons2017",
         "\nair: the atmosphere's own, between the surfaces\n  at the height 0 light goes 34.6 27.3 17.8 "
         "(red, "
         "green, blue) km through it on average (mean free path), and it thins to 1/e in 7.99 km"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char annotations[256];
        snprintf(annotations, sizeof annotations, "//@ sky uniform:1\n%s", cases[i].annotations);
        const char *scene = mist_ball("words.glsl", annotations, "0.5");
        assert_int_equal(support_run("", "explain '%s' --size 8x8 %s", scene, cases[i].arguments), 0);
        if (!strstr(support_out, cases[i].says)) fail_msg("%s: \"%s\"", cases[i].says, support_out);
    }
    const char *scene = mist_ball("words.glsl", "//@ sky uniform:1", "0.5");
    assert_int_equal(support_run("", "explain '%s' --size 8x8", scene), 0);
    assert_null(strstr(support_out, "\nmist"));
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_errors),        cmocka_unit_test(test_switch),
        cmocka_unit_test(test_density),       cmocka_unit_test(test_phase),
        cmocka_unit_test(test_transmittance), cmocka_unit_test(test_colour),
        cmocka_unit_test(test_channels),      cmocka_unit_test(test_cut_tracks),
        cmocka_unit_test(test_own_names),     cmocka_unit_test(test_explain),
    };
    return cmocka_run_group_tests_name("mist", tests, support_folder, support_clean);
}
