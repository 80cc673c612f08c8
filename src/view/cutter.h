/* cutter.h - a scene that is being clipped, shared by clip.c and clip_surface.c. */
#ifndef ROBERTS_VIEW_CUTTER_H
#define ROBERTS_VIEW_CUTTER_H

#include "view/clip.h"

typedef struct cutter {
    view_clip *clip;
    const roberts_scene *from;
    roberts_vec3 eye, dir; /* dir: unit vector from the look-at point to the eye */
    double near;
    double touching; /* model units: a point nearer to the near plane than this lies in it, an eye nearer to a face lies
                        on it */
    scene_solid first; /* first vertex, face and edge of the current solid in the clipped scene */
    bool whole;        /* no vertex of the current solid is in front of the near plane: it is not cut */
    double *depth;     /* [vertex_count of from] distance from the eye's plane */
    uint32_t *vertex;  /* [vertex_count of from] number in the clipped scene, or ROBERTS_NONE */
    uint32_t *cut;     /* [edge_count of from] vertex at which the edge is cut, or ROBERTS_NONE */
    uint32_t *next; /* [edge_count of from] next cut edge round the cap, counter-clockwise; a permutation of a solid's
                       cut edges, since each leads into one of its faces and out of the other */
    roberts_vec3 *ring; /* [corners] scratch: positions of the corners of a clipped face */
    size_t vertex_room, low_room, number_room, start_room, corner_room, plane_room, deviation_room, width_room,
        face_room;
    size_t edge_room, cap_room, ring_room;
    struct cut_side *side; /* [side_count] cut sides of a body that is not convex, sorted by their ends */
    size_t side_count, side_room, plane_of_room, whole_room, edge_is_room, many_room, many_face_room, part_room,
        many_faces;
} cutter;

/* Is the vertex kept? A vertex in the plane is cut off with those in front of it. So no face degenerates to a line, and
 * no cap lies on a face. */
static inline bool cutter_keeps(const cutter *c, uint32_t v)
{
    return c->depth[v] > c->near || c->whole;
}

/* These functions return false if there is no memory. */
bool cutter_add_vertex(cutter *c, roberts_vec3 point, roberts_vec3 low, uint32_t number);
bool cutter_add_corner(cutter *c, uint32_t vertex);

/* Completes the face whose corners have been added. */
bool cutter_add_face(cutter *c, plane F, double deviation, double width, uint32_t number);
bool cutter_add_edge(cutter *c, uint32_t v0, uint32_t v1, uint32_t f0, uint32_t f1, bool cap);

/* Adds the vertex that divides the edge from A to B at t. */
bool cutter_add_cut(cutter *c, roberts_vec3 A, roberts_vec3 B, double t);

/* ---- bodies that are not convex (clip_surface.c) --------------------------------------------------------------- */

/* Creates the scene_surface of the clipped scene. */
bool cutter_begin_surface(cutter *c);

/* Clips one body. map: [face_count of from] receives the new numbers of its faces. */
bool cutter_cut_surface(cutter *c, uint32_t body, uint32_t *map);

#endif
