/* face_pieces.h - a face of any shape, cut into convex pieces.
 *
 * A face consists of the points of its plane with a winding number other than 0 (or an odd one, with the even-odd
 * rule). It may be concave, cross itself, or have a slit to a hole. All decisions are made in the coordinate plane
 * nearest to the face's plane, since dropping a coordinate involves no rounding. */
#ifndef ROBERTS_MODEL_FACE_PIECES_H
#define ROBERTS_MODEL_FACE_PIECES_H

#include "model/face_plane.h"

/* Greatest number of corners of a piece: what the fast hiding tests can handle. */
enum { PIECE_CORNERS = 16 };

/* A corner of the face, or a point where its border crosses itself. */
typedef struct piece_node {
    roberts_vec2 at;         /* in the coordinate plane */
    uint32_t vertex;         /* ROBERTS_NONE: a crossing */
    roberts_vec3 point, low; /* of a crossing: model units, and the rounding error of the point */
} piece_node;

/* A convex polygon. */
typedef struct face_piece {
    uint32_t count;
    int32_t winding; /* how often the border winds round it, counter-clockwise about the plane's normal */
    uint32_t node[PIECE_CORNERS];
    uint32_t label[PIECE_CORNERS]; /* a side of the ring or a line of the border; larger labels are cuts. Not
                                      valid once the sides are listed */
} face_piece;

/* A stretch of the face's border with the piece on its left, or a cut of a face that is not planar. */
typedef struct piece_side {
    uint32_t from, to; /* nodes */
    uint32_t piece;
    uint32_t side; /* side of the face, from its corner `side` to the next, counted from 0; ROBERTS_NONE: a cut */
} piece_side;

/* Cuts one face at a time; the arrays are reused for face after face. Zeroed = empty. */
typedef struct face_pieces {
    fitted_plane fit; /* relative to the first corner of the ring; for a border that crosses itself, the plane in use */
    double chord;     /* greatest extent of the face along an axis */
    bool planar;      /* false: each piece is a triangle with a plane of its own */
    bool bent;        /* the border crosses or touches itself, and the face is not planar: it counts as planar */
    bool uncut;       /* the border crosses itself too often to be cut: there are no pieces */
    bool whole_sides; /* ends of sides may not be corners of their pieces */
    double unit;      /* as in face_rules */
    double turned;    /* -1 if the coordinate plane shows the normal from behind, else 1 */
    int axis;         /* the coordinate that is dropped */
    uint32_t *ring;   /* [ring_count] nodes round the face, neighbours distinct */
    uint32_t *side_of; /* [ring_count] the side of the face that begins at each node */
    piece_node *node;
    face_piece *piece;
    piece_side *side;
    roberts_vec3 *relative; /* [ring_count] the corners, relative to the first one, in scene units */
    size_t ring_count, node_count, piece_count, side_count;
    size_t ring_room, side_of_room, node_room, piece_room, side_room, relative_room;
} face_pieces;

/* Settings common to all faces. */
typedef struct face_rules {
    const roberts_vec3 *point;
    double tolerance; /* how far corners may lie off a plane, as a fraction of the face's size */
    double touching;  /* points nearer than this touch; model units */
    double narrow;    /* a triangle of no greater height is no face; model units, at most `touching` */
    double unit;      /* a power of two near the scene's size */
    bool even_odd;
    bool keep_straight; /* pieces with many corners keep those at which they go straight on */
} face_rules;

/* Cuts a face with any number of corners. A face without area gives no piece. False: no memory. */
bool face_pieces_cut(face_pieces *f, const face_rules *rules, const uint32_t *corner, uint32_t count);

void face_pieces_free(face_pieces *f);

/* ---- internals of arrangement.c, triangulate.c and convex_pieces.c ----------------------------------------------- */

/* A line of a border between two nodes, v[0] < v[1]. */
typedef struct border_line {
    uint32_t v[2];
    int32_t net;   /* how often the border runs from v[0] to v[1] minus how often it runs back; not 0 */
    uint32_t side; /* the first side of the face of which it is a part */
} border_line;

/* A node that a line must pass through. */
typedef struct border_stop {
    uint32_t line, node;
    double t; /* along the line */
} border_stop;

/* The border of a face, as a graph. */
typedef struct border {
    border_line *item; /* [count] */
    border_stop *stop; /* [stop_count] */
    size_t count, stop_count, stop_room;
} border;

/* Appends a stop. False: no memory. */
bool border_add_stop(border *b, border_stop stop);

/* Appends the crossing of lines i and j as a node, and as a stop of both. False: no memory. */
bool border_add_crossing(face_pieces *f, border *b, uint32_t i, uint32_t j);

typedef enum tiling {
    TILING_DONE,
    TILING_CROSSED, /* lines cross or touch: b->stop lists some of the points */
    TILING_BROKEN,  /* signs are contradictory, which only numbers out of range can cause */
    TILING_NO_MEMORY,
} tiling;

/* Cuts the region that the border winds round into triangles. Labels of pieces are lines, or cuts from b->count on.
 * (triangulate.c) */
tiling face_pieces_triangulate(face_pieces *f, border *b, bool even_odd);

/* Joins these triangles to convex pieces, and lists their sides along the border. keep_straight: as in face_rules.
 * False: no memory. (convex_pieces.c) */
bool face_pieces_join(face_pieces *f, const border *b, bool keep_straight);

/* Cuts a face that is not convex, whether its border crosses itself or not. False: no memory. (arrangement.c) */
bool face_pieces_arrange(face_pieces *f, const face_rules *rules);

/* Appends the point at t, from 0 to 1, between two nodes. ROBERTS_NONE: no memory. */
uint32_t face_pieces_add_crossing(face_pieces *f, uint32_t a, uint32_t b, double t);

/* Appends a side. False: no memory. */
bool face_pieces_add_side(face_pieces *f, piece_side side);

#endif
