/* scene.h - solids: the model in the form that all later stages read.
 *
 * Everything is numbered compactly and solid by solid: solid s owns vertices solid[s].vertex .. solid[s+1].vertex - 1,
 * and in the same way its faces and edges (a sentinel solid closes the list). `number` leads back to the input.
 *
 * Invariants: every face has at least three different corners, counter-clockwise seen from outside; its plane F has
 * F > 0 inside. Solids are numbered by their smallest input vertex (of several that share it, by their smallest face; a
 * vertex that several solids use is there once for each; a hull by that of all its points); vertices and faces of a solid
 * ascend by input number; edges ascend by (number of v[0], number of v[1]) and v[0] < v[1]. A face that is narrower than
 * the tolerance, or has no area, is wound like its neighbours and may have a plane that leans on theirs; it is the only
 * kind of face whose corners may turn the other way about its plane. An edge may come to have one face only (f[1] ==
 * ROBERTS_NONE) once open meshes are drawn; today every edge has two. */
#ifndef ROBERTS_MODEL_SCENE_H
#define ROBERTS_MODEL_SCENE_H

#include "base/vec.h"

typedef struct scene_solid {
    uint32_t vertex, face, edge; /* first of each; the next solid's first ends them */
} scene_solid;

typedef struct scene_edge {
    uint32_t v[2]; /* compact vertex numbers, v[0] < v[1] */
    uint32_t f[2]; /* compact face numbers; v[0] -> v[1] runs counter-clockwise round f[0] */
} scene_edge;

/* Arrays that belong to the mesh while solids are built. */
enum { LENT_POINT = 1, LENT_FACE_START = 2 };

struct roberts_scene {
    uint32_t solid_count, vertex_count, face_count, edge_count;
    unsigned lent; /* LENT_...; none once the scene is built */
    size_t corner_count;
    scene_solid *solid;     /* [solid_count + 1] */
    roberts_vec3 *point;    /* [vertex_count] as read, so that exact arithmetic can go back to it */
    roberts_vec3 *low;      /* [vertex_count] what rounding took from `point`; NULL but where the near plane cuts */
    uint32_t *number;       /* [vertex_count] vertex number in the input; of welded vertices the smallest */
    uint32_t *face_start;   /* [face_count + 1] into corner; a face has fewer than 2^32 corners in all */
    uint32_t *corner;       /* [corner_count] compact vertex numbers */
    plane *face_plane;      /* [face_count] of points relative to `centre` */
    double *face_deviation; /* [face_count] greatest distance of a corner from the fitted plane, model units */
    double *face_width;     /* [face_count] area over greatest chord: between half of the least width and all of it */
    uint32_t *face_number;  /* [face_count] face number in the input; ROBERTS_NONE: a face of a hull */
    scene_edge *edge;       /* [edge_count] */
    roberts_color *vertex_color, *face_color; /* as in the input, compact numbering; NULL where there are none */
    roberts_vec3 box_min, box_max;            /* box round all vertices that faces use */
    roberts_vec3 centre;                      /* middle of that box */
};

/* How many corners the faces of solid s have: where it is closed, twice the number of its edges. */
static inline uint32_t scene_corners(const roberts_scene *scene, uint32_t s)
{
    return scene->face_start[scene->solid[s + 1].face] - scene->face_start[scene->solid[s].face];
}

#endif
