/* Many spheres in a tree of boxes, as the lists that glsl/shape/spheres.glsl reads. */
#pragma once

enum { SPHERE_TREE_COLUMNS = 4096, SPHERE_TREE_OCTANTS = 8 };

/* Eight lists of `entries` entries, for the octants of directions (bit 0 is set where x is negative, bit 1 y,
 * bit 2 z). An entry is two texels, so 8 floats: box      the corner nearest to such rays, 0; the farthest
 * corner, how many entries on it goes past the box sphere   centre, radius; its number, 0, 0, 0 Behind a box
 * comes what it holds, the nearer half first. */
typedef struct SphereTree {
    int entries;
    int rows;      /* of SPHERE_TREE_COLUMNS texels, for all lists; the last one is filled up with zeros */
    float *texels; /* owned; 4 floats each */
} SphereTree;

/* `spheres`: x, y, z, radius of each, finite. Those of radius 0 or less are left out. 0.2 s for 100,000, and
 * 50 MB: there are about as many boxes as spheres. */
SphereTree sphere_tree_create(const float *spheres, int count);
void sphere_tree_destroy(SphereTree *tree);
