/* The sun's disk: its reflection in a sphere, the light that the sphere throws, its exact image, and what the
 * ground gets. */
#include "random.h"
#include "support.h"
#include "ztest.h"

#include "gl/texture.h"
#include "sky/sky_sampler.h"
#include "sky/sun_disk.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 128, TEXELS = SIDE * SIDE };

static const double pi = 3.14159265358979323846, degree = 3.14159265358979323846 / 180;
static float inputs[4 * TEXELS], results[8 * TEXELS];

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalise(double v[3]) {
    double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++) v[i] /= length;
}

/* Where light from `light` that meets the unit sphere at `normal` is, after `t`. */
static void throw_light(const double normal[3], const double light[3], double t, double point[3],
                        double direction[3]) {
    double cosine = dot(normal, light);
    for (int i = 0; i < 3; i++) direction[i] = 2 * cosine * normal[i] - light[i];
    for (int i = 0; i < 3; i++) point[i] = normal[i] + t * direction[i];
}

/* The inverse is simple: choose the reflection point, and see where its light goes. The focus is the ratio of
 * the areas that a small patch of the sphere has across the light before and after, by differences. */
static void test_reflection(void **state) {
    (void)state;
    static double normals[TEXELS][3], focus[TEXELS], distances[TEXELS];
    const double light[3] = {0.48, 0.6, 0.64};
    Context context;
    random_state = 3;
    double worst[2] = {0}, squares = 0;
    support_open(&context);
    for (int i = 0; i < TEXELS; i++) {
        double *n = normals[i], side[3], other[3], p[3][3], d[3], t = pow(10, 3 * random_unit() - 1.5),
               step = 1e-6;
        do {
            for (int k = 0; k < 3; k++) n[k] = 2 * random_unit() - 1;
        } while (dot(n, n) > 1 || dot(n, n) < 0.01);
        normalise(n);
        if (dot(n, light) < 0)
            for (int k = 0; k < 3; k++) n[k] = -n[k];
        for (int k = 0; k < 3; k++)
            side[k] = n[(k + 1) % 3] * light[(k + 2) % 3] - n[(k + 2) % 3] * light[(k + 1) % 3];
        normalise(side);
        for (int k = 0; k < 3; k++)
            other[k] = n[(k + 1) % 3] * side[(k + 2) % 3] - n[(k + 2) % 3] * side[(k + 1) % 3];
        for (int c = 0; c < 3; c++) {
            double m[3];
            for (int k = 0; k < 3; k++) m[k] = n[k] + step * (c == 1 ? side[k] : c == 2 ? other[k] : 0);
            normalise(m);
            throw_light(m, light, t, p[c], d);
        }
        throw_light(n, light, t, p[0], d);
        double a[3], b[3], across[3];
        for (int k = 0; k < 3; k++) a[k] = p[1][k] - p[0][k], b[k] = p[2][k] - p[0][k];
        for (int k = 0; k < 3; k++)
            across[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
        focus[i] = dot(n, light) * step * step / fabs(dot(across, d));
        distances[i] = sqrt(dot(p[0], p[0])) - 1;
        for (int k = 0; k < 3; k++) inputs[4 * i + k] = (float)p[0][k];
    }
    for (int pass = 0; pass < 2; pass++) {
        char glsl[512];
        snprintf(glsl, sizeof glsl,
                 "#include \"sun/mirror_sphere.glsl\"\nuniform sampler2D inputs;\nvec4 evaluate(vec2 t) {\n"
                 "    SphereReflection r = sphere_reflection(texelFetch(inputs, ivec2(t), 0).xyz, vec3(0.48, "
                 "0.6, 0.64));\n"
                 "    return %s;\n}",
                 pass ? "vec4(r.direction, 0)" : "vec4(r.normal, r.focus)");
        support_evaluate(&context, glsl, inputs, SIDE, SIDE, results);
        for (int i = 0; i < TEXELS; i++) {
            double point[3], direction[3], error = 0;
            if (distances[i] < 0.01) continue; /* touching, float says little */
            throw_light(normals[i], light, 1, point, direction);
            for (int k = 0; k < 3; k++)
                error += pow((double)results[4 * i + k] - (pass ? direction[k] : normals[i][k]), 2);
            worst[pass] = fmax(worst[pass], sqrt(error));
            if (!pass)
                squares += pow(((double)results[4 * i + 3] - focus[i]) / fmax(focus[i], 1e-6), 2) / TEXELS;
        }
    }
    print_message("reflection point off by at most %.1e, direction %.1e; focus RMS %.1e\n", worst[0],
                  worst[1], sqrt(squares));
    assert_true(worst[0] < 2e-4 && worst[1] < 4e-4 && sqrt(squares) < 2e-3);
    context_close(&context);
}

/* The crater without its uniforms, and the light's way from the ball to a point. */
static const char crater[] = "#include \"shape/plane_minus_sphere.glsl\"\n#include "
                             "\"shape/sphere.glsl\"\n#include \"sun/mirror_sphere.glsl\"\n"
                             "#include \"math/hash.glsl\"\n"
                             "Hit nearest(Ray ray) {\n    Hit hit = hit_none();\n"
                             "    hit_plane_minus_sphere(ray, vec3(0, 1, 0), 0.0, vec3(0), 2.0, 0, hit);\n"
                             "    hit_sphere(ray, vec3(0, 0.5, 0), 1.0, 1, hit);\n    hit.position = "
                             "ray.origin + hit.t * ray.direction;\n"
                             "    return hit;\n}\n";

/* Of the light that the ball receives, how much falls on the plane and how much in the crater: rays from the
 * sun, followed; and the irradiance that every point finds for itself by Alhazen's point, summed over the
 * ground. */
static void test_caustic_energy(void **state) {
    (void)state;
    static const struct {
        double elevation, plane, bowl; /* measured apart, to 0.005 */
    } cases[] = {{30, 0.22, 0.28}, {60, 0.30, 0.20}};
    Context context;
    support_open(&context);
    for (int k = 0; k < 2; k++) {
        char glsl[4096];
        double forward[2] = {0}, backward[2] = {0}, e = cases[k].elevation * degree;
        snprintf(glsl, sizeof glsl,
                 "%s\nvec4 evaluate(vec2 t) {\n    vec3 light = vec3(0, %.9f, %.9f), side = vec3(1, 0, 0), "
                 "up = cross(light, side);\n"
                 "    vec4 landed = vec4(0);\n    for (int i = 0; i < 64; i++) {\n"
                 "        uvec3 h = hash_3(uvec3(uvec2(t), uint(i)));\n"
                 "        float r = sqrt(unit_float(h.x)), a = 2.0 * PI * unit_float(h.y);\n"
                 "        Hit hit = nearest(Ray(vec3(0, 0.5, 0) + 20.0 * light + r * cos(a) * side + r * "
                 "sin(a) * up, -light));\n"
                 "        if (hit.object != 1) continue;\n"
                 "        Hit next = nearest(ray_from(hit, reflect(-light, hit.normal)));\n"
                 "        if (next.t < INFINITY) landed += next.normal.y > 0.9999 ? vec4(1, 0, 0, 0) : "
                 "vec4(0, 1, 0, 0);\n"
                 "    }\n    return landed / 64.0;\n}",
                 crater, sin(e), cos(e));
        support_evaluate(&context, glsl, NULL, SIDE, SIDE, results);
        for (int i = 0; i < TEXELS; i++)
            for (int c = 0; c < 2; c++) forward[c] += (double)results[4 * i + c] / TEXELS;
        /* Left half of the texels: the plane, by 2 / (1 - u)^2 from the rim outward; right half: the bowl, by
         * solid angle. */
        snprintf(glsl, sizeof glsl,
                 "%s\nvec4 evaluate(vec2 t) {\n    vec3 light = vec3(0, %.9f, %.9f);\n    float sum = 0.0;\n "
                 "   bool plane = t.x < 64.0;\n"
                 "    for (int i = 0; i < 64; i++) {\n"
                 "        float u = (mod(t.x, 64.0) + (float(i / 8) + 0.5) / 8.0) / 64.0, a = 2.0 * PI * "
                 "(t.y + (float(i %% 8) + 0.5) / 8.0) / 128.0;\n"
                 "        float r = 2.0 / ((1.0 - u) * (1.0 - u));\n"
                 "        vec3 p = plane ? vec3(r * cos(a), 0, r * sin(a)) : 2.0 * vec3(sqrt(1.0 - u * u) * "
                 "cos(a), -u, sqrt(1.0 - u * u) * sin(a));\n"
                 "        vec3 n = plane ? vec3(0, 1, 0) : -0.5 * p;\n"
                 "        float area = plane ? 2.0 * PI * r * 4.0 / pow(1.0 - u, 3.0) : 2.0 * PI * 4.0;\n"
                 "        SphereReflection s = sphere_reflection(p - vec3(0, 0.5, 0), light);\n"
                 "        Hit from = Hit(length(p), p, n, 0, 0, false);\n"
                 "        Hit ball = nearest(ray_from(from, -s.direction));\n"
                 "        bool sees = ball.object == 1 && nearest(ray_from(ball, light)).t >= INFINITY;\n"
                 "        sum += sees ? area * s.focus * max(-dot(n, s.direction), 0.0) : 0.0;\n"
                 "    }\n    return vec4(sum / 64.0);\n}",
                 crater, sin(e), cos(e));
        support_evaluate(&context, glsl, NULL, SIDE, SIDE, results);
        for (int i = 0; i < TEXELS; i++)
            backward[i % SIDE < 64 ? 0 : 1] += (double)results[4 * i] / (TEXELS / 2) / pi;
        print_message(
            "sun %g: plane %.4f, crater %.4f of the ball's light; found by the ground %.4f and %.4f\n",
            cases[k].elevation, forward[0], forward[1], backward[0], backward[1]);
        assert_true(fabs(forward[0] - cases[k].plane) < 0.006 && fabs(forward[1] - cases[k].bowl) < 0.006);
        assert_true(fabs(backward[0] / forward[0] - 1) < 0.01 && fabs(backward[1] / forward[1] - 1) < 0.01);
    }
    context_close(&context);
}

/* A pixel's mean radiance by 600 x 600 points. */
static void cover_by_points(const SunDisk *disk, const Atmosphere *atmosphere, const Camera *camera, int x,
                            int y, double mean[3]) {
    enum { POINTS = 600 };
    memset(mean, 0, 3 * sizeof *mean);
    for (int i = 0; i < POINTS * POINTS; i++) {
        double px = x + (i % POINTS + 0.5) / POINTS, py = y + (i / POINTS + 0.5) / POINTS, d[3], radiance[3];
        for (int k = 0; k < 3; k++)
            d[k] = camera->forward[k] + (2 * px / camera->width - 1) * camera->right[k] +
                   (1 - 2 * py / camera->height) * camera->up[k];
        normalise(d);
        if (dot(d, disk->middle) < cos(1.01 * disk->radius)) continue;
        sun_disk_radiance(disk, atmosphere, d, radiance);
        for (int k = 0; k < 3; k++) mean[k] += radiance[k] / (POINTS * POINTS);
    }
}

static void test_cover(void **state) {
    (void)state;
    static const struct {
        double sun[2], eye_to[3], fov;
        int width, height;
        double observer_m;
    } cases[] = {{{30, 0}, {0, 0.5, 1}, 90, 512, 512, 1},
                 {{30, 20}, {0, 0.3, 1}, 120, 640, 360, 1},
                 {{0, 0}, {0, 0, 1}, 60, 512, 512, 1},
                 {{5, 1}, {0, 0.1, 1}, 3, 64, 64, 1},
                 {{89.9, 0}, {0, 1, 0.3}, 40, 200, 200, 1},
                 {{0.2, 10}, {0.1, 0.1, 1}, 20, 300, 200, 1},
                 /* The horizon may be more than 90 degrees below the disk. */
                 {{89.97, 0}, {0, 1, 0}, 2, 64, 64, 1},
                 {{90, 0}, {0, 1, 0}, 2, 64, 64, 1},
                 {{90, 0}, {0, 1, 0.3}, 40, 200, 200, 1},
                 {{85, 0}, {0, 10, 1}, 2, 64, 64, 59000}};
    double worst = 0;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        Scene scene = scene_default("test", "glsl");
        Atmosphere atmosphere = atmosphere_preset(0)->atmosphere;
        atmosphere.observer_height_m = cases[k].observer_m;
        memset(scene.values.camera.eye, 0, sizeof scene.values.camera.eye);
        memcpy(scene.values.camera.target, cases[k].eye_to, sizeof scene.values.camera.target);
        scene.values.camera.fov_deg = cases[k].fov;
        Camera camera = camera_of(&scene, cases[k].width, cases[k].height);
        Sun sun = sun_at(cases[k].sun[0], cases[k].sun[1], 0.2666);
        SunDisk disk = sun_disk(&atmosphere, &sun);
        Rectangle r = camera_cone_rectangle(&camera, disk.middle, disk.radius);
        assert_true(r.width > 0 && r.height > 0);
        float *cover = calloc((size_t)r.width * (size_t)r.height, 4 * sizeof *cover), brightest = 0;
        assert_true(sun_disk_cover(&disk, &atmosphere, &camera, r, cover));
        for (int i = 0; i < r.width * r.height; i++) brightest = fmaxf(brightest, cover[4 * i]);
        assert_true(brightest > 0);
        for (int i = 0; i < 8; i++) {
            int x = (i * 7919) % r.width, y = (i * 104729 + i) % r.height;
            double mean[3];
            cover_by_points(&disk, &atmosphere, &camera, r.x + x, r.y + y, mean);
            for (int c = 0; c < 3; c++) {
                double error = fabs((double)cover[4 * (y * r.width + x) + c] - mean[c]) / (double)brightest;
                worst = fmax(worst, error);
            }
        }
        free(cover);
        scene_destroy(&scene);
    }
    print_message("exact cover against 360,000 points a pixel: off by at most %.1e of the brightest pixel\n",
                  worst);
    assert_true(worst < 2e-3);
}

/* Level ground in the open: albedo / pi times the sky's irradiance and the sun's, both known to 1e-8. */
static void test_ground(void **state) {
    (void)state;
    static const struct {
        double elevation, sky[3], sun[3];
    } rows[] = {{30, {0.74108465, 1.06504174, 1.52084062}, {17.254015, 15.2636723, 11.1727889}},
                {5, {0.438286042, 0.54702361, 0.513725046}, {9.16478613, 4.91135661, 1.00365562}}};
    for (int i = 0; i < 2; i++) {
        Image image;
        Error error;
        double mean[3] = {0};
        if (support_run("",
                        "render scenes/crater.glsl --quiet --sun-disk --sun %g --size 16x16 --spp 64 --set "
                        "ball=0 --set camera.eye=80,2,0 "
                        "--set camera.target=80,0,0 --set camera.fov=10 --set even_albedo=0.8 --set "
                        "odd_albedo=0.8 --light control -o '%s'",
                        rows[i].elevation, support_path("ground.pfm")) == STATUS_NO_GL)
            support_no_gl(support_err);
        assert_true(image_read(&image, support_path("ground.pfm"), &error));
        for (int k = 0; k < 3 * 256; k++) mean[k % 3] += (double)image.rgba[4 * (k / 3) + k % 3] / 256;
        for (int c = 0; c < 3; c++) {
            double expected = 0.8 / pi * (rows[i].sky[c] + rows[i].sun[c] * sin(rows[i].elevation * degree));
            print_message("sun %g, channel %d: %.6f, expected %.6f\n", rows[i].elevation, c, mean[c],
                          expected);
            assert_true(fabs(mean[c] / expected - 1) < 1e-3);
        }
        image_free(&image);
    }
}

/* Shares in whole numbers: none lost, none given to nothing, each to one bin. */
static void test_shares(void **state) {
    (void)state;
    enum { CELLS = 1000 };
    static double weights[CELLS];
    static int bins[CELLS];
    random_state = 9;
    double total = 0;
    int sum = 0;
    for (int i = 0; i < CELLS; i++) total += weights[i] = i % 3 ? pow(random_unit(), 6) : 0;
    sky_sampler_share(weights, CELLS, bins);
    for (int i = 0; i < CELLS; i++) {
        sum += bins[i];
        assert_true((bins[i] > 0) == (weights[i] > 0));
        assert_true(fabs(bins[i] - weights[i] / total * SKY_BINS) < 2 + 0.03 * bins[i]);
    }
    assert_int_equal(sum, SKY_BINS);
}

static const char sampler_shader[] =
    "#version 330 core\n#include \"pass/sky_sampler.glsl\"\n#include \"math/hash.glsl\"\n"
    "uniform int drawn;\nout vec4 result;\nvoid main() {\n    vec2 t = floor(gl_FragCoord.xy);\n"
    "    uvec3 h = hash_3(uvec3(uvec2(t), 5u));\n"
    "    vec3 d = sky_sample(vec2(unit_float(h.x), unit_float(h.y)));\n"
    "    if (drawn == 0) d = sky_cell_sample(sky_cells(), t, vec2(0.5), 1.0);\n"
    "    result = vec4(drawn == 0 ? d.y : dot(d.xz, sun_level.xz) * inversesqrt(dot(d.xz, d.xz)), d.y, "
    "sky_pdf(d),\n"
    "                  drawn == 0 ? sky_cell_solid_angle(sky_cells(), t.y) : dot(d, d));\n}";

static bool make_text(const void *slots, const char *entry, GlslSource *source, Error *error) {
    return support_flatten(source, "glsl", entry, ((const SlotList *)slots)->slots, error);
}

/* Directions drawn from the sky against their density: it sums to 1, and a chi-square over groups of cells.
 */
static void test_sky_sampler(void **state) {
    (void)state;
    static const double suns[] = {90, 60, 30, 10, 5, 2, 0, -2, -4, -6};
    Context context;
    static const ResourceKind *const kinds[] = {&sky_table, &sky_patches, &sky_sampler, NULL};
    Resources tables;
    SlotList slots = {0};
    MethodChoice choice, light;
    Program program;
    GlslSource source;
    Error error;
    Atmosphere atmosphere = atmosphere_preset(0)->atmosphere;
    GLuint target, framebuffer;
    support_open(&context);
    const GlApi *gl = &context.gl;
    const char *path = support_write("sampler.glsl", sampler_shader);
    assert_true(method_choose(&choice, METHOD_SKY, "table", &error) &&
                method_choose(&light, METHOD_LIGHT, "mis", &error));
    sky_slots(&slots, &choice, &atmosphere);
    Frame frame = {.state = {atmosphere, sun_at(0, 0, 0.2666)}, .sky = &choice, .light = &light};
    ResourceTexts texts = {make_text, &slots};
    assert_true(resources_create(&tables, &context, kinds, &frame, &texts, &error) &&
                support_flatten(&source, "glsl", path, slots.slots, &error));
    if (!program_create(&program, gl, &source, &error)) fail_msg("%s", error.text);
    glsl_source_destroy(&source);
    gl->GenFramebuffers(1, &framebuffer);
    target = texture_create(gl, SIDE, SIDE, GL_NEAREST, NULL);
    for (int k = 0; k < 20; k++) {
        enum { COLUMNS = 16, ROWS = 24, GROUPS = COLUMNS * ROWS };
        Uniforms uniforms = {0};
        double expected[GROUPS] = {0}, sum = 0, chi2 = 0, horizon = sky_horizon_sine(&atmosphere);
        int counts[GROUPS] = {0}, freedom = -1;
        frame.state.sun = sun_at(suns[k / 2], k % 2 ? 137 : 0, 0.2666);
        sky_uniforms(&frame, &uniforms);
        assert_true(resources_prepare(&tables, &frame, &uniforms, &error));
        program_use(&program);
        program_set(&program, &uniforms);
        resources_give(&tables, &program);
        uniforms_free(&uniforms);
        for (int drawn = 0; drawn < 2; drawn++) {
            gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
            gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
            gl->Viewport(0, 0, SIDE, SIDE);
            program_set_int(&program, "drawn", drawn);
            program_draw(&program, 0, 0, SIDE, SIDE);
            gl->ReadBuffer(GL_COLOR_ATTACHMENT0);
            gl->ReadPixels(0, 0, SIDE, SIDE, GL_RGBA, GL_FLOAT, results);
            for (int i = 0; i < TEXELS; i++) {
                const float *v = results + 4 * i;
                int x = i % SIDE, y = i / SIDE;
                if (!drawn && (x >= PATCH_COLUMNS || y >= PATCH_ROWS)) continue;
                if (!drawn) expected[y / 4 * COLUMNS + x / 4] += (double)v[2] * (double)v[3];
                if (!drawn) continue;
                bool below = (double)v[1] < horizon;
                double w = sqrt(fmax(((double)v[1] - horizon) / ((below ? -1 : 1) - horizon), 0));
                int row = below ? PATCH_ROWS_ABOVE + (int)fmin(w * PATCH_ROWS_BELOW, PATCH_ROWS_BELOW - 1)
                                : (int)fmin(w * PATCH_ROWS_ABOVE, PATCH_ROWS_ABOVE - 1);
                int column =
                    (int)fmin(acos(fmax(fmin((double)v[0], 1), -1)) / pi * PATCH_COLUMNS, PATCH_COLUMNS - 1);
                counts[row / 4 * COLUMNS + column / 4]++;
                assert_true(fabsf(v[3] - 1) < 1e-5f && v[2] > 0);
            }
        }
        for (int i = 0; i < GROUPS; i++) {
            sum += expected[i];
            if (expected[i] * TEXELS < 5) continue;
            chi2 += pow(counts[i] - expected[i] * TEXELS, 2) / (expected[i] * TEXELS);
            freedom++;
        }
        double deviations = ztest_chi_square(chi2, freedom);
        if (fabs(sum - 1) > 1e-4 || fabs(deviations) > ztest_limit(20))
            fail_msg("sun %g,%g: density sums to %.6f; chi-square %.1f deviations off",
                     frame.state.sun.elevation_deg, frame.state.sun.azimuth_deg, sum, deviations);
    }
    gl->DeleteFramebuffers(1, &framebuffer);
    gl->DeleteTextures(1, &target);
    program_destroy(&program);
    resources_destroy(&tables);
    slot_list_free(&slots);
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reflection), cmocka_unit_test(test_caustic_energy),
        cmocka_unit_test(test_cover),      cmocka_unit_test(test_ground),
        cmocka_unit_test(test_shares),     cmocka_unit_test(test_sky_sampler),
    };
    return cmocka_run_group_tests_name("sun", tests, support_folder, support_clean);
}
