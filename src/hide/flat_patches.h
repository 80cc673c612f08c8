/* flat_patches.h - many neighbouring faces in one plane, as one.
 *
 * A CAD program gives a flat face with thousands of corners as thousands of triangles, long and thin: each is near all
 * others. Whether another face crosses any of them is decided once, for the whole patch:
 *
 * - Faces of one patch lie in one plane. They do not cross.
 * - A face does not cross the patch if it lies on one side of it. It may end there: in a corner, or in a side that it
 *   has in common with a face of the patch. */
#ifndef ROBERTS_HIDE_FLAT_PATCHES_H
#define ROBERTS_HIDE_FLAT_PATCHES_H

#include <stdatomic.h>

#include "model/scene.h"

typedef struct flat_patch {
    roberts_vec3 n; /* its plane, in the scene's unit: n.(P - the vertex `at`) = 0 */
    uint32_t at;
    double over, under; /* how far corners lie on both sides of it, times |n|; rounding included */
} flat_patch;

/* A side on the border of a patch. It is listed in both directions. */
typedef struct flat_side {
    uint32_t patch, v[2];
} flat_side;

typedef struct flat_patches {
    const roberts_scene *scene;
    uint32_t *of;                 /* [face_count] the number of each face's patch; ROBERTS_NONE: it has none */
    flat_patch *patch;            /* [count] */
    flat_side *side;              /* [side_count] sorted */
    atomic_uint_fast64_t *tested; /* [face_count] see flat_patches_beside() */
    size_t count, side_count, side_room;
    double touching; /* in the scene's unit; what is farther apart does not touch */
} flat_patches;

/* Finds the patches of bodies that are not convex. near: in the scene's unit, as `touching` is; corners of a patch are
 * in one plane within this distance. False: no memory; call flat_patches_free() in any case. */
bool flat_patches_find(flat_patches *p, const roberts_scene *scene, double near, double touching);
void flat_patches_free(flat_patches *p);

/* Returns the number of a face's patch; ROBERTS_NONE: it has none. */
static inline uint32_t flat_patches_of(const flat_patches *p, uint32_t face)
{
    return p->count > 0 ? p->of[face] : ROBERTS_NONE;
}

/* Is it certain that a face crosses no face of a patch, since it belongs to the patch, or lies beside it? False for
 * ROBERTS_NONE. */
bool flat_patches_beside(const flat_patches *p, uint32_t face, uint32_t patch);

#endif
