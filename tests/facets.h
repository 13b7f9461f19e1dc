/* Light on metal of many small mirrors (facets), by random walks from one facet to the next. */
#pragma once

#include <stdint.h>

enum { FACETS_TINTS = 7 };

/* The shares of the light that leave after one facet, and after any number of them. */
typedef struct FacetsAlbedo {
    double once[FACETS_TINTS], all[FACETS_TINTS];
} FacetsAlbedo;

/* Light meets the surface at `cosine`. The facets' normals are distributed by GGX with the alpha `alpha`, and
 * each facet reflects the share that Schlick's formula gives for its tint.
 *
 * The walk is that of Heitz, Hanika, d'Eon and Dachsbacher, "Multiple-Scattering Microfacet BSDFs with the
 * Smith Model" (2016). Its mean is exact: it leaves off no number of reflections, and no masking or shadowing
 * is approximated beyond Smith's own assumption that neighbouring heights are independent. */
FacetsAlbedo facets_albedo(double alpha, const double tints[FACETS_TINTS], double cosine, uint64_t walks);
