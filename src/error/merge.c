#include "error/merge.h"

#include "base/memory.h"
#include "error/merge_layers.h"
#include "error/merge_noise.h"
#include "render/identity.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool overlaps(const PartPiece *a, const PartPiece *b) {
    return a->first < b->first + b->count && b->first < a->first + a->count &&
           rectangle_overlap(&a->area, &b->area).width > 0;
}

static bool refuse_overlap(const Part *a, const PartPiece *p, const Part *b, const PartPiece *q,
                           Error *error) {
    uint64_t first = p->first > q->first ? p->first : q->first;
    uint64_t end = p->first + p->count < q->first + q->count ? p->first + p->count : q->first + q->count;
    return error_set(error, STATUS_FAILURE, "%s and %s overlap: both have samples %" PRIu64 " to %" PRIu64,
                     a->path, b->path, first, end - 1);
}

static bool share_pixels(const Part *a, const Part *b) {
    for (int i = 0; i < a->piece_count; i++)
        for (int k = 0; k < b->piece_count; k++)
            if (rectangle_overlap(&a->pieces[i].area, &b->pieces[k].area).width > 0) return true;
    return false;
}

static bool check_pair(const Part *a, const Part *b, Error *error) {
    Text difference = {0};
    bool same = identity_same(a->identity, b->identity, &difference);
    if (!same)
        error_set(error, STATUS_FAILURE, "%s is of another picture than %s: %s", b->path, a->path,
                  text_string(&difference));
    text_free(&difference);
    if (!same) return false;
    for (int i = 0; i < a->piece_count; i++)
        for (int k = 0; k < b->piece_count; k++)
            if (overlaps(&a->pieces[i], &b->pieces[k]))
                return refuse_overlap(a, &a->pieces[i], b, &b->pieces[k], error);
    if (a->layers != b->layers)
        return error_set(error, STATUS_FAILURE, "%s and %s have different sums", a->path, b->path);
    bool lit = a->light_paths > 0 && b->light_paths > 0 && share_pixels(a, b);
    if (lit && a->light_first < b->light_first + b->light_paths &&
        b->light_first < a->light_first + a->light_paths)
        return error_set(error, STATUS_FAILURE,
                         "%s and %s have paths of traced sunlight in common, because --error took more of "
                         "them than samples: render the parts with --spp",
                         a->path, b->path);
    return true;
}

static int by_first(const void *a, const void *b) {
    const PartPiece *p = &((const Part *)a)->pieces[0], *q = &((const Part *)b)->pieces[0];
    if (p->first != q->first) return p->first < q->first ? -1 : 1;
    if (p->area.y != q->area.y) return p->area.y < q->area.y ? -1 : 1;
    return (p->area.x > q->area.x) - (p->area.x < q->area.x);
}

/* The picture's size, which stands in its identity. */
static bool find_size(Merge *merge, Error *error) {
    const Part *part = &merge->parts[0];
    const char *line = strstr(part->identity, "\nsize ");
    if (!line || sscanf(line, "\nsize %dx%d", &merge->width, &merge->height) != 2 ||
        !scene_check_size(merge->width, merge->height, error))
        return error_set(error, STATUS_FAILURE, "%s: its metadata do not say the picture's size", part->path);
    for (int i = 0; i < merge->count; i++) {
        for (int k = 0; k < merge->parts[i].piece_count; k++) {
            const Rectangle *r = &merge->parts[i].pieces[k].area;
            if (r->width > merge->width - r->x || r->height > merge->height - r->y)
                return error_set(error, STATUS_FAILURE, "%s: a piece of it is outside of the picture",
                                 merge->parts[i].path);
        }
    }
    return true;
}

/* The light paths of all parts that have this one's pixels. */
static double paths_with(const Merge *merge, const Part *part) {
    double paths = 0;
    for (int i = 0; i < merge->count; i++)
        if (share_pixels(&merge->parts[i], part)) paths += merge->parts[i].light_paths;
    return paths;
}

/* A part says how many light paths it has, for all of its pixels. */
static bool check_light(const Merge *merge, Error *error) {
    for (int i = 1; i < merge->count; i++) {
        if (paths_with(merge, &merge->parts[i]) == paths_with(merge, &merge->parts[0])) continue;
        return error_set(error, STATUS_FAILURE,
                         "%s and %s have different numbers of samples of traced sunlight, for different "
                         "pixels: merge those of the same pixels first, until all have the same number",
                         merge->parts[0].path, merge->parts[i].path);
    }
    return true;
}

static bool read_parts(Merge *merge, const char *const *paths, int count, Error *error) {
    merge->parts = memory_get((size_t)count, sizeof *merge->parts);
    for (int i = 0; i < count; i++) {
        if (!part_read(&merge->parts[i], paths[i], error)) return false;
        merge->count = i + 1;
        for (int k = 0; k < i; k++)
            if (!check_pair(&merge->parts[k], &merge->parts[i], error)) return false;
    }
    qsort(merge->parts, (size_t)count, sizeof *merge->parts, by_first);
    merge->layers = merge->parts[0].layers;
    return find_size(merge, error) && check_light(merge, error);
}

/* Joins a piece to one that it continues, or appends it. */
static void add_piece(Part *whole, const PartPiece *piece) {
    for (int i = 0; i < whole->piece_count; i++) {
        PartPiece *other = &whole->pieces[i];
        if (rectangle_same(&other->area, &piece->area) && other->first + other->count == piece->first) {
            other->count += piece->count;
            return;
        }
    }
    whole->pieces = memory_grow(whole->pieces, (size_t)whole->piece_count + 1, sizeof *whole->pieces);
    whole->pieces[whole->piece_count++] = *piece;
}

static void join_parts(Merge *merge) {
    Part *whole = &merge->whole;
    const Part *first = &merge->parts[0];
    *whole = (Part){.identity = memory_string(first->identity),
                    .light_first = first->light_first,
                    .light_scale = first->light_scale,
                    .layers = first->layers};
    for (int i = 0; i < merge->count; i++) {
        const Part *part = &merge->parts[i];
        for (int k = 0; k < part->piece_count; k++) add_piece(whole, &part->pieces[k]);
        whole->search.rays += part->search.rays;
        whole->search.steps += part->search.steps;
        whole->search.broken += part->search.broken;
        whole->search.cut += part->search.cut;
        whole->light_paths = fmax(whole->light_paths, paths_with(merge, part));
        whole->light_first = fmin(whole->light_first, part->light_first);
        whole->luck |= part->luck;
    }
}

static void count_samples(Merge *merge, const MergeSums *sums) {
    double accepted = 0, rejected = 0;
    merge->least = UINT64_MAX;
    for (size_t i = 0; i < (size_t)merge->width * (size_t)merge->height; i++) {
        double here = sums->accepted[i] + sums->rejected[i];
        accepted += sums->accepted[i];
        rejected += sums->rejected[i];
        merge->missing += !(here > 0);
        if (!(here > 0)) continue;
        if ((double)merge->least > here) merge->least = (uint64_t)here;
        if ((double)merge->most < here) merge->most = (uint64_t)here;
    }
    merge->samples = (FilmCount){.accepted = (uint64_t)accepted, .rejected = (uint64_t)rejected};
}

/* The smallest rectangle that holds all pieces. */
static Rectangle bounds_of(const Part *whole) {
    Rectangle all = whole->pieces[0].area;
    for (int i = 1; i < whole->piece_count; i++) {
        const Rectangle *r = &whole->pieces[i].area;
        int right = all.x + all.width > r->x + r->width ? all.x + all.width : r->x + r->width;
        int bottom = all.y + all.height > r->y + r->height ? all.y + all.height : r->y + r->height;
        all.x = r->x < all.x ? r->x : all.x;
        all.y = r->y < all.y ? r->y : all.y;
        all.width = right - all.x, all.height = bottom - all.y;
    }
    return all;
}

static bool make_picture(Merge *merge, const MergeSums *sums, const MergeNoise *noise, bool keeps_sums,
                         Error *error) {
    float *light;
    ChanceMap map = merge_sums_chance(sums);
    Rectangle bounds = bounds_of(&merge->whole);
    merge->image = merge_sums_mean(sums, &light);
    if (bounds.width < merge->width || bounds.height < merge->height) merge->image.data = bounds;
    count_samples(merge, sums);
    if (map.pixels) merge->chance = chance_shares(&map, &merge->image);
    merge->noise_percent = merge_noise_percent(noise, merge);
    if (keeps_sums) merge_sums_add_layers(sums, &merge->image);
    if (sums->scatter) {
        float *variance = image_add_layer(&merge->image, "variance", "RGB");
        merge_sums_variance(sums, variance);
        merge_noise_calibrate(noise, variance);
    }
    chance_map_free(&map);
    free(light);
    return merge_layers_add(merge, sums->accepted, error);
}

bool merge_files(Merge *merge, const char *const *paths, int count, bool keeps_sums, Error *error) {
    *merge = (Merge){.noise_percent = INFINITY};
    MergeNoise noise = {0};
    MergeSums sums = {0};
    bool ok = read_parts(merge, paths, count, error) && merge_noise_create(&noise, merge, error);
    if (ok) join_parts(merge);
    if (ok) sums = merge_sums_create(merge->width, merge->height, &merge->parts[0]);
    for (int i = 0; ok && i < merge->count; i++) {
        ok = merge_sums_add(&sums, &merge->parts[i], error);
        if (ok) merge_noise_measure(&noise, &merge->parts[i], &sums);
    }
    ok = ok && make_picture(merge, &sums, &noise, keeps_sums, error);
    if (ok) merge->sun = noise.sun, noise.sun = NULL;
    merge_sums_free(&sums);
    merge_noise_free(&noise);
    if (!ok) merge_free(merge);
    return ok;
}

void merge_free(Merge *merge) {
    for (int i = 0; i < merge->count; i++) part_free(&merge->parts[i]);
    free(merge->parts);
    free(merge->sun);
    part_free(&merge->whole);
    image_free(&merge->image);
    *merge = (Merge){0};
}
