/* face_pieces.h - a face of any shape, cut into convex pieces.
 *
 * A face consists of the points of its plane that its border winds round (nonzero rule, or an odd number of times). It
 * may be concave, cross itself, or have a slit to a hole. All decisions are made in the coordinate plane nearest to the
 * face's plane, since dropping a coordinate rounds nothing. */
#ifndef ROBERTS_MODEL_FACE_PIECES_H
#define ROBERTS_MODEL_FACE_PIECES_H

#include "model/face_plane.h"

/* Greatest number of corners of a piece: what the hiding compares at once. */
enum { PIECE_CORNERS = 16 };

/* A corner of the face, or a point where its border crosses itself. */
typedef struct piece_node {
    roberts_vec2 at;         /* in the coordinate plane */
    uint32_t vertex;         /* ROBERTS_NONE: a crossing */
    roberts_vec3 point, low; /* of a crossing: model units, and what rounding took from them */
} piece_node;

/* A convex polygon. Each of its sides is a side of the ring that it was cut from, or a cut. */
typedef struct face_piece {
    uint32_t count;
    uint32_t node[PIECE_CORNERS];
    uint32_t label[PIECE_CORNERS]; /* below the ring's length: a side of the ring; from there on: a cut */
} face_piece;

/* A stretch of the face's border with the piece on its left; or a cut of a face that is not planar. */
typedef struct piece_side {
    uint32_t from, to; /* nodes */
    uint32_t piece;
    uint32_t side; /* of the face, counted from 0: from its corner `side` to the next; ROBERTS_NONE: a cut */
} piece_side;

/* A corner of a ring whose ears are cut: its neighbours round the ring, and along a space-filling curve. */
typedef struct ring_link {
    uint32_t node, next, last, label;
    uint32_t z, next_z, last_z;
} ring_link;

/* Cuts one face at a time; the arrays serve face after face. Zeroed = empty. */
typedef struct face_pieces {
    fitted_plane fit;  /* relative to the first corner of the ring; of a crossing border, of the plane that is used */
    double chord;      /* greatest extent of the face along an axis */
    bool planar;       /* false: each piece is a triangle with a plane of its own */
    double turned;     /* -1 if the coordinate plane shows the normal from behind, else 1 */
    int axis;          /* the coordinate that is dropped */
    uint32_t *ring;    /* [ring_count] nodes round the face, neighbours distinct */
    uint32_t *side_of; /* [ring_count] the side of the face that begins there */
    piece_node *node;
    face_piece *piece;
    piece_side *side;
    ring_link *link; /* scratch of the ear clipping */
    roberts_vec3 *relative;
    size_t ring_count, node_count, piece_count, side_count;
    size_t ring_room, side_of_room, node_room, piece_room, side_room, link_room, relative_room;
} face_pieces;

/* What all faces have in common. */
typedef struct face_rules {
    const roberts_vec3 *point;
    double tolerance; /* how far corners may lie off a plane, as a part of the face's size */
    double touching;  /* points nearer than this touch; model units */
    double unit;      /* a power of two near the scene's size */
    bool even_odd;
} face_rules;

/* Cuts the face with these corners, any number of them. A face without area gives no piece. False: no memory. */
bool face_pieces_cut(face_pieces *f, const face_rules *rules, const uint32_t *corner, uint32_t count);

void face_pieces_free(face_pieces *f);

/* ---- the parts of it ------------------------------------------------------------------------------------------- */

/* > 0 if a, b, c turn left; the sign is exact for all but contrived input. */
double piece_turn(roberts_vec2 a, roberts_vec2 b, roberts_vec2 c);

/* Cuts a simple polygon of nodes that turns left on the whole into triangles. It may touch itself, or run along a slit
 * both ways. `merge`: join triangles to convex polygons. False: no memory. (triangulate.c) */
bool face_pieces_triangulate(face_pieces *f, const uint32_t *ring, uint32_t count, bool merge);

/* If the ring crosses or touches itself, cuts it into the cells of its arrangement, and sets *done. False: no memory.
 * (arrangement.c) */
bool face_pieces_arrange(face_pieces *f, const face_rules *rules, bool *done);

/* Appends a side. False: no memory. */
bool face_pieces_add_side(face_pieces *f, piece_side side);

#endif
