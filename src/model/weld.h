/* weld.h - vertices at the same position become one. */
#ifndef ROBERTS_MODEL_WELD_H
#define ROBERTS_MODEL_WELD_H

#include "roberts.h"

#include "model/components.h"
#include "model/scene.h"

/* ---- equal positions --------------------------------------------------------------------------------------------- */

/* Sets name[v] to the smallest of the listed vertices that have exactly v's position (-0 is 0), for each of the `count`
 * vertices listed (ascending); other names are left alone. False: no memory. */
bool weld_vertices(uint32_t *name, const uint32_t *listed, uint32_t count, const roberts_vec3 *point);

/* ---- components that are not closed ------------------------------------------------------------------------------ */

/* Components that are not closed as they stand: welded, split, and numbered together with the others. */

/* Welds the components of `scene` (as laid out) that are marked open with one another, splits them into solids, and
 * lays out all solids anew, closed components and split ones alike, numbered by their smallest vertex (of several that
 * share it, by their smallest face). `faces` is cleaned after the welding.
 * keep_open: faces that are no part of a closed solid are laid out too, as one where they share vertices.
 * Returns ROBERTS_OK, _NO_MEMORY, _BAD_NUMBER or, where not `keep_open`, _NOT_CLOSED: `error` then names the first
 * solid that is not closed, one of its edges and how many faces that has. */
roberts_status regroup(roberts_scene *scene, const uint8_t *open, polygons *faces, const roberts_mesh *mesh,
                       bool keep_open, roberts_error *error);

#endif
