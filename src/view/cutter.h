/* cutter.h - what clip.c and clip_surface.c share: the clipped scene as it grows. */
#ifndef ROBERTS_VIEW_CUTTER_H
#define ROBERTS_VIEW_CUTTER_H

#include "view/clip.h"

typedef struct cutter {
    view_clip *clip;
    const roberts_scene *from;
    roberts_vec3 eye, dir; /* dir: from the look-at point to the eye, unit */
    double near;
    double touching;    /* what is nearer to the near plane than this lies in it, an eye to a face on it; model units */
    scene_solid first;  /* of the solid at hand in the clipped scene */
    bool whole;         /* the solid at hand is not cut: none of its vertices is nearer than the near plane */
    double *depth;      /* [vertex_count of from] distance from the eye's plane */
    uint32_t *vertex;   /* [vertex_count of from] what it is in the clipped scene, or ROBERTS_NONE */
    uint32_t *cut;      /* [edge_count of from] the vertex where the edge is cut, or ROBERTS_NONE */
    uint32_t *next;     /* [edge_count of from] cap: which cut edge follows this one, counter-clockwise. A permutation
                           of a solid's cut edges: each is entered by in one of its faces and left by in the other */
    roberts_vec3 *ring; /* [corners] scratch: positions of a cut face */
    size_t vertex_room, low_room, number_room, start_room, corner_room, plane_room, deviation_room, width_room,
        face_room;
    size_t edge_room, cap_room, ring_room;
    struct cut_side *side; /* [side_count] of a body that is not convex: its sides that are cut, by their ends */
    size_t side_count, side_room, plane_of_room, edge_is_room, many_room, many_face_room, part_room, many_faces;
} cutter;

/* What lies in the plane goes with what lies before it: so no face is left as a line, and no cap lies on a face. */
static inline bool cutter_keeps(const cutter *c, uint32_t v)
{
    return c->depth[v] > c->near || c->whole;
}

/* Each false: no memory. */
bool cutter_add_vertex(cutter *c, roberts_vec3 point, roberts_vec3 low, uint32_t number);
bool cutter_add_corner(cutter *c, uint32_t vertex);

/* Ends the face whose corners have been added. */
bool cutter_add_face(cutter *c, plane F, double deviation, double width, uint32_t number);
bool cutter_add_edge(cutter *c, uint32_t v0, uint32_t v1, uint32_t f0, uint32_t f1, bool cap);

/* Adds the vertex that divides the edge from A to B at t. */
bool cutter_add_cut(cutter *c, roberts_vec3 A, roberts_vec3 B, double t);

/* Width of the face of the clipped scene whose corners begin at `first`. */
bool cutter_measure_width(cutter *c, uint32_t first, double *width);

/* ---- bodies that are not convex (clip_surface.c) --------------------------------------------------------------- */

/* Gives the clipped scene its scene_surface. */
bool cutter_begin_surface(cutter *c);

/* Cuts one body; map: [face_count of from] what its faces become. */
bool cutter_cut_surface(cutter *c, uint32_t body, uint32_t *map);

#endif
