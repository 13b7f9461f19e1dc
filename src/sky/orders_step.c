#include "sky/orders_step.h"

#include "base/memory.h"
#include "base/vec3.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The field is computed ring by ring: the directions at an altitude that share an elevation, for all suns and
 * azimuths. Along them the path, its nodes and their transmittances are the same. */
typedef struct Ring {
    double height;
    /* The sine of the elevation. */
    double mu;
    /* That of each direction on both sides of the sun, in sr. */
    double solid_angle;
} Ring;

/* A direction of a ring: the sine of the sun's elevation, and the cosine to the sun. */
typedef struct Direction {
    double mu_sun, nu;
} Direction;

typedef struct Work {
    const OrdersStep *step;
    OrdersField field;
    /* Of the harmonics of `field` and of the field before. */
    HarmonicStep steps[HARMONICS_MOST], steps_before[HARMONICS_MOST];
    /* The directions of a ring, [column][azimuth], their number, and their light and its aims. */
    int count;
    Direction *directions;
    double (*light)[3];
    OrdersAim *aims;
    /* The field before at an altitude, [column][harmonic][channel]. */
    double *profile;
} Work;

/* Elevations crowd at the horizon: the sine grows with the square of u from there. */
static Ring ring_at(const OrdersStep *step, int row, int elevation) {
    const SkyOrderPlan *plan = step->plan;
    bool up = elevation < plan->above;
    const OrdersGauss gauss = orders_gauss(up ? plan->above : plan->below);
    Ring ring = {.height = orders_grid_height(step->grid, row)};
    double planet = step->air->atmosphere.planet_radius_m,
           u = gauss.nodes[up ? elevation : elevation - plan->above];
    double horizon = -sqrt(ring.height * (2 * planet + ring.height)) / (planet + ring.height);
    double reach = up ? 1 - horizon : -1 - horizon;
    ring.mu = horizon + reach * u * u;
    ring.solid_angle = fabs(reach) * 2 * u * gauss.weights[up ? elevation : elevation - plan->above] * 2 *
                       pi / plan->azimuths;
    return ring;
}

/* Azimuths are the middles of equal parts of half a turn from the sun. */
static void set_directions(Work *work, const Ring *ring) {
    int azimuths = work->step->plan->azimuths;
    for (int i = 0; i < work->count; i++) {
        double mu_sun = orders_grid_sine(work->step->grid, i / azimuths);
        double level = sqrt(fmax(0, (1 - ring->mu * ring->mu) * (1 - mu_sun * mu_sun)));
        double nu = ring->mu * mu_sun + level * cos(pi * (i % azimuths + 0.5) / azimuths);
        work->directions[i] = (Direction){mu_sun, nu};
    }
}

static void light_first(Work *work, const Ring *ring) {
    for (int i = 0; i < work->count; i++) {
        const Direction *d = &work->directions[i];
        orders_air_first(work->step->air, ring->height, ring->mu, d->mu_sun, d->nu, work->step->gauss,
                         work->light[i]);
    }
}

/* Interpolates the field before to an altitude, for all elevations of the sun at once. */
static void make_profile(Work *work, double height) {
    const OrdersGrid *grid = work->step->grid;
    const OrdersField *before = work->step->before;
    OrdersPlace place = orders_grid_row(grid, height);
    size_t size = 3 * (size_t)harmonics_count(before->degree) * (size_t)grid->columns;
    memset(work->profile, 0, size * sizeof *work->profile);
    for (int i = 0; i < grid->points; i++) {
        const double *row = orders_field_at(grid, before, place.first + i, 0);
        for (size_t k = 0; k < size; k++) work->profile[k] += place.weights[i] * row[k];
    }
}

/* Adds the light that a node of the ring's rays scatters. */
static void light_node(Work *work, const OrdersRay *ray, const OrdersNode *node) {
    const OrdersGrid *grid = work->step->grid;
    size_t stride = 3 * (size_t)harmonics_count(work->step->before->degree);
    make_profile(work, node->height);
    for (int i = 0; i < work->count; i++) {
        OrdersCorner corners[4];
        double sun_rise = ray->path.radius * work->directions[i].mu_sun;
        double mu_sun = (sun_rise + work->directions[i].nu * node->t) / node->radius;
        OrdersPlace place = orders_grid_column(grid, mu_sun);
        for (int k = 0; k < grid->points; k++) {
            const double *at = work->profile + (size_t)(place.first + k) * stride;
            corners[k] = (OrdersCorner){at, place.weights[k]};
        }
        orders_scatter(&work->aims[i], corners, grid->points, ray->path.rise, sun_rise, node, work->light[i]);
    }
}

static void light_next(Work *work, const Ring *ring) {
    const OrdersStep *step = work->step;
    OrdersRay ray;
    orders_ray(step->air, ring->height, ring->mu, step->gauss, NULL, 0, &ray);
    memset(work->light, 0, (size_t)work->count * sizeof *work->light);
    for (int i = 0; i < work->count; i++) {
        const Direction *d = &work->directions[i];
        orders_aim(step->air, work->steps_before, step->before->degree, d->nu, &work->aims[i]);
        orders_field_ground(step->grid, step->before, step->air, &ray, ray.path.radius * d->mu_sun, d->nu,
                            work->light[i]);
    }
    for (int i = 0; i < ray.count; i++) light_node(work, &ray, &ray.nodes[i]);
}

/* Adds the ring's light to the moments of a row. */
static void project(Work *work, int row, const Ring *ring) {
    int harmonics = harmonics_count(work->field.degree);
    double y[HARMONICS_MOST];
    for (int i = 0; i < work->count; i++) {
        int column = i / work->step->plan->azimuths;
        const Direction *d = &work->directions[i];
        double *moments = orders_field_at(work->step->grid, &work->field, row, column), part[3];
        vec3_scale(work->light[i], ring->solid_angle, part);
        harmonics_at(work->steps, work->field.degree, d->nu, harmonics_azimuth(ring->mu, d->mu_sun, d->nu),
                     y);
        for (int k = 0; k < harmonics; k++) {
            for (int c = 0; c < 3; c++) moments[3 * k + c] += y[k] * part[c];
        }
        for (int c = 0; row == 0 && c < 3; c++)
            work->field.ground[3 * column + c] += fmax(ring->mu, 0) * part[c];
    }
}

static Work work_start(const OrdersStep *step) {
    Work work = {.step = step,
                 .field = orders_field_create(step->grid, step->plan->degree),
                 .count = step->grid->columns * step->plan->azimuths};
    size_t count = (size_t)work.count;
    work.directions = memory_get(count, sizeof *work.directions);
    work.light = memory_get(count, sizeof *work.light);
    harmonics_steps(step->plan->degree, work.steps);
    if (step->before) {
        size_t harmonics = (size_t)harmonics_count(step->before->degree);
        harmonics_steps(step->before->degree, work.steps_before);
        work.aims = memory_get(count, sizeof *work.aims);
        work.profile = memory_get(3 * harmonics * (size_t)step->grid->columns, sizeof *work.profile);
    }
    return work;
}

static void work_end(Work *work) {
    free(work->directions);
    free(work->light);
    free(work->aims);
    free(work->profile);
}

bool orders_step(const OrdersStep *step, OrdersField *field) {
    Work work = work_start(step);
    int elevations = step->plan->above + step->plan->below, rows = step->grid->rows;
    bool go_on = true;
    for (int i = 0; go_on && i < rows * elevations; i++) {
        Ring ring = ring_at(step, i / elevations, i % elevations);
        set_directions(&work, &ring);
        if (step->before) {
            light_next(&work, &ring);
        } else {
            light_first(&work, &ring);
        }
        project(&work, i / elevations, &ring);
        double share = step->from + (step->to - step->from) * (i + 1) / (rows * elevations);
        go_on = !step->watch || step->watch->go_on(step->watch->state, share);
    }
    *field = work.field;
    work_end(&work);
    return go_on;
}
