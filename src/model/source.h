/* source.h - which input file a solid comes from. Messages name the file, and count solids, faces and vertices within
 * it. */
#ifndef ROBERTS_MODEL_SOURCE_H
#define ROBERTS_MODEL_SOURCE_H

#include "model/scene.h"

typedef struct solid_source {
    const char *file;             /* "": it has no name, or the solid is made of several files */
    uint32_t solid, face, vertex; /* the file's first, to be taken from numbers that count over all files */
} solid_source;

/* The file that holds all of vertices v_least .. v_most and faces f_least .. f_most, numbers as in the mesh; `solid` is
 * left 0. */
solid_source source_find(const roberts_mesh *mesh, uint32_t v_least, uint32_t v_most, uint32_t f_least,
                         uint32_t f_most);

/* The file of solid s, which is laid out. */
solid_source source_of_solid(const roberts_scene *scene, uint32_t s, const roberts_mesh *mesh);

/* The same by the solid's vertices alone, where its faces are none of the file's. */
solid_source source_of_points(const roberts_scene *scene, uint32_t s, const roberts_mesh *mesh);

#endif
