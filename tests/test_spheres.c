/* Many spheres: the tree, files and annotations that are wrong, and pictures of them. */
#include "random.h"
#include "support.h"

#include "render/aov.h"
#include "render/spheres.h"
#include "scene/sphere_file.h"
#include "scene/sphere_tree.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MANY = 100000, WIDTH = 96, HEIGHT = 64, PIXELS = WIDTH * HEIGHT };

/* One list, as it is walked. */
typedef struct Walk {
    const float *entries, *spheres;
    int octant;
    int *seen; /* how often each sphere */
} Walk;

/* The entries [at, end) lie within the box: nested boxes, and spheres that are what they were. */
static void check_entries(const Walk *walk, int at, int end, const double low[3], const double high[3]) {
    while (at < end) {
        const float *entry = walk->entries + 8 * at;
        double inner_low[3], inner_high[3];
        bool sphere = entry[7] == 0;
        int number = (int)entry[4];
        for (int c = 0; c < 3; c++) {
            double near = (double)entry[c], far = (double)entry[4 + c], radius = (double)entry[3];
            bool negative = walk->octant >> c & 1;
            inner_low[c] = sphere ? near - radius : negative ? far : near;
            inner_high[c] = sphere ? near + radius : negative ? near : far;
            assert_true(inner_low[c] >= low[c] && inner_high[c] <= high[c] && inner_low[c] <= inner_high[c]);
        }
        if (sphere) {
            assert_memory_equal(entry, walk->spheres + 4 * number, 4 * sizeof *entry);
            walk->seen[number]++;
            at++;
        } else {
            int skip = (int)entry[7];
            assert_true(skip > 1 && at + skip <= end);
            check_entries(walk, at + 1, at + skip, inner_low, inner_high);
            at += skip;
        }
    }
}

/* All eight lists have each sphere once, but for those of no radius. */
static int check_tree(const float *spheres, int count) {
    static const double low[3] = {-INFINITY, -INFINITY, -INFINITY}, high[3] = {INFINITY, INFINITY, INFINITY};
    SphereTree tree = sphere_tree_create(spheres, count);
    int *seen = calloc((size_t)count + 1, sizeof *seen), entries = tree.entries;
    for (int octant = 0; octant < SPHERE_TREE_OCTANTS; octant++) {
        Walk walk = {tree.texels + (size_t)octant * (size_t)entries * 8, spheres, octant, seen};
        check_entries(&walk, 0, entries, low, high);
        for (int i = 0; i < count; i++) assert_int_equal(seen[i], (octant + 1) * (spheres[4 * i + 3] > 0));
    }
    free(seen);
    sphere_tree_destroy(&tree);
    return entries;
}

static void make_spheres(float *spheres, int count, double size, double decades) {
    random_state = 3;
    for (int i = 0; i < count; i++) {
        for (int c = 0; c < 3; c++) spheres[4 * i + c] = (float)(size * (2 * random_unit() - 1));
        spheres[4 * i + 3] = (float)(0.01 * size * pow(10, -decades * random_unit()));
    }
}

static void test_tree(void **state) {
    (void)state;
    float *spheres = malloc(4 * MANY * sizeof *spheres);
    static const int counts[] = {0, 1, 2, 3, 8, 9, 100, 1000};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        make_spheres(spheres, counts[i], 10, 1);
        assert_true(check_tree(spheres, counts[i]) <= 2 * counts[i]);
    }
    /* Sizes over twelve decades, far from the origin; places over thirty decades; one place; one line; absent
     * ones. */
    make_spheres(spheres, 1000, 1e6, 12);
    check_tree(spheres, 1000);
    for (int i = 0; i < 1000; i++) spheres[4 * i] = (float)pow(10, -30 + 36 * i / 1000.0);
    check_tree(spheres, 1000);
    for (int i = 0; i < 4000; i++) spheres[i] = (float[]){1, 2, 3, 0.5F}[i % 4];
    check_tree(spheres, 1000);
    for (int i = 0; i < 1000; i++) spheres[4 * i + 1] = (float)i;
    check_tree(spheres, 1000);
    for (int i = 0; i < 1000; i += 3) spheres[4 * i + 3] = i % 2 ? 0 : -1;
    check_tree(spheres, 1000);
    for (int i = 0; i < 1000; i++) spheres[4 * i + 3] = 0;
    assert_int_equal(check_tree(spheres, 1000), 0);
    make_spheres(spheres, MANY, 10, 2);
    clock_t start = clock();
    SphereTree tree = sphere_tree_create(spheres, MANY);
    double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    print_message("a tree of %d spheres in %.3f s, %.2f entries a sphere\n", MANY, seconds,
                  (double)tree.entries / MANY);
    assert_true(seconds < 5);
    sphere_tree_destroy(&tree);
    check_tree(spheres, MANY);
    free(spheres);
}

/* Two heaps along an axis: each list begins with the nearer one. */
static void test_near_first(void **state) {
    (void)state;
    float spheres[4 * 100];
    for (int axis = 0; axis < 3; axis++) {
        make_spheres(spheres, 100, 1, 0);
        for (int i = 0; i < 100; i++) spheres[4 * i + axis] += i % 2 ? 50 : -50;
        SphereTree tree = sphere_tree_create(spheres, 100);
        for (int octant = 0; octant < SPHERE_TREE_OCTANTS; octant++) {
            const float *entry = tree.texels + (size_t)octant * (size_t)tree.entries * 8;
            while (entry[7] > 0) entry += 8;
            assert_true((entry[axis] > 0) == (octant >> axis & 1));
        }
        sphere_tree_destroy(&tree);
    }
}

static bool read_file(const char *path, int most, float **spheres, int *count, Error *error) {
    SourceStore *store = source_store_create("glsl");
    source_store_choose(store, path);
    const SourceFile *file;
    *spheres = NULL;
    bool ok =
        source_store_read(store, path, &file, error) && sphere_file_parse(file, most, spheres, count, error);
    source_store_release(store);
    return ok;
}

static void test_file(void **state) {
    (void)state;
    float *spheres;
    int count;
    Error error;
    const char *good = support_write("good.csv", "\xef\xbb\xbf# of balls\r\n x,y,z,radius\r\n\r\n1, "
                                                 "-2,3e0,0.5\r\n# one more\n4,5,6,7,a colour\n8,9,10,11");
    if (!read_file(good, 3, &spheres, &count, &error)) fail_msg("%s", error.text);
    assert_int_equal(count, 3);
    static const float expected[] = {1, -2, 3, 0.5F, 4, 5, 6, 7, 8, 9, 10, 11};
    assert_memory_equal(spheres, expected, sizeof expected);
    free(spheres);
    static const struct {
        const char *text, *part;
    } bad[] = {
        {"x,y,z,radius\n1,2,3\n", "bad.csv:2: a row needs x,y,z,radius"},
        {"1,2,3,4\n\n#\n1,2,nan,4\n",
         "bad.csv:4: z: 'nan' is not a number, and one from -1e+07 to 1e+07 is needed"},
        {"1,2,3,0\n", "bad.csv:1: radius: '0' is not above 0"},
        {"1,2,3,-1\n", "bad.csv:1: radius: '-1' is not above 0"},
        {"1,2,3,1e-60\n", "bad.csv:1: radius: '1e-60' is not above 0"},
        {"1,2,1e8,1\n", "bad.csv:1: z: 1e8 is outside the range from -1e+07 to 1e+07"},
        {"1,,3,4\n", "bad.csv:1: y: '' is not a number"},
        {"1,2,3,4\nx,y,z,radius\n", "bad.csv:2: x: 'x' is not a number"},
        {"1 2 3 4\n", "bad.csv:1: x: '1 2 3 4' is not a number"},
        {"1,1,1,1\n2,2,2,2\n3,3,3,3\n4,4,4,4\n", "bad.csv:4: more than 3 spheres"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(read_file(support_write("bad.csv", bad[i].text), 3, &spheres, &count, &error));
        assert_null(spheres);
        assert_int_equal(error.status, STATUS_SCENE);
        if (!strstr(error.text, bad[i].part)) fail_msg("%s: %s", bad[i].text, error.text);
    }
    assert_false(read_file(support_path("none.csv"), 3, &spheres, &count, &error));
    assert_non_null(strstr(error.text, "none.csv: cannot be read: "));
}

/* A scene: the annotation on line 1, the call of a shape, and on the last line what makes the spheres. */
static const char *scene(const char *name, const char *spheres, const char *call, const char *makes) {
    char text[4096];
    snprintf(text, sizeof text,
             "%s\n"
             "//@ camera eye 0 2 -6 target 0 0.5 0 fov 40\n"
             "#include \"material/matte.glsl\"\n"
             "#include \"math/hash.glsl\"\n"
             "#include \"shape/plane.glsl\"\n"
             "#include \"shape/spheres.glsl\"\n"
             "uniform float many; //@ slider 60 min 0 max 100000\n"
             "vec4 scene_sphere(int i);\n"
             "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
             "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n"
             "    %s\n"
             "}\n"
             "Material scene_material(Hit hit) {\n"
             "    return matte(hit.object == 7 ? vec3(hash_3(uvec3(uint(hit.item) + 1u)) >> 8u) / 16777216.0 "
             ": vec3(0.5));\n"
             "}\n"
             "%s\n",
             spheres, call, makes);
    return support_write(name, text);
}

static const char together[] = "hit_spheres(ray, 7, hit);";
static const char each[] = "for (int i = 0; i < 60; i++) { float t = hit.t; vec4 s = scene_sphere(i); if "
                           "(s.w > 0.0) hit_sphere(ray, vec3(s), s.w, 7, hit); "
                           "if (hit.t < t) hit.item = i; }";
static const char made[] =
    "vec4 scene_sphere(int i) { vec3 u = vec3(hash_3(uvec3(uint(i))) >> 8u) / 16777216.0;"
    " return vec4(4.0 * u - vec3(2.0, 1.0, 2.0), i % 7 == 3 ? -0.2 : 0.1 + 0.3 * u.x * u.y); }";

static void render(const char *scene_path, const char *picture, const char *more) {
    support_expect(0, "", "render %s -o %s --size %dx%d --spp 16 --quiet %s", scene_path,
                   support_path(picture), WIDTH, HEIGHT, more);
}

static double difference(const char *a, const char *b) {
    support_expect(0, "", "compare %s %s", support_path(a), support_path(b));
    const char *found = strstr(support_out, "relRMSE");
    if (!found) fail_msg("%s", support_out);
    return atof(found + strcspn(found, "0123456789"));
}

static void need_gl(void) {
    Context context;
    support_open(&context);
    context_close(&context);
}

/* Made by the scene, and each sphere asked by itself: the same picture, with the sun too. */
static void test_picture(void **state) {
    (void)state;
    need_gl();
    render(scene("each.glsl", "", each, made), "each.exr", "");
    render(support_path("each.glsl"), "each_sun.exr", "--sun-disk");
    render(scene("made.glsl", "//@ spheres many", together, made), "made.exr", "");
    render(support_path("made.glsl"), "made_sun.exr", "--sun-disk");
    render(scene("number.glsl", "//@ spheres 60", together, made), "number.exr", "--set many=3");
    render(support_path("made.glsl"), "few.exr", "--set many=30.9");
    render(scene("none.glsl", "//@ spheres many", together, made), "none.exr", "--set many=0");
    render(scene("ground.glsl", "", "", made), "ground.exr", "");
    print_message("relRMSE %g %%, with the sun %g %%, by a number %g %%; of half of the spheres %g %%\n",
                  difference("made.exr", "each.exr"), difference("made_sun.exr", "each_sun.exr"),
                  difference("number.exr", "each.exr"), difference("few.exr", "each.exr"));
    assert_true(difference("made.exr", "each.exr") < 1e-3);
    assert_true(difference("made_sun.exr", "each_sun.exr") < 1e-3);
    assert_true(difference("number.exr", "each.exr") < 1e-3);
    assert_true(difference("few.exr", "each.exr") > 5);
    assert_true(difference("none.exr", "ground.exr") < 1e-3);
}

/* The layers of a picture of 7 floats a pixel. */
static void read_layers(const Context *context, const char *path, float *layers) {
    Scene read;
    Renderer renderer;
    Aov aov;
    Error error;
    unsigned kinds;
    if (!scene_read(&read, path, "glsl", &error)) fail_msg("%s", error.text);
    RenderParams params = {.scene = &read, .width = WIDTH, .height = HEIGHT};
    Image image = {.width = WIDTH, .height = HEIGHT};
    if (!aov_parse("albedo,normal,depth", &kinds, &error) ||
        !renderer_create(&renderer, context, &params, &error) ||
        !aov_create(&aov, kinds, context, &params, &renderer, &error) ||
        !renderer_pass(&renderer, 1, NULL, &error) || !aov_pass(&aov, &renderer, 1, NULL, &error) ||
        !aov_read(&aov, &renderer.film, &image, &error)) {
        fail_msg("%s", error.text);
    }
    assert_int_equal(image.layer_count, 3);
    static const size_t first[] = {0, 3, 6}, count[] = {3, 3, 1};
    for (int i = 0; i < 3; i++)
        memcpy(layers + first[i] * PIXELS, image.layers[i].data, count[i] * PIXELS * sizeof *layers);
    image_free(&image);
    aov_destroy(&aov);
    renderer_destroy(&renderer);
    scene_destroy(&read);
}

static void test_layers(void **state) {
    (void)state;
    static float a[7 * PIXELS], b[7 * PIXELS], ground[7 * PIXELS];
    Context context;
    double off = 0, apart = 0;
    support_open(&context);
    read_layers(&context, scene("made.glsl", "//@ spheres many", together, made), a);
    read_layers(&context, scene("each.glsl", "", each, made), b);
    read_layers(&context, scene("ground.glsl", "", "", made), ground);
    for (int i = 0; i < 7 * PIXELS; i++) {
        off += fabs((double)(a[i] - b[i])) / fmax(1, fabs((double)b[i]));
        apart += fabs((double)(a[i] - ground[i])) / fmax(1, fabs((double)b[i]));
    }
    assert_true(apart / (7 * PIXELS) > 0.05);
    assert_true(off / (7 * PIXELS) < 1e-6);
    context_close(&context);
}

/* How many entries of the tree a ray looks at: a square of 8 m full of spheres in rows, seen from above. */
static double looks(int count) {
    static const char rows[] =
        "vec4 scene_sphere(int i) { int across = int(ceil(sqrt(many))); float step = 8.0 / float(across);"
        " vec2 at = step * (vec2(float(i % across), float(i / across)) + 0.5) - 4.0;"
        " return vec4(at.x, 0.43 * step, at.y, 0.43 * step); }";
    static const char *const names[] = {"\"search_steps\": ", "\"search_rays\": "};
    double numbers[2] = {0};
    support_expect(0, "", "render %s -o %s --size 96x72 --spp 4 --sky uniform --progress json --set many=%d",
                   scene("rows.glsl", "//@ spheres many", together, rows), support_path("rows.pfm"), count);
    const char *done = strstr(support_err, "\"done\": true");
    for (int i = 0; done && i < 2; i++) {
        const char *at = strstr(done, names[i]);
        if (at) numbers[i] = strtod(at + strlen(names[i]), NULL);
    }
    assert_true(numbers[1] >= 96 * 72 * 4);
    return numbers[0] / numbers[1];
}

/* No more than in proportion to log(count), from 100 on. */
static void test_growth(void **state) {
    (void)state;
    need_gl();
    double hundred = looks(100);
    for (int count = 1000; count <= 100000; count *= 10) {
        double growth = looks(count) / hundred;
        print_message("%d spheres: %.2f times the looks of 100\n", count, growth);
        assert_true(growth > 1 && growth < log(count) / log(100));
    }
}

/* The file lies beside the scene. */
static void test_picture_of_file(void **state) {
    (void)state;
    static const char three[] = "vec4 scene_sphere(int i) { return vec4(float(i) - 1.0, 0.5, 0.0, 0.4); }";
    need_gl();
    support_write("three.csv", "x,y,z,radius\n-1,0.5,0,0.4\n0,0.5,0,0.4\n1,0.5,0,0.4\n");
    render(scene("file.glsl", "//@ spheres \"three.csv\"", together, ""), "file.exr", "");
    render(scene("three.glsl", "//@ spheres 3", together, three), "three.exr", "");
    render(scene("ground.glsl", "", "", ""), "ground.exr", "");
    assert_true(difference("file.exr", "three.exr") < 1e-3);
    assert_true(difference("file.exr", "ground.exr") > 5);
}

static void test_refused(void **state) {
    (void)state;
    need_gl();
#define REFUSED(path, part)                                                                                  \
    support_expect(3, part, "render %s -o %s --size 16x16", path, support_path("no.png"))
    REFUSED(scene("a.glsl", "", together, made), "a.glsl:1: hit_spheres() needs `//@ spheres COUNT` or");
    REFUSED(scene("a.glsl", "//@ spheres 9", together, ""),
            "a.glsl:1: missing function: vec4 scene_sphere(int i)");
    REFUSED(scene("a.glsl", "//@ spheres 9", together,
                  "vec4 scene_sphere(int i) { return vec4(log(float(i - 3)), 0.0, 0.0, 1.0); }"),
            "a.glsl:1: scene_sphere(0) is not finite or past 1e+07 m");
    REFUSED(scene("a.glsl", "//@ spheres 9", together,
                  "vec4 scene_sphere(int i) { return vec4(0.0, i == 7 ? 2.0e7 : 0.0, 0.0, 1.0); }"),
            "a.glsl:1: scene_sphere(7) is not finite or past 1e+07 m");
    REFUSED(scene("a.glsl", "//@ spheres 9", together, "vec4 scene_sphere(int i) { return vec3(1.0); }"),
            "a.glsl:16: ");
    REFUSED(scene("a.glsl", "//@ spheres none.csv", together, ""), "none.csv: cannot be read: ");
    support_write("bad.csv", "1,2,3,4\n1,2,3,-4\n");
    REFUSED(scene("a.glsl", "//@ spheres bad.csv", together, ""), "bad.csv:2: radius: '-4' is not above 0");
    support_expect(2, "many: 100001 is outside the range from 0 to 100000",
                   "render %s -o %s --set many=100001", scene("a.glsl", "//@ spheres many", together, made),
                   support_path("no.png"));
}

/* The same table again from other values of the sliders; too large a one for the OpenGL. */
static void test_fill(void **state) {
    (void)state;
    Context context;
    Scene read;
    Renderer renderer;
    Error error;
    support_open(&context);
    if (!scene_read(&read, scene("fill.glsl", "//@ spheres many", together, made), "glsl", &error))
        fail_msg("%s", error.text);
    RenderParams params = {.scene = &read, .width = 8, .height = 8};
    if (!renderer_create(&renderer, &context, &params, &error)) fail_msg("%s", error.text);
    Resource *table = resources_find(&renderer.tables, &scene_spheres);
    int entries = table->entries;
    assert_true(entries >= 60 - 9);
    assert_true(scene_set(&read, "many", "5000", &error));
    assert_true(renderer_restart(&renderer, &context, &params, &error));
    assert_true(table->entries > 50 * entries);
    table->max_texture_size = 4096;
    assert_true(scene_set(&read, "many", "3000", &error));
    assert_true(renderer_restart(&renderer, &context, &params, &error));
    int of_3000 = table->entries;
    table->max_texture_size = 20;
    assert_true(scene_set(&read, "many", "2900", &error));
    assert_false(renderer_restart(&renderer, &context, &params, &error));
    assert_non_null(strstr(error.text, "fill.glsl:1: too many spheres: they need a texture of 4096x"));
    assert_int_equal(table->entries, of_3000);
    table->max_texture_size = context.max_texture_size;
    assert_true(scene_set(&read, "many", "60", &error));
    assert_true(renderer_restart(&renderer, &context, &params, &error));
    assert_int_equal(table->entries, entries);
    renderer_destroy(&renderer);
    scene_destroy(&read);
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tree),    cmocka_unit_test(test_near_first),
        cmocka_unit_test(test_file),    cmocka_unit_test(test_picture),
        cmocka_unit_test(test_layers),  cmocka_unit_test(test_picture_of_file),
        cmocka_unit_test(test_refused), cmocka_unit_test(test_fill),
        cmocka_unit_test(test_growth),
    };
    return cmocka_run_group_tests_name("spheres", tests, support_folder, support_clean);
}
