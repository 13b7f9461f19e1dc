#include "scene/mist_words.h"

#include "base/number.h"
#include "scene/annotation_parameters.h"

#include <math.h>

/* What a word of the annotation is worth: a number, or a slider with or without a minus. */
static double value_of(const Scene *scene, int word) {
    const SceneFile *file = scene->file;
    const char *text = file->mist.words[word];
    double number = 0;
    const Parameter *slider = parameters_find_slider(file, text + (*text == '-'));
    if (slider) {
        number = scene->values.parameters[slider - file->parameters][0];
        return *text == '-' ? -number : number;
    }
    return *text && number_parse(text, &number) ? number : 0;
}

static void place_words(const Scene *scene, Text *text) {
    double region[6];
    for (int i = 0; i < 6; i++) region[i] = value_of(scene, MIST_REGION + i);
    switch (scene->file->mist.shape) {
    case MIST_EVERYWHERE:
        text_print(text, "everywhere");
        break;
    case MIST_SPHERE:
        text_print(text, "a sphere of %g m about %g,%g,%g", region[3], region[0], region[1], region[2]);
        break;
    case MIST_BOX:
        text_print(text, "a box of %g x %g x %g m about %g,%g,%g", 2 * region[3], 2 * region[4],
                   2 * region[5], region[0], region[1], region[2]);
        break;
    case MIST_BELOW:
        text_print(text, "all below a height of %g m", region[0]);
        break;
    }
}

/* Three numbers, or one where they are the same. */
static void numbers(Text *text, const double values[3]) {
    bool same = values[0] == values[1] && values[1] == values[2];
    text_print(text, "%.3g", values[0]);
    if (!same) text_print(text, " %.3g %.3g (red, green, blue)", values[1], values[2]);
}

static void extinction_words(const Scene *scene, Text *text) {
    const Mist *mist = &scene->file->mist;
    double extinction[3], free_m[3], largest = 0;
    for (int c = 0; c < 3; c++) {
        extinction[c] = value_of(scene, MIST_EXTINCTION + (mist_is_coloured(mist) ? c : 0));
        free_m[c] = 1 / extinction[c];
        largest = fmax(largest, extinction[c]);
    }
    text_print(text, "  a metre of it takes away the share ");
    numbers(text, extinction);
    text_print(text, " of the light (extinction, 1/m)");
    if (largest > 0) {
        text_print(text, ": light goes ");
        numbers(text, free_m);
        text_print(text, " m through it on average (mean free path)");
    }
    if (mist->falls)
        text_print(text, ";\n  so much at the height %g m, and in each %g m of height it thins to 1/e",
                   value_of(scene, MIST_BASE), value_of(scene, MIST_FALLOFF));
    if (scene->file->facts.makes_mist)
        text_print(text, ";\n  scene_mist() says how much of this is there at a place, from 0 to 1");
    text_print(text, "\n");
}

static void scattering_words(const Scene *scene, Text *text) {
    double albedo[3], g = value_of(scene, MIST_FORWARD);
    for (int c = 0; c < 3; c++) albedo[c] = value_of(scene, MIST_ALBEDO + c);
    text_print(text, "  of the light that it takes away it scatters the share ");
    numbers(text, albedo);
    text_print(text, " (albedo) and absorbs the rest;\n  %s (phase function of %s, mean cosine %g)\n",
               g > 0.1    ? "most of it goes on forward"
               : g < -0.1 ? "most of it is sent back"
                          : "about as much goes on forward as is sent back",
               scene->file->mist.shanks ? "Cornette and Shanks" : "Henyey and Greenstein", g);
}

static void air_words(const Scene *scene, Text *text) {
    const Atmosphere *a = &scene->values.atmosphere;
    double free_km[3];
    for (int c = 0; c < 3; c++)
        free_km[c] = 1e-3 / (a->rayleigh * a->rayleigh_scatter_per_m[c] +
                             a->mie * a->mie_scatter_per_m[c] * a->mie_extinction_ratio);
    text_print(text, "air%s: the atmosphere's own, between the surfaces\n  at the height 0 light goes ",
               scene_has_air(scene) ? "" : ", switched off here");
    numbers(text, free_km);
    text_print(text,
               " km through it on average (mean free path), and it thins to 1/e in %.3g km of height;\n"
               "  the air scatters as Rayleigh says, as much forward as back, and its aerosols by the phase "
               "function of Cornette and Shanks, most of it forward\n",
               1e-3 * a->rayleigh_scale_height_m);
}

void mist_words(const Scene *scene, Text *text) {
    if (scene->file->mist.line) {
        text_print(text, "mist%s: ", scene_has_mist(scene) ? "" : ", switched off here");
        place_words(scene, text);
        text_print(text, "\n");
        extinction_words(scene, text);
        scattering_words(scene, text);
    }
    if (scene->file->air_line) air_words(scene, text);
}
