/* source.h - which input file a solid comes from. Messages name the file, and number solids, faces and vertices within
 * it. */
#ifndef ROBERTS_MODEL_SOURCE_H
#define ROBERTS_MODEL_SOURCE_H

#include "model/scene.h"

typedef struct solid_source {
    const char *file;             /* "": it has no name, or the solid comes from several files */
    uint32_t solid, face, vertex; /* the file's first of each, to be subtracted from numbers over all files */
} solid_source;

/* Returns the file that contains all of vertices v_least .. v_most and faces f_least .. f_most, numbered as in the
 * mesh; `solid` is 0. */
solid_source source_find(const roberts_mesh *mesh, uint32_t v_least, uint32_t v_most, uint32_t f_least,
                         uint32_t f_most);

/* Returns the file of solid s, which is laid out. */
solid_source source_of_solid(const roberts_scene *scene, uint32_t s, const roberts_mesh *mesh);

/* Returns the file of solid s by its vertices alone, for a solid whose faces are not in the file. */
solid_source source_of_points(const roberts_scene *scene, uint32_t s, const roberts_mesh *mesh);

#endif
