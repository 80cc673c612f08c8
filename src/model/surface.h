/* surface.h - the faces of bodies that are not convex: their convex pieces, and the edges between them, before they are
 * laid out in the scene.
 *
 * No face is refused, and no winding is trusted. Vertices and faces are numbered as in the mesh; the points where
 * borders cross themselves follow the mesh's vertices. Pieces are numbered in the order of their faces. */
#ifndef ROBERTS_MODEL_SURFACE_H
#define ROBERTS_MODEL_SURFACE_H

#include "model/face_pieces.h"
#include "model/scene.h"

/* The plane of a face that has several pieces. */
typedef struct surface_fit {
    uint32_t piece;  /* the first */
    uint32_t vertex; /* the plane is n.(P - this vertex) = mean */
    roberts_vec3 n;  /* seen from its end, the pieces turn counter-clockwise */
    double mean, deviation, width;
} surface_fit;

/* A side of a piece, or a part of one. The piece is on the left of v[0] -> v[1], seen from the end of its normal. */
typedef struct surface_side {
    uint32_t v[2];
    uint32_t piece; /* with SURFACE_CUT: the side is a cut, no side of the face */
} surface_side;

#define SURFACE_CUT 0x80000000u
#define SURFACE_WIRE (SURFACE_CUT - 1)   /* in place of a piece: the side belongs to no face */
#define SURFACE_SHADOW (SURFACE_CUT - 2) /* in place of a piece: it belongs to a face of another body */
#define SURFACE_TURNED 0x80000000u

/* An edge, v[0] < v[1]. A piece has SURFACE_TURNED if it is on the right of v[0] -> v[1]. */
typedef struct surface_edge {
    uint32_t v[2];
    uint32_t piece[2]; /* ROBERTS_NONE: there is none */
    uint32_t many;     /* if it has more than two pieces: where all of them begin in surface.many; else ROBERTS_NONE */
    uint32_t many_end;
    uint32_t part; /* its entry in surface.part; ROBERTS_NONE: it is a whole edge of the file */
    bool cut;      /* not an edge of the file: drawn only as an outline */
    bool odd;      /* it has not two pieces, comes from a side that was divided, or may end beside its pieces */
} surface_edge;

typedef struct surface {
    const roberts_mesh *mesh;
    const uint32_t *name; /* [vertices of the mesh] the new name of each vertex; NULL: vertices keep their names */
    uint32_t vertex_count, piece_count;
    const roberts_vec3 *point; /* [vertex_count] the mesh's own array, unless some border crosses itself */
    roberts_vec3 *own_point, *low;
    uint32_t *start, *corner; /* of the pieces */
    uint32_t *face;           /* [piece_count] in the input */
    uint32_t *plane_of;       /* [piece_count] the first piece of its plane */
    surface_fit *fit;         /* [fit_count] by piece */
    surface_side *side;       /* [side_count] */
    scene_part *side_part;    /* [part_count] by side: those that are parts of a side of the file */
    surface_edge *edge;       /* [edge_count] by v[0], v[1] */
    uint32_t *many;
    scene_part *part; /* of edges */
    size_t corner_count, fit_count, side_count, part_count, edge_count, many_count, edge_part_count;
    size_t start_room, corner_room, face_room, plane_room, fit_room, side_room, part_room, edge_room, many_room,
        edge_part_room, point_room, low_room;
    size_t repeated;  /* faces that were left out as copies of earlier ones */
    size_t uncut;     /* faces whose borders cross themselves too often: their sides became wires */
    bool whole_sides; /* some side may have an end that is not a corner of its piece */
} surface;

/* Cuts the faces f with listed[f] into pieces. Elements of two corners become edges without a face. False: no
 * memory. */
bool surface_take_faces(surface *s, const uint8_t *listed, const face_rules *rules);

/* Finds the edges: sides that lie on one another, within `touching`, are one edge. The sides are freed. False: no
 * memory. */
bool surface_find_edges(surface *s, double touching);

/* How a point lies to a segment from A to B: within the touching distance of an end, or of what is between them. */
typedef enum surface_touch { TOUCHES_NOT, TOUCHES_START, TOUCHES_END, TOUCHES_BETWEEN } surface_touch;

/* *t: where along the segment the point is. */
surface_touch surface_touches(roberts_vec3 A, roberts_vec3 B, roberts_vec3 P, double touching, double *t);

/* The place of a vertex on the edge of the file between v[0] and v[1], from 0 to 1. */
double surface_part_of(const surface *s, const uint32_t v[2], uint32_t at);

void surface_free(surface *s);

#endif
