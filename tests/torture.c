#include "torture.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct Dice {
    uint64_t state;
} Dice;

static double roll(Dice *dice) {
    dice->state = dice->state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(dice->state >> 11) * 0x1p-53;
}

static double between(Dice *dice, double low, double high) {
    return low + (high - low) * roll(dice);
}

/* C leaves open which argument of a call is computed first, so that no call rolls twice. */
static void roll_all(Dice *dice, double *rolls, int count) {
    for (int i = 0; i < count; i++) rolls[i] = roll(dice);
}

static int choose(Dice *dice, int count) {
    return (int)(roll(dice) * count);
}

static bool chance(Dice *dice, double probability) {
    return roll(dice) < probability;
}

#define PICK(dice, words) ((words)[choose(dice, (int)(sizeof(words) / sizeof *(words)))])

/* Text that grows in an array. */
typedef struct Page {
    char *text;
    size_t size, used;
} Page;

#define ADD(page, ...)                                                                                       \
    ((page)->used += (size_t)snprintf((page)->text + (page)->used, (page)->size - (page)->used, __VA_ARGS__))

/* The three kinds of surfaces that hints name. */
typedef enum Matter { MATTE, MIRROR, LAMP, OTHER } Matter;

static Matter add_material(Dice *dice, Page *page) {
    double rgb[3], more[3];
    roll_all(dice, rgb, 3);
    roll_all(dice, more, 3);
    double r = rgb[0], g = rgb[1], b = rgb[2];
    /* Extremes are as likely as all others together. */
    if (chance(dice, 0.25)) r = g = b = (double)choose(dice, 2);
    switch (choose(dice, 8)) {
    case 0:
        ADD(page, "mirror(vec3(%.3f, %.3f, %.3f))", r, g, b);
        return MIRROR;
    case 1:
        ADD(page, "rough_metal(vec3(%.3f, %.3f, %.3f), %.3f)", r, g, b, between(dice, 0, 1));
        return OTHER;
    case 2:
        ADD(page, "glass(%.3f)", between(dice, 0.6, 2.5));
        return OTHER;
    case 3:
        ADD(page, "glass_tinted(vec3(%.3f, %.3f, %.3f), %.3f)", r, g, b, between(dice, 1, 2));
        return OTHER;
    case 4:
        ADD(page, "author(vec3(%.3f, %.3f, %.3f), %.3f, %.3f, %.3f)", r, g, b, more[0], more[1], more[2]);
        return OTHER;
    case 5:
        ADD(page, "emitter(vec3(%.3g, %.3g, %.3g))", r * pow(10, between(dice, -6, 6)), g, b);
        return LAMP;
    default:
        ADD(page, "matte(vec3(%.3f, %.3f, %.3f))", r, g, b);
        return MATTE;
    }
}

/* A place among the others, and a size from a millimetre to 3 metres. */
static void add_shape(Dice *dice, Page *page, int object, double place[3], double *size) {
    double largest = chance(dice, 0.2) ? 3 : 1, usual = between(dice, 0.3, largest);
    *size = chance(dice, 0.1) ? pow(10, between(dice, -3, 0)) : usual;
    for (int c = 0; c < 3; c++) place[c] = between(dice, -2, 2);
    place[1] += 1.2;
    double s = *size, x = place[0], y = place[1], z = place[2], t = between(dice, 0.05, 0.95);
    switch (choose(dice, 10)) {
    case 0:
        ADD(page, "    hit_box(ray, vec3(%.4g, %.4g, %.4g), vec3(%.4g, %.4g, %.4g), %d, hit);\n", x, y, z, s,
            s * t, s, object);
        break;
    case 1:
        ADD(page, "    hit_cylinder(ray, vec3(%.4g, %.4g, %.4g), vec3(%.4g, %.4g, %.4g), %.4g, %d, hit);\n",
            x, y, z, x, y + s, z + s, s * t, object);
        break;
    case 2:
        ADD(page, "    hit_torus(ray, vec3(%.4g, %.4g, %.4g), vec3(0.2, 1.0, %.4g), %.4g, %.4g, %d, hit);\n",
            x, y, z, t, s, s * t, object);
        break;
    case 3:
        ADD(page, "    hit_cone(ray, vec3(%.4g, %.4g, %.4g), vec3(%.4g, %.4g, %.4g), %.4g, %d, hit);\n", x, y,
            z, x, y + s, z, s * t, object);
        break;
    case 4:
        ADD(page, "    hit_disk(ray, vec3(%.4g, %.4g, %.4g), vec3(0.1, %.4g, 1.0), %.4g, %d, hit);\n", x, y,
            z, t, s, object);
        break;
    case 5:
        ADD(page, "    hit_ellipsoid(ray, vec3(%.4g, %.4g, %.4g), vec3(%.4g, %.4g, %.4g), %d, hit);\n", x, y,
            z, s, s * t, s, object);
        break;
    case 6:
        ADD(page, "    hit_rounded_box(ray, vec3(%.4g, %.4g, %.4g), vec3(%.4g), %.4g, %d, hit);\n", x, y, z,
            s, 0.9 * s * t, object);
        break;
    default:
        ADD(page, "    hit_sphere(ray, vec3(%.4g, %.4g, %.4g), %.4g, %d, hit);\n", x, y, z, s, object);
        return;
    }
    *size = 0;
}

static void add_mist(Dice *dice, Page *page) {
    static const char *const places[] = {"box 0 1 0  3 2 3", "sphere 0 1 0  2", "falloff 2"};
    double albedo[3], thickest = chance(dice, 0.2) ? 3 : 0.5,
                      extinction = pow(10, between(dice, -4, thickest)), g = between(dice, -0.9, 0.9);
    roll_all(dice, albedo, 3);
    ADD(page, "//@ mist  extinction %.3g  albedo %.3f %.3f %.3f  g %.3f  %s\n", extinction, albedo[0],
        albedo[1], albedo[2], g, PICK(dice, places));
}

static void write_includes(Page *page, const char *shapes, const char *materials) {
    static const char *const files[] = {
        "material/author",      "material/emitter", "material/glass",    "material/matte", "material/mirror",
        "material/rough_metal", "shape/box",        "shape/cone",        "shape/cylinder", "shape/disk",
        "shape/ellipsoid",      "shape/plane",      "shape/rounded_box", "shape/sphere",   "shape/torus"};
    /* Only what is called, because each file is compiled. */
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        const char *name = strchr(files[i], '/') + 1;
        char call[40];
        snprintf(call, sizeof call, "%s%s(", *files[i] == 's' ? "hit_" : "", name);
        bool tinted = strcmp(name, "glass") == 0 && strstr(materials, "glass_tinted(");
        if (strstr(shapes, call) || strstr(materials, call) || tinted)
            ADD(page, "#include \"%s.glsl\"\n", files[i]);
    }
}

static void write_scene(Dice *dice, Page *page) {
    char shapes[2048], materials[2048];
    Page shape = {shapes, sizeof shapes, 0}, material = {materials, sizeof materials, 0};
    int count = 1 + choose(dice, 5);
    double at[6];
    roll_all(dice, at, 6);
    ADD(page, "//@ camera eye %.3f %.3f %.3f target %.3f %.3f 0 fov %.1f\n", 8 * at[0] - 4, 0.1 + 4 * at[1],
        -6 + 4 * at[2], 2 * at[3] - 1, 2 * at[4], 10 + 110 * at[5]);
    for (int i = 0; i < count; i++) {
        double place[3], size;
        add_shape(dice, &shape, i, place, &size);
        ADD(&material, "    if (hit.object == %d) return ", i);
        Matter matter = add_material(dice, &material);
        ADD(&material, ";\n");
        const char *hint = matter == MIRROR ? "mirror-sphere" : matter == LAMP ? "emitter-sphere" : "bound";
        if (size > 0 && chance(dice, 0.6))
            ADD(page, "//@ %s %.4g %.4g %.4g %.4g\n", hint, place[0], place[1], place[2], size);
        if (size > 0 && matter == MIRROR && chance(dice, 0.5))
            ADD(page, "//@ bound %.4g %.4g %.4g %.4g\n", place[0], place[1], place[2], size);
    }
    if (chance(dice, 0.8)) ADD(&shape, "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, %d, hit);\n", count);
    ADD(&material, "    return ");
    if (chance(dice, 0.7))
        ADD(&material, "matte(vec3(%.3f))", roll(dice));
    else
        add_material(dice, &material);
    ADD(&material, ";\n");
    if (chance(dice, 0.2)) add_mist(dice, page);
    write_includes(page, shapes, materials);
    ADD(page, "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n%s}\n", shapes);
    ADD(page, "Material scene_material(Hit hit) {\n%s}\n", materials);
}

static void write_options(Dice *dice, Torture *torture) {
    static const char *const skies[] = {"auto",    "auto",      "auto",      "table",
                                        "gauss:4", "uniform:3", "paper:16x4"};
    static const char *const lights[] = {"auto", "auto", "control", "control", "cosine", "mis", "paper"};
    static const char *const sequences[] = {"sobol", "sobol", "sobol", "random", "additive", "metropolis"};
    static const char *const disks[] = {"off", "off", "auto", "sampled", "traced", "chance"};
    static const char *const airs[] = {"simmons2017", "simmons2017-ozone", "simmons2017-author"};
    Page page = {torture->options, sizeof torture->options, 0};
    const char *light = PICK(dice, lights), *sequence = PICK(dice, sequences), *disk = PICK(dice, disks);
    /* Pairs that are refused are no cases. */
    if (strcmp(disk, "traced") == 0 && (strcmp(light, "paper") == 0 || strcmp(sequence, "metropolis") == 0 ||
                                        strstr(torture->scene, "//@ mist")))
        disk = "sampled";
    torture->may_control =
        strcmp(light, "control") == 0 || strcmp(light, "auto") == 0 || strstr(torture->scene, "//@ mist");
    torture->chains = strcmp(sequence, "metropolis") == 0;
    torture->samples = 1 + choose(dice, 24);
    int width = 1 + choose(dice, 32), height = 1 + choose(dice, 32), seed = choose(dice, 1000);
    double elevation = between(dice, -10, 90), azimuth = between(dice, 0, 360);
    const char *sky = PICK(dice, skies), *air = PICK(dice, airs);
    ADD(&page, "--size %dx%d --seed %d --sun %.2f,%.1f --light %s --sequence %s", width, height, seed,
        elevation, azimuth, light, sequence);
    ADD(&page, " --sun-disk=%s --sky %s --atmosphere %s", disk, sky, air);
    if (chance(dice, 0.2)) ADD(&page, " --depth %d", 1 + choose(dice, 6));
    if (chance(dice, 0.2)) ADD(&page, " --set sun.radius=%.3g", pow(10, between(dice, -2, 1.3)));
    if (chance(dice, 0.1)) ADD(&page, " --set atmosphere.rayleigh=%.3g", pow(10, between(dice, -3, 3)));
    if (chance(dice, 0.1)) ADD(&page, " --set atmosphere.mie=%.3g", pow(10, between(dice, -3, 3)));
    if (chance(dice, 0.1))
        ADD(&page, " --set atmosphere.observer_height_m=%.3g", pow(10, between(dice, 0, 5)));
}

void torture_make(Torture *torture, uint32_t number) {
    Dice dice = {number * 0x9e3779b97f4a7c15ULL + 1};
    for (int i = 0; i < 4; i++) roll(&dice);
    *torture = (Torture){.samples = 1};
    Page page = {torture->scene, sizeof torture->scene, 0};
    write_scene(&dice, &page);
    write_options(&dice, torture);
}
