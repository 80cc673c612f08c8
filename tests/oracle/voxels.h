/* voxels.h - the lines of a union of bodies whose faces lie in the planes of the integer grid, found without geometry.
 * Each cell of the grid is full or empty, and the four cells around an edge of the grid decide whether it is drawn. */
#ifndef ROBERTS_TESTS_VOXELS_H
#define ROBERTS_TESTS_VOXELS_H

#include "union_oracle.h"

/* A unit edge of the grid. */
typedef struct voxel_edge {
    roberts_vec3 a, b;
    bool drawn;
    union_class class_; /* if it is drawn */
} voxel_edge;

/* Returns all unit edges that a body reaches. NULL: no memory, or faces that are not rectangles across x on the grid.
 * The caller frees them. */
voxel_edge *voxel_edges(const roberts_mesh *mesh, const oracle_view *view, size_t *count);

#endif
