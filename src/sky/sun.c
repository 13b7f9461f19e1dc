#include "sky/sun.h"

#include "base/memory.h"
#include "base/vec3.h"
#include "sky/sun_disk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TABLE_COLUMNS = 256 };

static SunDisk disk_of(const Scene *scene) {
    return sun_disk(&scene->values.atmosphere, &scene->values.sun);
}

void sun_slots(SlotList *slots, const MethodChoice *choice, const Scene *scene) {
    bool mirrors = scene_hint_count(scene, HINT_MIRROR_SPHERE) > 0;
    bool planes = scene_hint_count(scene, HINT_MIRROR_PLANE) > 0;
    slot_file(slots, "sun", choice->method->file);
    slot_file(slots, "sun-image",
              choice->method->draws_image ? "pass/sun_image_sum.glsl" : "pass/sun_image_sum_none.glsl");
    slot_file(slots, "mirrors", mirrors ? "sun/mirrors.glsl" : "sun/mirrors_none.glsl");
    slot_file(slots, "mirrors-image", mirrors ? "pass/mirrors_image.glsl" : "pass/mirrors_image_none.glsl");
    slot_file(slots, "planes", planes ? "sun/planes.glsl" : "sun/planes_none.glsl");
}

/* Whether the scene may throw sunlight on its surfaces in a way that rays to the sun do not find. A scene
 * that names some of its mirrors is taken to name all of them. */
static bool throws_light(const Scene *scene) {
    const SceneFacts *facts = &scene->file->facts;
    bool named = scene_hint_count(scene, HINT_MIRROR_SPHERE) + scene_hint_count(scene, HINT_MIRROR_PLANE) > 0;
    bool glossy = facts->has_glass || facts->has_rough_metal || facts->has_author;
    return facts->throws && (glossy || !named);
}

bool sun_choose(MethodChoice *choice, const char *text, const Scene *scene, Error *error) {
    SunDisk disk = disk_of(scene);
    if (!text) text = scene->values.sun_disk ? "auto" : "off";
    if (method_is_auto(text) && throws_light(scene)) text = "traced";
    if (!method_choose(choice, METHOD_SUN, text, error)) return false;
    return sun_disk_visible(&disk) || method_choose(choice, METHOD_SUN, "off", error);
}

static void add_rectangle(SunImage *image, Rectangle rectangle) {
    if (rectangle.width && rectangle.height) image->rectangles[image->count++] = rectangle;
}

/* The direction in which the eye sees the disk's middle in a sphere, by bisection of the angle in Alhazen's
 * problem (glsl/sun/mirror_sphere.glsl). A sphere reflects the disk smaller than it is, so its image is
 * within the disk's radius of that direction. */
static bool reflected_toward(const double eye[3], const double sphere[4], const double light[3],
                             double out[3]) {
    double point[3], across[3], r = 0, along = 0, off = 0;
    for (int i = 0; i < 3; i++) point[i] = (eye[i] - sphere[i]) / sphere[3], r += point[i] * point[i];
    for (int i = 0; i < 3; i++) along += point[i] * light[i];
    for (int i = 0; i < 3; i++) across[i] = point[i] - along * light[i], off += across[i] * across[i];
    r = sqrt(r);
    off = sqrt(off);
    if (r <= 1) return false;
    /* In the sphere's shadow or near its edge light can only graze the sphere, so it comes from the sun's own
     * direction. */
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

SunImage sun_image(const Frame *frame) {
    const Scene *scene = frame->scene;
    const Camera *camera = &frame->camera;
    SunImage image = {0};
    if (!frame->sun_disk->method->has_disk) return image;
    SunDisk disk = disk_of(scene);
    add_rectangle(&image, camera_cone_rectangle(camera, disk.middle, disk.radius));
    for (int i = 0; i < scene_hint_count(scene, HINT_MIRROR_SPHERE); i++) {
        double sphere[MOST_HINT_NUMBERS], direction[3];
        if (frame->mirrors)
            memcpy(sphere, frame->mirrors[i], sizeof frame->mirrors[i]);
        else
            scene_hint(scene, HINT_MIRROR_SPHERE, i, sphere);
        if (sphere[3] <= 0 || !reflected_toward(camera->eye, sphere, disk.middle, direction)) continue;
        add_rectangle(&image, camera_cone_rectangle(camera, direction, 1.1 * disk.radius));
    }
    return image;
}

void sun_image_pixels(const SunImage *image, int width, unsigned char *mask) {
    for (int i = 0; i < image->count; i++) {
        const Rectangle *r = &image->rectangles[i];
        for (int y = r->y; y < r->y + r->height; y++)
            memset(mask + (size_t)y * (size_t)width + (size_t)r->x, 1, (size_t)r->width);
    }
}

/* sun_table, the table of radiances. */

static bool wants_disk(const void *frame) {
    const MethodChoice *disk = ((const Frame *)frame)->sun_disk;
    return disk && disk->method->has_disk;
}

static void disk_key(const void *data, Text *key) {
    const SkyState *state = &((const Frame *)data)->state;
    text_append(key, &state->atmosphere, sizeof state->atmosphere);
    text_append(key, &state->sun, sizeof state->sun);
}

static bool compute_table(Resource *table, const void *data, Error *error) {
    const SkyState *state = &((const Frame *)data)->state;
    SunDisk disk = sun_disk(&state->atmosphere, &state->sun);
    float radiances[4 * TABLE_COLUMNS];
    (void)error;
    sun_disk_table(&disk, &state->atmosphere, TABLE_COLUMNS, radiances);
    resource_upload(table, 0, TABLE_COLUMNS, 1, radiances);
    return true;
}

static void disk_uniforms(const Resource *table, const void *data, Uniforms *uniforms) {
    const SkyState *state = &((const Frame *)data)->state;
    SunDisk disk = sun_disk(&state->atmosphere, &state->sun);
    double heights[3] = {disk.lowest, disk.top, 0};
    (void)table;
    uniforms_declared_in(uniforms, "pass/sun_disk.glsl");
    uniforms_vec3(uniforms, "sun_disk_middle", disk.middle);
    uniforms_float(uniforms, "sun_disk_one_less_cos", 2 * sin(disk.radius / 2) * sin(disk.radius / 2));
    uniforms_vec3(uniforms, "sun_disk_heights", heights);
}

const ResourceKind sun_table = {.name = "the sun's radiances",
                                .samplers = {"sun_disk_table"},
                                .filter = GL_LINEAR,
                                .wanted = wants_disk,
                                .key = disk_key,
                                .compute = compute_table,
                                .uniforms = disk_uniforms};

/* sun_cover, the disk's part in each pixel. */

static bool wants_cover(const void *frame) {
    const MethodChoice *disk = ((const Frame *)frame)->sun_disk;
    return disk && disk->method->draws_image;
}

static void cover_key(const void *frame, Text *key) {
    const Camera *camera = &((const Frame *)frame)->camera;
    disk_key(frame, key);
    text_append(key, camera, sizeof *camera);
}

/* Computes the image of the unblocked disk in the rectangle that may hold it. It is one texel of zeros where
 * the disk is not in the picture or is no ellipse there. `entries` is 1 where there is a cover. */
static bool compute_cover(Resource *cover, const void *data, Error *error) {
    static const float none[4] = {0};
    const Frame *frame = data;
    SunDisk disk = disk_of(frame->scene);
    Rectangle r = camera_cone_rectangle(&frame->camera, disk.middle, disk.radius);
    size_t pixels = (size_t)r.width * (size_t)r.height;
    float *radiances = memory_get(pixels, 4 * sizeof *radiances);
    (void)error;
    bool there = pixels && sun_disk_cover(&disk, &frame->state.atmosphere, &frame->camera, r, radiances);
    resource_upload(cover, 0, there ? r.width : 1, there ? r.height : 1, there ? radiances : none);
    cover->entries = there;
    free(radiances);
    return true;
}

/* The uniforms are the rectangle's first pixel, outside of the picture where there is no cover, and a point
 * well inside of the visible disk, in pixels. */
static void cover_uniforms(const Resource *cover, const void *data, Uniforms *uniforms) {
    const Frame *frame = data;
    SunDisk disk = disk_of(frame->scene);
    Rectangle r = camera_cone_rectangle(&frame->camera, disk.middle, disk.radius);
    bool there = cover && cover->entries;
    double corner[3] = {there ? r.x : -9, there ? r.y : 0, 0}, heart[3], heart_at[3] = {0};
    double visible = asin(disk.lowest) + asin(fmin(disk.top, sin(asin(disk.middle[1]) + disk.radius)));
    double lift = tan(fmax(visible / 2 - asin(disk.middle[1]), 0));
    for (int i = 0; i < 3; i++) heart[i] = disk.middle[i] + lift * disk.up[i];
    if (!camera_project(&frame->camera, heart, heart_at)) heart_at[0] = heart_at[1] = -1;
    uniforms_declared_in(uniforms, "pass/sun_image.glsl");
    uniforms_vec3(uniforms, "sun_image_corner", corner);
    uniforms_vec3(uniforms, "sun_image_heart", heart_at);
}

const ResourceKind sun_cover = {.name = "the sun's image",
                                .samplers = {"sun_image_cover"},
                                .filter = GL_NEAREST,
                                .wanted = wants_cover,
                                .key = cover_key,
                                .compute = compute_cover,
                                .uniforms = cover_uniforms};
