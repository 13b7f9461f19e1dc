#include "scene/sphere_tree.h"

#include "base/memory.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

enum { BINS = 16, MOST_IN_LEAF = 8, ENTRY = 8 /* floats */ };

typedef struct Box {
    float low[3], high[3];
} Box;

typedef struct Item {
    Box box;
    int number; /* of the sphere */
} Item;

/* A box with what it holds: two nodes, the lower one along `axis` right behind this one, or, where `other` is
 * 0, items. A node of one item has no box in the lists. */
typedef struct Node {
    Box box;
    int first, count; /* of the items */
    int axis, other;
} Node;

typedef struct Builder {
    const float *spheres;
    Item *items;
    Node *nodes;
    int node_count;
} Builder;

static const Box nothing = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

/* Not fminf(), which minds what is not a number and is a call. */
static float least(float a, float b) {
    return a < b ? a : b;
}

static float most(float a, float b) {
    return a > b ? a : b;
}

static void box_add(Box *box, const Box *other) {
    for (int k = 0; k < 3; k++) {
        box->low[k] = least(box->low[k], other->low[k]);
        box->high[k] = most(box->high[k], other->high[k]);
    }
}

static double half_area(const Box *box) {
    double x = (double)box->high[0] - (double)box->low[0], y = (double)box->high[1] - (double)box->low[1],
           z = (double)box->high[2] - (double)box->low[2];
    return x * y + y * z + z * x;
}

/* Rounded outward. */
static Box box_of(const float sphere[4]) {
    Box box;
    for (int k = 0; k < 3; k++) {
        double low = (double)sphere[k] - (double)sphere[3], high = (double)sphere[k] + (double)sphere[3];
        box.low[k] = (float)low, box.high[k] = (float)high;
        if ((double)box.low[k] > low) box.low[k] = nextafterf(box.low[k], -INFINITY);
        if ((double)box.high[k] < high) box.high[k] = nextafterf(box.high[k], INFINITY);
    }
    return box;
}

/* Twice the middle. */
static float middle(const Box *box, int axis) {
    return box->low[axis] + box->high[axis];
}

/* Where to cut: items of the bins before `bin` go below, of BINS even bins along the middles. */
typedef struct Cut {
    int axis, bin;
    float low, bins_per_length;
    double cost; /* entries that a ray which meets the node is expected to look at, without the node's own */
} Cut;

static int bin_of(const Cut *cut, const Box *box) {
    int bin = (int)((middle(box, cut->axis) - cut->low) * cut->bins_per_length);
    return bin < 0 ? 0 : bin < BINS ? bin : BINS - 1;
}

/* Of a part: its box, and what it holds where that is met, by the surface area heuristic; a sphere alone
 * needs no box. */
static double part_cost(const Box *box, int count, double whole_area) {
    return count == 1 ? 1 : 1 + count * half_area(box) / whole_area;
}

/* The best cut along the axis of `cut`, if better than *best. */
static void try_axis(const Item *items, int count, double area, Cut cut, Cut *best) {
    Box boxes[BINS], above[BINS], below = nothing;
    int counts[BINS] = {0}, counts_above[BINS], count_below = 0;
    for (int b = 0; b < BINS; b++) boxes[b] = nothing;
    for (int i = 0; i < count; i++) {
        int b = bin_of(&cut, &items[i].box);
        counts[b]++;
        box_add(&boxes[b], &items[i].box);
    }
    for (int b = BINS - 1; b >= 0; b--) {
        above[b] = boxes[b];
        counts_above[b] = counts[b];
        if (b == BINS - 1) continue;
        box_add(&above[b], &above[b + 1]);
        counts_above[b] += counts_above[b + 1];
    }
    for (int b = 1; b < BINS; b++) {
        box_add(&below, &boxes[b - 1]);
        count_below += counts[b - 1];
        if (!count_below || !counts_above[b]) continue;
        cut.bin = b;
        cut.cost = part_cost(&below, count_below, area) + part_cost(&above[b], counts_above[b], area);
        if (cut.cost < best->cost) *best = cut;
    }
}

/* The cost is infinite where all middles are at one place. */
static Cut best_cut(const Item *items, int count, const Box *box) {
    Cut best = {.cost = INFINITY};
    double area = half_area(box);
    for (int axis = 0; axis < 3; axis++) {
        float low = INFINITY, high = -INFINITY;
        for (int i = 0; i < count; i++) {
            low = least(low, middle(&items[i].box, axis));
            high = most(high, middle(&items[i].box, axis));
        }
        float bins_per_length = (float)BINS / (high - low);
        if (!(high > low) || !isfinite(bins_per_length)) continue;
        try_axis(items, count, area, (Cut){axis, 0, low, bins_per_length, 0}, &best);
    }
    return best;
}

/* Moves the items below the cut to the front; returns how many they are. */
static int divide(Item *items, int count, const Cut *cut) {
    int below = 0;
    for (int i = 0; i < count; i++) {
        if (bin_of(cut, &items[i].box) >= cut->bin) continue;
        Item item = items[i];
        items[i] = items[below];
        items[below++] = item;
    }
    return below;
}

/* A cut leaves at most 15/16 of a length, or half of the items: so deep does the recursion go. */
static int build(Builder *builder, int first, int count) {
    Item *items = builder->items + first;
    int index = builder->node_count++, below = 0;
    Node node = {.box = nothing, .first = first, .count = count};
    for (int i = 0; i < count; i++) box_add(&node.box, &items[i].box);
    if (count > 1) {
        Cut cut = best_cut(items, count, &node.box);
        node.axis = cut.axis;
        if (cut.cost < count || (count > MOST_IN_LEAF && isfinite(cut.cost))) {
            below = divide(items, count, &cut);
        } else if (count > MOST_IN_LEAF) {
            below = count / 2;
        }
    }
    if (below) {
        build(builder, first, below);
        node.other = build(builder, first + below, count - below);
    }
    builder->nodes[index] = node;
    return index;
}

static float *write_sphere(const Builder *builder, int number, float *entry) {
    for (int k = 0; k < 4; k++) entry[k] = builder->spheres[4 * number + k];
    entry[4] = (float)number;
    return entry + ENTRY;
}

/* The node's entries for an octant; returns the end. */
static float *write(const Builder *builder, int index, int octant, float *entry) {
    const Node *node = &builder->nodes[index];
    float *box = entry;
    if (node->count == 1) return write_sphere(builder, builder->items[node->first].number, entry);
    for (int k = 0; k < 3; k++) {
        bool negative = octant >> k & 1;
        box[k] = negative ? node->box.high[k] : node->box.low[k];
        box[4 + k] = negative ? node->box.low[k] : node->box.high[k];
    }
    entry += ENTRY;
    if (node->other) {
        bool other_first = octant >> node->axis & 1;
        entry = write(builder, other_first ? node->other : index + 1, octant, entry);
        entry = write(builder, other_first ? index + 1 : node->other, octant, entry);
    } else {
        for (int i = 0; i < node->count; i++)
            entry = write_sphere(builder, builder->items[node->first + i].number, entry);
    }
    box[7] = (float)((entry - box) / ENTRY);
    return entry;
}

SphereTree sphere_tree_create(const float *spheres, int count) {
    Builder builder = {.spheres = spheres, .items = memory_get((size_t)count, sizeof(Item))};
    SphereTree tree = {0};
    int present = 0;
    for (int i = 0; i < count; i++) {
        if (spheres[4 * i + 3] > 0) builder.items[present++] = (Item){box_of(spheres + 4 * i), i};
    }
    if (present) {
        builder.nodes = memory_get(2 * (size_t)present, sizeof(Node));
        build(&builder, 0, present);
    }
    tree.entries = present;
    for (int i = 0; i < builder.node_count; i++) tree.entries += builder.nodes[i].count > 1;
    size_t list = (size_t)tree.entries * ENTRY, row = 4 * (size_t)SPHERE_TREE_COLUMNS;
    tree.rows = (int)((SPHERE_TREE_OCTANTS * list + row - 1) / row);
    tree.texels = memory_get((size_t)tree.rows * row, sizeof(float));
    for (int octant = 0; present && octant < SPHERE_TREE_OCTANTS; octant++)
        write(&builder, 0, octant, tree.texels + (size_t)octant * list);
    free(builder.items);
    free(builder.nodes);
    return tree;
}

void sphere_tree_destroy(SphereTree *tree) {
    free(tree->texels);
    *tree = (SphereTree){0};
}
