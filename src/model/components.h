/* components.h - which faces belong together: connected components of the face-vertex incidence. */
#ifndef ROBERTS_MODEL_COMPONENTS_H
#define ROBERTS_MODEL_COMPONENTS_H

#include "model/patterns.h"
#include "model/polygons.h"

/* Allocates the scene's arrays, but for the edges, and lays out all components of `faces` in it, by their smallest vertex:
 * vertices, faces and corners in compact numbers, corners in the order of the file, and the box round them. No planes and no
 * edges yet. Components need not be closed.
 * Where that tells the solids' patterns, they are in `list`, which is empty before.
 * `faces` is cleaned first if some corner repeats an earlier one of its face.
 * Where the mesh may `lend` its arrays and the scene's would be equal, the scene points to them: scene->lent tells which.
 * False: no memory. */
bool components_lay_out(roberts_scene *scene, polygons *faces, const roberts_mesh *mesh, bool lend, patterns *list);

#endif
