#include "cmd/compare_print.h"

#include "base/json.h"

#include <stdio.h>
#include <string.h>

static void print_said(const char *name, const Text *said) {
    for (const char *line = text_string(said); *line;) {
        size_t length = strcspn(line, "\n");
        printf("%-12s %.*s\n", name, (int)length, line);
        line += length + (line[length] == '\n');
    }
}

static void print_radiance(const Comparison *c) {
    printf("relRMSE      %.4f %%\n", c->rel_rmse_percent);
    printf("  trimmed    %.4f %%  (without the 0.1 %% worst pixels, in the mean too)\n", c->trimmed_percent);
    printf("bias R G B   %+.4f %+.4f %+.4f %%\n", c->bias_percent[0], c->bias_percent[1], c->bias_percent[2]);
    printf("largest      %.4f %%\n", c->largest_percent);
    printf("p99          %.4f %%\n", c->p99_percent);
}

void compare_print(const Comparison *c, const CompareSaid *said) {
    const Levels *levels = &c->levels;
    print_said("read A", &said->a);
    print_said("read B", &said->b);
    if (!c->levels_only) print_radiance(c);
    printf("levels RMS   %.4f of 255\n", levels->rms);
    printf("  worst tile %.4f of 255, %dx%d pixels at %d,%d\n", levels->worst_tile, LEVELS_TILE, LEVELS_TILE,
           levels->worst_x, levels->worst_y);
    printf("pixels       %ld, %ld not finite", c->pixels, c->nonfinite);
    if (c->nonfinite) printf(", the first at %d,%d", c->nonfinite_x, c->nonfinite_y);
    printf("\n");
    if (c->outside) printf("outside      %ld left out, as a file's data window lacks them\n", c->outside);
    printf("sun pixels   %ld left out\n", c->sun_pixels);
    if (c->has_z) printf("mean z^2     %.4f, |z| > 4 in %.4f %%\n", c->mean_z2, c->share_z4_percent);
}

static void json_said(Json *json, const char *name, const Text *said) {
    if (!said->size) return;
    Text line = {0};
    text_append(&line, said->data, said->size - 1);
    for (size_t i = 0; i < line.size; i++) {
        if (line.data[i] == '\n') line.data[i] = ';';
    }
    json_text(json, name, text_string(&line));
    text_free(&line);
}

static void json_radiance(Json *json, const Comparison *c) {
    json_number(json, "relRMSE", c->rel_rmse_percent);
    json_number(json, "trimmed", c->trimmed_percent);
    json_numbers(json, "bias_R_G_B", c->bias_percent, 3);
    json_number(json, "largest", c->largest_percent);
    json_number(json, "p99", c->p99_percent);
}

void compare_print_json(const Comparison *c, const CompareSaid *said, bool within) {
    Json json = json_begin();
    json_said(&json, "read_A", &said->a);
    json_said(&json, "read_B", &said->b);
    if (!c->levels_only) json_radiance(&json, c);
    json_number(&json, "levels_RMS", c->levels.rms);
    json_number(&json, "worst_tile", c->levels.worst_tile);
    json_numbers(&json, "worst_tile_at", (double[]){c->levels.worst_x, c->levels.worst_y}, 2);
    json_count(&json, "pixels", (uint64_t)c->pixels);
    json_count(&json, "not_finite", (uint64_t)c->nonfinite);
    if (c->nonfinite) json_numbers(&json, "not_finite_at", (double[]){c->nonfinite_x, c->nonfinite_y}, 2);
    json_count(&json, "outside", (uint64_t)c->outside);
    json_count(&json, "sun_pixels", (uint64_t)c->sun_pixels);
    if (c->has_z) {
        json_number(&json, "mean_z2", c->mean_z2);
        json_number(&json, "share_z4", c->share_z4_percent);
    }
    json_flag(&json, "within", within);
    json_end(&json, stdout);
}
