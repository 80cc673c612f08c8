/* mesh.h - growing a mesh: what only the readers need.
 *
 * Invariants between calls: face_start[0] = 0; starts ascend and end at corner_count; a colour array is NULL or has an
 * entry for each vertex or face; every corner is below vertex_count. */
#ifndef ROBERTS_READ_MESH_H
#define ROBERTS_READ_MESH_H

#include <math.h>

#include "roberts.h"

/* The most vertices or faces: they are numbered by uint32_t, and ROBERTS_NONE is not a number. */
#define MESH_MOST ((size_t)UINT32_MAX - 1)

/* Model units: the greatest coordinate. Squares and products of three stay finite, including those of differences. */
#define MESH_COORDINATE_MAX 1e150

/* Is this coordinate in range? */
static inline bool mesh_coordinate(double x)
{
    return fabs(x) <= MESH_COORDINATE_MAX;
}

static inline bool mesh_position(roberts_vec3 p)
{
    return mesh_coordinate(p.x) && mesh_coordinate(p.y) && mesh_coordinate(p.z);
}

/* The size of a mesh, for rolling back to it. */
typedef struct mesh_mark {
    size_t vertices, faces, corners, sources, groups;
    bool has_vertex, has_start, has_corner, has_vertex_color, has_face_color, has_source,
        has_group; /* which arrays existed */
} mesh_mark;

mesh_mark mesh_here(const roberts_mesh *mesh);
void mesh_back(roberts_mesh *mesh, mesh_mark mark);

/* Make room for one more vertex or face, or for `more` corners. False: no memory, or more than can be numbered. */
bool mesh_more_vertices(roberts_mesh *mesh);
bool mesh_more_faces(roberts_mesh *mesh);
bool mesh_more_corners(roberts_mesh *mesh, size_t more);

/* Makes room for totals. False as above. */
bool mesh_room(roberts_mesh *mesh, size_t vertices, size_t faces, size_t corners);

static inline bool mesh_vertex_room(roberts_mesh *mesh)
{
    return mesh->vertex_count < mesh->vertex_room || mesh_more_vertices(mesh);
}

static inline bool mesh_face_room(roberts_mesh *mesh)
{
    return mesh->face_count + 1 < mesh->face_room || mesh_more_faces(mesh);
}

static inline bool mesh_corner_room(roberts_mesh *mesh, size_t more)
{
    return more <= mesh->corner_room - mesh->corner_count || mesh_more_corners(mesh, more);
}

/* Append a vertex, or a corner of the current face; end the current face. False as above. */
static inline bool mesh_add_vertex(roberts_mesh *mesh, roberts_vec3 position)
{
    if (!mesh_vertex_room(mesh))
        return false;
    mesh->vertex[mesh->vertex_count++] = position;
    return true;
}

static inline bool mesh_add_corner(roberts_mesh *mesh, uint32_t vertex)
{
    if (!mesh_corner_room(mesh, 1))
        return false;
    mesh->corner[mesh->corner_count++] = vertex;
    return true;
}

static inline bool mesh_end_face(roberts_mesh *mesh)
{
    if (!mesh_face_room(mesh))
        return false;
    mesh->face_start[++mesh->face_count] = (uint32_t)mesh->corner_count;
    return true;
}

/* Sets the colour of vertex or face `index`, which is the last one. Earlier ones without a colour get count 0. */
bool mesh_color_vertex(roberts_mesh *mesh, size_t index, roberts_color color, size_t *filled);
bool mesh_color_face(roberts_mesh *mesh, size_t index, roberts_color color, size_t *filled);

/* If some vertices or faces have a colour, gives count 0 to those from `filled` on. */
bool mesh_color_rest(roberts_mesh *mesh, size_t vertices_filled, size_t faces_filled);

/* Starts an input called `name` (copied). */
bool mesh_source(roberts_mesh *mesh, const char *name);

/* What roberts_mesh_check() checks, except coordinates, sources and groups. */
roberts_status mesh_check_arrays(const roberts_mesh *mesh, roberts_error *error);

/* Marks the current input as storing coordinates in 32-bit floats. */
void mesh_float32(roberts_mesh *mesh);

/* Records that a file of colours, which the current input names, is missing. Only the first one is kept. False: no
 * memory. */
bool mesh_missing(roberts_mesh *mesh, const char *path);

/* Two units of the last place of rounded coordinates, model units; 0: none. Rounding moves a point along each axis by
 * at most a quarter of that. */
typedef struct mesh_steps {
    double float32; /* of the largest coordinate read as a 32-bit float */
    double decimal; /* of the largest decimal one, if all have few digits: of the last digit, or of a printed float */
} mesh_steps;

/* Finds the steps. Each input says whether it holds 32-bit floats. decimals: look for rounded decimals, too, as
 * read/README.md describes; otherwise their step is 0. */
mesh_steps mesh_rounding(const roberts_mesh *mesh, bool decimals);

/* Room for the name of a group, including its end; longer names are truncated. */
enum { MESH_GROUP_NAME = 256 };

/* Starts a group called `name` (copied) for the following faces; "": no group. */
bool mesh_group(roberts_mesh *mesh, const char *name);

/* Returns a copy of the groups; NULL: there are none, or no memory. */
roberts_group *mesh_groups_copy(const roberts_mesh *mesh);
void mesh_groups_free(roberts_group *group, size_t count);

#endif
