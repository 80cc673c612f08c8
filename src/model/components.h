/* components.h - which faces of a mesh belong together: connected components of the face-vertex incidence. */
#ifndef ROBERTS_MODEL_COMPONENTS_H
#define ROBERTS_MODEL_COMPONENTS_H

#include "roberts.h"

#include "model/repeated_solids.h"

/* Allocates the scene's arrays, except the edges, and fills them with all components of `faces`, ordered by their
 * smallest vertex: vertices, faces and corners in compact numbers, corners in the order of the file, and the box.
 * Planes and edges come later. Components need not be closed.
 * faces   cleaned first, if some corner repeats an earlier one of its face
 * lend    the scene may point to arrays of the mesh that equal its own; scene->lent tells which
 * list    empty before; receives the patterns of the solids if they have been found on the way
 * False: no memory. */
bool components_lay_out(roberts_scene *scene, polygons *faces, const roberts_mesh *mesh, bool lend,
                        repeated_solids *list);

#endif
