/* cutter.h - the clipped scene while it grows. clip.c and clip_surface.c share it. */
#ifndef ROBERTS_VIEW_CUTTER_H
#define ROBERTS_VIEW_CUTTER_H

#include "view/clip.h"

typedef struct cutter {
    view_clip *clip;
    const roberts_scene *from;
    roberts_vec3 eye, dir; /* dir: from the look-at point to the eye, unit */
    double near;
    double touching;   /* a point nearer to the near plane than this lies in it, and an eye this near to a face lies on
                          the face; model units */
    scene_solid first; /* of the solid at hand in the clipped scene */
    bool whole;        /* no vertex of the solid at hand is nearer than the near plane: it is not cut */
    double *depth;     /* [vertex_count of from] distance from the eye's plane */
    uint32_t *vertex;  /* [vertex_count of from] what it is in the clipped scene, or ROBERTS_NONE */
    uint32_t *cut;     /* [edge_count of from] the vertex where the edge is cut, or ROBERTS_NONE */
    uint32_t *next; /* [edge_count of from] of the cap: the cut edge that follows this one, counter-clockwise. This is
                       a permutation of a solid's cut edges, since each leads into one of its faces and out of the
                       other */
    roberts_vec3 *ring; /* [corners] scratch: positions of a cut face */
    size_t vertex_room, low_room, number_room, start_room, corner_room, plane_room, deviation_room, width_room,
        face_room;
    size_t edge_room, cap_room, ring_room;
    struct cut_side *side; /* [side_count] the sides that are cut, by their ends; of a body that is not convex */
    size_t side_count, side_room, plane_of_room, edge_is_room, many_room, many_face_room, part_room, many_faces;
} cutter;

/* A vertex in the plane is cut off with those before it. So no face is left as a line, and no cap lies on a face. */
static inline bool cutter_keeps(const cutter *c, uint32_t v)
{
    return c->depth[v] > c->near || c->whole;
}

/* All of these return false if there is no memory. */
bool cutter_add_vertex(cutter *c, roberts_vec3 point, roberts_vec3 low, uint32_t number);
bool cutter_add_corner(cutter *c, uint32_t vertex);

/* Ends the face whose corners have been added. */
bool cutter_add_face(cutter *c, plane F, double deviation, double width, uint32_t number);
bool cutter_add_edge(cutter *c, uint32_t v0, uint32_t v1, uint32_t f0, uint32_t f1, bool cap);

/* Adds the vertex that divides the edge from A to B at t. */
bool cutter_add_cut(cutter *c, roberts_vec3 A, roberts_vec3 B, double t);

/* Measures the width of the last face of the clipped scene, whose corners begin at `first`. */
bool cutter_measure_width(cutter *c, uint32_t first, double *width);

/* ---- bodies that are not convex (clip_surface.c) --------------------------------------------------------------- */

/* Makes the scene_surface of the clipped scene. */
bool cutter_begin_surface(cutter *c);

/* Cuts one body. map: [face_count of from] takes the new numbers of its faces. */
bool cutter_cut_surface(cutter *c, uint32_t body, uint32_t *map);

#endif
