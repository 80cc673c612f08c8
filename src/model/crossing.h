/* crossing.h - the segments in which two faces cross.
 *
 * Two faces cross at a point where each goes on at both sides of the other's plane, however near to the point. A face
 * is planar: one convex piece, or several that follow one another in the scene and share a plane. Cuts between its
 * pieces do not end a segment. An edge of the file does that lies in the other face's plane: that edge is the line.
 *
 * Signs. A corner is on the other face's plane if it is also a corner of that face, by its number, or if it is no
 * farther from the plane than the touching distance and that face's own departure from its plane. So what pokes through
 * a face by less than that only touches it, and gives no line. Distances are computed in doubles with a bound of their
 * error, and in double-double numbers where that bound is more than an eighth of what touches. There they are off by
 * less than 1e-20 of the scene's size for any face that is wider than the touching distance: an exact computation could
 * decide nothing else.
 *
 * Ends. A segment ends at a corner, or where a side pq of one face pierces the plane F of the other, at
 * p + F(p) / (F(p) - F(q)) (q - p) in double-double numbers from the coordinates as read, with p before q in the order
 * of x, y, z. F is Newell's plane through the mean of the corners. So faces that share a side end at the same point,
 * bit for bit. Of an end within the touching distance of a corner of either face, that corner is the end. */
#ifndef ROBERTS_MODEL_CROSSING_H
#define ROBERTS_MODEL_CROSSING_H

#include "base/dd.h"
#include "model/scene.h"

/* What all faces have in common. */
typedef struct crossing_rules {
    const roberts_scene *scene;
    double touching; /* model units */
} crossing_rules;

/* A face with its plane. Lengths are in the scene's unit; the plane's are times the length of n. */
typedef struct crossing_face {
    uint32_t body;
    uint32_t first, end;      /* its pieces in the scene */
    roberts_vec3 origin, low; /* model units: its first corner */
    roberts_vec3 n;           /* Newell's normal of all pieces, of any length */
    double mean;              /* the plane is n.(P - origin) = mean */
    double length;            /* of n */
    double error;             /* of n.(P - origin) - mean, for each unit of |P - origin| + chord */
    double chord;             /* bound of the distance of a corner from the origin */
    double touch;             /* of the plane; in lengths of n */
    dd3 exact_n;              /* if `refined` */
    dd exact_mean;
    bool refined;
} crossing_face;

/* A computed point: the sum of both. */
typedef struct crossing_point {
    roberts_vec3 point, low;
    uint32_t vertex; /* of the scene, if it is a corner of one of the faces; else ROBERTS_NONE */
} crossing_point;

/* A maximal segment in which two faces cross, or in which one ends on the other along an edge that is not drawn. */
typedef struct crossing_segment {
    uint32_t body[2];      /* whose faces they are */
    uint32_t face[2];      /* the first pieces of both, in the scene */
    uint32_t edge[2];      /* edges of these bodies along it, if it is one of the latter; else ROBERTS_NONE */
    crossing_point end[2]; /* end[0] has the smaller x, or y where those touch, or z */
} crossing_segment;

/* Two faces, by their first pieces. A side of the first lies in the plane of the second, but not all of that face: it
 * may end there along an edge. */
typedef struct crossing_touch {
    uint32_t body[2], face[2];
} crossing_touch;

typedef struct crossing_list {
    crossing_segment *item;
    size_t count, room;
    crossing_touch *touch;
    size_t touch_count, touch_room;
} crossing_list;

/* The planar face that a piece of `body` belongs to. */
crossing_face crossing_face_of(const crossing_rules *rules, uint32_t body, uint32_t piece);

/* Does the face consist of several pieces? */
static inline bool crossing_in_pieces(const crossing_face *f)
{
    return f->end - f->first > 1;
}

/* How one face lies about the plane of another. */
typedef struct crossing_lie {
    bool over, under; /* it has corners there; a face in the plane has neither */
    bool side;        /* a side of one of its pieces lies in the plane, and is no side of the other face */
} crossing_lie;

/* How f lies about the plane of g. Of a face in one piece that has corners on both sides no side is looked for: it can
 * have none. */
crossing_lie crossing_lie_of(const crossing_rules *rules, const crossing_face *f, crossing_face *g);

/* May the face end on the other one along a side? */
static inline bool crossing_ends_on(crossing_lie lie)
{
    return lie.side && (lie.over || lie.under);
}

/* Appends the segments in which two different faces cross, in the order of their first ends; also whether one of them
 * may end on the other. False: no memory. */
bool crossing_find(const crossing_rules *rules, crossing_face *f, crossing_face *g, crossing_list *out);

/* Appends what of an edge of f lies inside of g, if it lies in the plane of g. v: its ends, vertices of the scene.
 * False: no memory. */
bool crossing_find_in(const crossing_rules *rules, crossing_face *f, const uint32_t v[2], crossing_face *g,
                      crossing_list *out);

/* Appends what an edge v of f and an edge u of g have in common, if each lies in the plane of the other face. */
bool crossing_find_common(const crossing_rules *rules, crossing_face *f, const uint32_t v[2], crossing_face *g,
                          const uint32_t u[2], crossing_list *out);

void crossing_list_free(crossing_list *list);

#endif
