/* The methods by name: what --sky, --light, --sequence and --sun-disk take.
 *
 * A method is a file of the GLSL library and a row of the table in method.c. The row says what the method
 * needs, so that no other file has to know it by name. */
#pragma once

#include "base/error.h"

typedef enum MethodFamily {
    METHOD_SKY,
    METHOD_LIGHT,
    METHOD_SEQUENCE,
    METHOD_SUN,
    METHOD_FURTHER,
    METHOD_FAMILIES
} MethodFamily;

/* Which numbers a method takes behind its name: they say which member of MethodChoice's union is set. */
typedef enum MethodNumbers {
    NUMBERS_NONE,
    NUMBERS_NODES,
    NUMBERS_STEPS,
    NUMBERS_LEVEL,
    NUMBERS_DEGREE
} MethodNumbers;

enum { METHOD_MOST_VARIANTS = 3 };

typedef struct MethodChoice MethodChoice;

/* In a row, what is not mentioned is zero: the method does not need it. */
typedef struct Method {
    MethodFamily family;
    const char *name;
    /* In the GLSL library. A sky's defines sky_radiance(); or sky_sums(), if it integrates. NULL for "table",
     * which is chosen together with the method that fills it. */
    const char *file;
    /* How the name is written with its numbers: "gauss[:n]". NULL where the name is all. */
    const char *form;
    const char *about;
    /* Reads the numbers behind the name, NULL where the user gave none, and sets choice->text and what
     * follows from the numbers. A row without this function takes no numbers. */
    bool (*parse)(MethodChoice *choice, const char *numbers, Error *error);
    MethodNumbers numbers;
    /* What a menu offers, where the numbers make a method faster or slower; the name alone if there are none.
     */
    const char *variants[METHOD_MOST_VARIANTS];

    /* A sky: it sums scattered light along the ray, for each ray anew or once to fill a table. */
    bool integrates;

    /* A light: it looks up the irradiance of the open sky (sky/irradiance.h). */
    bool needs_irradiance;
    /* A light: it draws directions by the sky's brightness (sky/sky_sampler.h). */
    bool needs_sky_sampler;
    /* A light: at each hit it loops over the scene's bounds. */
    bool loops_over_bounds;
    /* A light: each hit sends a ray to the sky by way of one of the scene's portals, and looks the sky up. */
    bool samples_portals;
    /* A light: how often a path evaluates the sky, beside once at its end and at each hit that looks for it.
     */
    int extra_sky_lookups;
    /* A light: its matte surfaces are not Lambert's, as those that light paths from the sun meet are. */
    bool own_lobe;

    /* A sequence: its points are more even than independent ones. */
    bool low_discrepancy;
    /* A sequence: Markov chains propose the paths, and splat their light (render/chain_pass.h). `file` is for
     * the passes beside them. The paths of a chain depend on each other, so no error can be told. */
    bool walks_chains;

    /* A sun: the disk is there, so that rays can meet it. */
    bool has_disk;
    /* A sun: each hit sends a ray toward the disk. What no such ray can reach is then left to chance. */
    bool samples_disk;
    /* A sun: a second program draws the disk's own image (glsl/pass/sun_image.glsl). */
    bool draws_image;
    /* A sun: light paths from the disk are traced too, and their light is splatted (render/photon_pass.h). */
    bool traces_light;
} Method;

/* Steps of the paper's sums: along the view ray, and from each of its points back and toward the sun. */
typedef struct MethodSteps {
    int view, light;
} MethodSteps;

/* A table's half above the horizon; the half below has as many. */
typedef struct MethodTable {
    /* 0 where the size is found for each position of the sun (bias_table_size()). */
    int columns, rows;
    /* The most that a table whose size is found may add to a picture's error, relRMSE in percent. 0 where the
     * size is given. */
    double percent;
} MethodTable;

/* A method with its numbers. */
struct MethodChoice {
    const Method *method;
    /* In full: "table:gauss:8". */
    char text[48];
    /* Why auto took the method, for the user to read; empty where the user named it. */
    char why[200];
    /* A sky: whether `method` fills a table, in which rays then look the sky up, and that table's size. */
    bool table;
    MethodTable table_size;
    /* Loop iterations of one call of the method, at most. */
    long iterations;
    /* By method->numbers. */
    union {
        int nodes;
        MethodSteps steps;
        double level;
        int degree;
    };
};

/* What is common to a family. */
typedef struct MethodFamilyRow {
    /* The option that takes the family's methods: "--sky". */
    const char *option;
    /* What an option that is not given, or is "auto", stands for where nothing is known of the picture. */
    const char *fallback;
    /* What auto takes where the picture is known, in words (choice/auto.h). */
    const char *automatic;
} MethodFamilyRow;

const MethodFamilyRow *method_family(MethodFamily family);

/* The rows of all families; NULL past the end. */
const Method *method_get(int index);

/* Whether `text` leaves the choice to the program: NULL, or "auto". */
bool method_is_auto(const char *text);

/* Whether `text` is "reference": the adaptive quadrature on the processor (sky/sky_reference.h), which is no
 * method for pictures. */
bool method_is_reference(const char *text);

/* `text` as on the command line. NULL or "auto" is the family's fallback. STATUS_USAGE names what is known.
 */
MUST_CHECK bool method_choose(MethodChoice *choice, MethodFamily family, const char *text, Error *error);
