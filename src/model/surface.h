/* surface.h - the faces of bodies that are not convex: their convex pieces, and the edges between them, before they are
 * laid out in the scene.
 *
 * No face is refused, and no winding is trusted. Vertices and faces are numbered as in the mesh. Copies of vertices,
 * then points where borders cross themselves, are numbered after the mesh's vertices. Pieces are numbered in the order
 * of their faces. */
#ifndef ROBERTS_MODEL_SURFACE_H
#define ROBERTS_MODEL_SURFACE_H

#include "model/face_pieces.h"
#include "model/scene.h"

/* The plane of a face that has several pieces. */
typedef struct surface_fit {
    uint32_t piece;  /* the first piece */
    uint32_t vertex; /* the plane is n.(P - this vertex) = mean */
    roberts_vec3 n;  /* seen from the end of n, the pieces turn counter-clockwise */
    double mean, deviation, width;
} surface_fit;

/* A side of a piece, or a part of one. The piece is on the left of v[0] -> v[1], seen from the end of its normal. */
typedef struct surface_side {
    uint32_t v[2];
    uint32_t piece; /* with SURFACE_CUT: the side is a cut, not a side of the face */
} surface_side;

#define SURFACE_CUT 0x80000000u
#define SURFACE_WIRE (SURFACE_CUT - 1)   /* instead of a piece: the side belongs to no face */
#define SURFACE_SHADOW (SURFACE_CUT - 2) /* instead of a piece: the side belongs to a face of another body */
#define SURFACE_TURNED 0x80000000u

/* Returns the number of a piece, without its flag. */
static inline uint32_t surface_piece(uint32_t flagged)
{
    return flagged & ~SURFACE_TURNED;
}

/* An edge, v[0] < v[1]. A piece has the flag SURFACE_TURNED if it is on the right of v[0] -> v[1]. */
typedef struct surface_edge {
    uint32_t v[2];
    uint32_t piece[2]; /* ROBERTS_NONE: no piece */
    uint32_t many; /* with more than two pieces: index of the first of them in surface.many; otherwise ROBERTS_NONE */
    uint32_t many_end;
    uint32_t part; /* index in surface.part; ROBERTS_NONE: it is a whole edge of the file */
    bool cut;      /* not an edge of the file: drawn only if it is an outline */
    bool odd;      /* it is not complete, comes from a side that was divided, or may end beside its pieces */
} surface_edge;

/* A piece round which the border of its face does not wind once, counter-clockwise about its normal. */
typedef struct surface_wound {
    uint32_t piece;
    int32_t winding;
} surface_wound;

typedef struct surface {
    const roberts_mesh *mesh;
    const uint32_t *vertex_of; /* [corners of the mesh] the vertex at each corner */
    const uint32_t *copied;    /* [copies] the mesh's vertex that each copy repeats; copies follow those of the mesh */
    uint32_t copies;
    /* [vertices of the surface] Only sides of one group are compared in space. NULL: all are one group. */
    const uint32_t *group;
    uint32_t vertex_count, piece_count;
    const roberts_vec3 *point; /* [vertex_count] the mesh's own array, unless some border crosses itself */
    roberts_vec3 *own_point, *low;
    uint32_t *start, *corner; /* corners of the pieces */
    uint32_t *face;           /* [piece_count] in the input */
    uint32_t *plane_of;       /* [piece_count] the first piece of its plane */
    surface_fit *fit;         /* [fit_count] sorted by piece */
    surface_wound *wound;     /* [wound_count] sorted by piece: those with a winding number other than 1 */
    surface_side *side;       /* [side_count] */
    scene_part *side_part;    /* [part_count] sorted by side: sides that are parts of a side of the file */
    surface_edge *edge;       /* [edge_count] sorted by v[0], v[1] */
    uint32_t *many;
    scene_part *part; /* entries of edges */
    size_t corner_count, fit_count, wound_count, side_count, part_count, edge_count, many_count, edge_part_count;
    size_t start_room, corner_room, face_room, plane_room, fit_room, wound_room, side_room, part_room, edge_room,
        many_room, edge_part_room, point_room, low_room;
    noted_faces repeated; /* left out as copies of earlier ones */
    noted_faces bent;     /* cross or touch themselves and are not planar; they count as planar */
    noted_faces uncut;    /* their borders cross themselves too often: their sides became wires */
    bool whole_sides;     /* some side may end at a point that is not a corner of its piece */
} surface;

/* Returns the number of vertex v in the mesh; ROBERTS_NONE: it is a point where a border crosses itself. */
static inline uint32_t surface_number(const surface *s, uint32_t v)
{
    const size_t own = s->mesh->vertex_count;
    return v < own ? v : v - own < s->copies ? s->copied[v - own] : ROBERTS_NONE;
}

/* Returns the group of a piece; the surface has groups. */
static inline uint32_t surface_group(const surface *s, uint32_t piece)
{
    return s->group[s->vertex_of[s->mesh->face_start[s->face[piece]]]];
}

/* Which faces are handled here. */
enum {
    LISTED_NOT,    /* it belongs to a convex solid */
    LISTED,        /* to any other body */
    LISTED_CLOSED, /* to a closed one: a triangle is a face unless it is narrower than rules->narrow */
};

/* Cuts the faces that are listed into pieces. Elements of two corners become edges without a face. False: no
 * memory. */
bool surface_take_faces(surface *s, const uint8_t *listed, const face_rules *rules);

/* Returns the parameter of a vertex on the file's edge between v[0] and v[1], from 0 to 1. */
double surface_part_of(const surface *s, const uint32_t v[2], uint32_t at);

void surface_free(surface *s);

#endif
