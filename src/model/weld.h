/* weld.h - merges vertices at the same position; welds and splits components that are not closed. */
#ifndef ROBERTS_MODEL_WELD_H
#define ROBERTS_MODEL_WELD_H

#include "roberts.h"

#include "model/scene.h"

/* Finds whether any two of the `count` listed vertices are at exactly the same position. False: no memory. */
bool weld_any_equal(const uint32_t *listed, size_t count, const roberts_vec3 *point, bool *equal);

/* Components that are not closed are welded and split, and numbered together with the others. */

/* *name receives the name of each vertex of the mesh: in components with open edges the first vertex of them at its
 * position, otherwise its own number. open[]: see weld_regroup(). The caller frees it, also if false is returned: no
 * memory. */
bool weld_open(const roberts_scene *scene, const uint8_t *open, const roberts_mesh *mesh, uint32_t **name);

/* open[]: the kind of `opening` (model/solid.h) of each component of `scene`. Welds the components with open edges with
 * one another, and splits all that are not closed into solids. Then lays out all solids again, closed components and
 * split ones alike, numbered by their smallest vertex (several that share it, by their smallest face). `faces` is
 * cleaned after welding. keep_open: faces that belong to no closed solid are laid out too, as one solid if they share
 * vertices. Returns ROBERTS_OK, _NO_MEMORY, _BAD_NUMBER or, without `keep_open`, _NOT_CLOSED: `error` then names the
 * first solid that is not closed, one of its edges, and the number of faces at that edge. */
roberts_status weld_regroup(roberts_scene *scene, const uint8_t *open, polygons *faces, const roberts_mesh *mesh,
                            bool keep_open, roberts_error *error);

#endif
