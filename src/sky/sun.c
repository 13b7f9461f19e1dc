#include "sky/sun.h"

#include "base/memory.h"
#include "base/vec3.h"
#include "gl/texture.h"
#include "sky/sun_disk.h"

#include <math.h>
#include <stdlib.h>

enum { TABLE_COLUMNS = 256, TABLE_UNIT = 2, COVER_UNIT = 3 };

static SunDisk disk_of(const Scene *scene) {
    return sun_disk(&scene->values.atmosphere, &scene->values.sun);
}

void sun_slots(const MethodChoice *choice, const Scene *scene, bool image, const char *spheres,
               const char *planes, GlslSlot *slots) {
    bool mirrors = scene_hint_count(scene, HINT_MIRROR_SPHERE) > 0;
    slots[0] = (GlslSlot){"sun", choice->method->file, NULL};
    slots[1] = (GlslSlot){"sun-image", image ? "pass/sun_image.glsl" : "pass/sun_image_none.glsl", NULL};
    slots[2] = (GlslSlot){"mirrors", mirrors ? "sun/mirrors.glsl" : "sun/mirrors_none.glsl", NULL};
    slots[3] = (GlslSlot){"mirrors-image",
                          mirrors ? "pass/mirrors_image.glsl" : "pass/mirrors_image_none.glsl", NULL};
    slots[4] = (GlslSlot){"mirror-spheres", NULL, spheres};
    slots[5] = (GlslSlot){
        "planes", scene_hint_count(scene, HINT_MIRROR_PLANE) ? "sun/planes.glsl" : "sun/planes_none.glsl",
        NULL};
    slots[6] = (GlslSlot){"mirror-planes", NULL, planes};
}

bool sun_choose(MethodChoice *choice, const char *text, const Scene *scene, Error *error) {
    SunDisk disk = disk_of(scene);
    if (!text) text = scene->values.sun_disk ? "auto" : "off";
    if (!method_choose(choice, METHOD_SUN, text, error)) return false;
    return sun_disk_visible(&disk) || method_choose(choice, METHOD_SUN, "off", error);
}

static void add_rectangle(SunTables *sun, Rectangle rectangle) {
    if (rectangle.width && rectangle.height) sun->rectangles[sun->rectangle_count++] = rectangle;
}

/* Where the eye sees the disk's middle in a sphere, by bisection of Alhazen's angle
 * (glsl/sun/mirror_sphere.glsl). A sphere reflects the disk smaller than it is, so that its image is within
 * the disk's radius of that direction. */
static bool reflected_toward(const double eye[3], const double sphere[4], const double light[3],
                             double out[3]) {
    double point[3], across[3], r = 0, along = 0, off = 0;
    for (int i = 0; i < 3; i++) point[i] = (eye[i] - sphere[i]) / sphere[3], r += point[i] * point[i];
    for (int i = 0; i < 3; i++) along += point[i] * light[i];
    for (int i = 0; i < 3; i++) across[i] = point[i] - along * light[i], off += across[i] * across[i];
    r = sqrt(r);
    off = sqrt(off);
    if (r <= 1) return false;
    /* In the shadow, or by its edge, light can only graze: it comes from where the sun is. */
    double theta = atan2(off, along), low = theta / 2, high = fmin(pi / 2, (theta + pi / 2) / 2);
    bool shadow = along < 0 && off < 1;
    for (int i = 0; i < 60; i++) {
        double middle = (low + high) / 2;
        *(r * sin(2 * middle - theta) > sin(middle) ? &high : &low) = middle;
    }
    for (int i = 0; i < 3; i++) {
        double to_eye = light[i] * cos(2 * low) + (off > 0 ? across[i] / off : 0) * sin(2 * low);
        out[i] = shadow ? light[i] : -to_eye;
    }
    return true;
}

static void find_rectangles(SunTables *sun, const SunDisk *disk, const Scene *scene, const Camera *camera) {
    add_rectangle(sun, camera_cone_rectangle(camera, disk->middle, disk->radius));
    for (int i = 0; i < scene_hint_count(scene, HINT_MIRROR_SPHERE); i++) {
        double sphere[4], direction[3];
        scene_hint(scene, HINT_MIRROR_SPHERE, i, sphere);
        if (sphere[3] <= 0 || !reflected_toward(camera->eye, sphere, disk->middle, direction)) continue;
        add_rectangle(sun, camera_cone_rectangle(camera, direction, 1.1 * disk->radius));
    }
}

/* The disk's image as it would be unblocked; a texel of nothing where it is not in the picture or is no
 * ellipse there. */
static void create_cover(SunTables *sun, const SunDisk *disk, const Scene *scene, const Camera *camera) {
    Rectangle r = camera_cone_rectangle(camera, disk->middle, disk->radius);
    float none[4] = {0};
    float *cover =
        r.width && r.height ? memory_get((size_t)r.width * (size_t)r.height, 4 * sizeof *cover) : none;
    bool there = cover != none && sun_disk_cover(disk, &scene->values.atmosphere, camera, r, cover);
    if (there) sun->covered = r;
    sun->cover =
        texture_create(sun->gl, there ? r.width : 1, there ? r.height : 1, GL_NEAREST, there ? cover : none);
    if (cover != none) free(cover);
}

bool sun_create(SunTables *sun, const Context *context, const MethodChoice *choice, const Scene *scene,
                const Camera *camera, Error *error) {
    SunDisk disk = disk_of(scene);
    float table[4 * TABLE_COLUMNS];
    *sun = (SunTables){.gl = &context->gl};
    if (!choice->method->has_disk) return true;
    sun_disk_table(&disk, &scene->values.atmosphere, TABLE_COLUMNS, table);
    sun->table = texture_create(sun->gl, TABLE_COLUMNS, 1, GL_LINEAR, table);
    if (choice->method->draws_image) {
        find_rectangles(sun, &disk, scene, camera);
        create_cover(sun, &disk, scene, camera);
    }
    if (gl_check(sun->gl, "the sun's disk", error)) return true;
    sun_destroy(sun);
    return false;
}

void sun_destroy(SunTables *sun) {
    if (!sun->gl) return;
    if (sun->table) sun->gl->DeleteTextures(1, &sun->table);
    if (sun->cover) sun->gl->DeleteTextures(1, &sun->cover);
    *sun = (SunTables){0};
}

void sun_bind(const SunTables *sun) {
    if (!sun->table) return;
    sun->gl->ActiveTexture(GL_TEXTURE0 + TABLE_UNIT);
    sun->gl->BindTexture(GL_TEXTURE_2D, sun->table);
    sun->gl->ActiveTexture(GL_TEXTURE0 + COVER_UNIT);
    sun->gl->BindTexture(GL_TEXTURE_2D, sun->cover);
    sun->gl->ActiveTexture(GL_TEXTURE0);
}

void sun_use(const SunTables *sun, const Program *program, const Scene *scene, const Camera *camera) {
    SunDisk disk = disk_of(scene);
    if (!sun->table) return;
    double heights[3] = {disk.lowest, disk.top, 0}, heart[3], heart_at[3] = {0}, corner[3] = {0};
    double visible = asin(disk.lowest) + asin(fmin(disk.top, sin(asin(disk.middle[1]) + disk.radius)));
    double lift = tan(fmax(visible / 2 - asin(disk.middle[1]), 0));
    for (int i = 0; i < 3; i++) heart[i] = disk.middle[i] + lift * disk.up[i];
    corner[0] = sun->covered.width ? sun->covered.x : -9; /* beside the picture */
    corner[1] = sun->covered.y;
    if (!camera_project(camera, heart, heart_at)) heart_at[0] = heart_at[1] = -1;
    sun_bind(sun);
    program_set_vec3(program, "sun_disk_middle", disk.middle);
    program_set_float(program, "sun_disk_one_less_cos", 2 * sin(disk.radius / 2) * sin(disk.radius / 2));
    program_set_vec3(program, "sun_disk_heights", heights);
    program_set_int(program, "sun_disk_table", TABLE_UNIT);
    program_set_int(program, "sun_image_cover", COVER_UNIT);
    program_set_vec3(program, "sun_image_corner", corner);
    program_set_vec3(program, "sun_image_heart", heart_at);
}
