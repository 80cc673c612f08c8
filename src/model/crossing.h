/* crossing.h - the segments in which two faces cross.
 *
 * Two faces cross at a point if, arbitrarily near to it, each face lies on both sides of the other plane. A face is
 * planar. It is one convex piece, or several that follow one another in the scene and share a plane. Cuts between its
 * pieces do not end a segment. An edge of the file that lies in the other plane does: the edge is then the line.
 *
 * Signs. A corner is on the other face's plane if it is also a corner of that face, by its number. It is also on the
 * plane if its distance is at most the touching distance plus that face's own departure from its plane. So a body that
 * pokes through a face by less than that only touches it, and gives no line. Distances are computed in doubles, with a
 * bound of their error. If the bound exceeds an eighth of the touching distance, they are computed again in
 * double-double numbers. Then the error is below 1e-20 of the scene's size for every face wider than the touching
 * distance, so an exact computation would decide the same.
 *
 * Ends. A segment ends at a corner, or where a side pq of one face pierces the plane F of the other. That point is
 * p + F(p) / (F(p) - F(q)) (q - p), in double-double numbers from the coordinates as read, with p before q in the order
 * of x, y, z. F is Newell's plane through the mean of the corners. So faces that share a side get the same end, bit for
 * bit. An end within the touching distance of a corner of either face is moved to that corner. */
#ifndef ROBERTS_MODEL_CROSSING_H
#define ROBERTS_MODEL_CROSSING_H

#include "base/dd.h"
#include "base/search.h"
#include "model/scene.h"

/* What all faces share. */
typedef struct crossing_rules {
    const roberts_scene *scene;
    double touching; /* model units */
    /* Is it certain that nobody sees a line whose ends are no more than CROSSING_NEAR touching distances from A and B?
     * Such a line is not computed. NULL: all are. */
    bool (*unseen)(const void *context, roberts_vec3 A, roberts_vec3 B);
    const void *context;
} crossing_rules;

/* Touching distances: how far an end may be from where it is computed in doubles. */
#define CROSSING_NEAR 0.25

/* A face with its plane. Lengths are in the scene's unit; the plane's are times the length of n. */
typedef struct crossing_face {
    uint32_t body;
    uint32_t first, end;      /* its pieces in the scene */
    roberts_vec3 origin, low; /* model units: its first corner */
    roberts_vec3 n;           /* Newell's normal of all pieces, of any length */
    double mean;              /* the plane is n.(P - origin) = mean */
    double length;            /* of n */
    double error;             /* of n.(P - origin) - mean, for each unit of |P - origin| + chord */
    double chord;             /* no corner is farther from the origin */
    double touch;             /* of the plane; in lengths of n */
    double turn;              /* the same for each unit of the distance from the line through the origin along `axis`:
                                 rounding of the coordinates turns the plane of a narrow face about its length */
    roberts_vec3 axis;        /* unit vector, if turn > 0 */
    bool bent;                /* it departs from its plane by more than the touching distance */
    dd3 exact_n;              /* if `refined` */
    dd exact_mean;
    bool refined;
    const uint32_t *near; /* [near_count] the pieces that crossing_limit() leaves, ascending; NULL: all */
    uint32_t near_count;
} crossing_face;

/* A face that is compared with many others: it is computed once, and so is a tree over its pieces if they are many. All
 * zeros: none. */
typedef struct crossing_kept {
    crossing_face face; /* face.end = 0: none */
    box_tree tree;      /* empty: not made yet */
    uint32_t *near;
    size_t near_room;
} crossing_kept;

/* A computed point: the sum of both. */
typedef struct crossing_point {
    roberts_vec3 point, low;
    uint32_t vertex; /* of the scene, if it is a corner of one of the faces; else ROBERTS_NONE */
} crossing_point;

/* A maximal segment in which two faces cross, or in which one ends on the other along an edge that is not drawn. */
typedef struct crossing_segment {
    uint32_t body[2];      /* whose faces they are */
    uint32_t face[2];      /* the first pieces of both, in the scene */
    uint32_t edge[2];      /* in the second case, the edges of these bodies along it; else ROBERTS_NONE */
    bool seam;             /* it is a line only where that edge is a seam of a union */
    crossing_point end[2]; /* end[0] has the smaller x, or y where those touch, or z */
} crossing_segment;

/* Two faces, given by their first pieces. The first face has a side in the plane of the second, but does not lie in
 * that plane: it may end there along an edge. */
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

/* The same, which is computed only if it is not the last one. It is valid until the next one is asked for, and has all
 * its pieces. */
crossing_face *crossing_keep(crossing_kept *kept, const crossing_rules *rules, uint32_t body, uint32_t piece);

/* Leaves of the kept face the pieces that come near another face, until crossing_keep() is called again. Only there may
 * the faces cross or touch. If its pieces are few, all are left. False: no memory. */
bool crossing_limit(crossing_kept *kept, const crossing_rules *rules, const crossing_face *other);

void crossing_kept_free(crossing_kept *kept);

/* Does the face consist of several pieces? */
static inline bool crossing_in_pieces(const crossing_face *f)
{
    return f->end - f->first > 1;
}

/* The position of one face relative to the plane of another. */
typedef struct crossing_lie {
    bool over, under; /* it has corners on that side; a face in the plane has none on either side */
    bool side;        /* a side of a piece lies in the plane, and is not a side of the other face */
} crossing_lie;

/* Finds the position of f relative to the plane of g. A face of one piece with corners on both sides has no side in the
 * plane, so none is looked for. */
crossing_lie crossing_lie_of(const crossing_rules *rules, const crossing_face *f, crossing_face *g);

/* May the face end on the other one along a side? */
static inline bool crossing_ends_on(crossing_lie lie)
{
    return lie.side && (lie.over || lie.under);
}

/* Appends the segments in which two different faces cross, in the order of their first ends. Also finds whether one
 * face may end on the other. False: no memory. */
bool crossing_find(const crossing_rules *rules, crossing_face *f, crossing_face *g, crossing_list *out);

/* Appends the part of an edge of f inside g, if the edge lies in the plane of g. v: its ends, vertices of the scene.
 * False: no memory. */
bool crossing_find_in(const crossing_rules *rules, crossing_face *f, const uint32_t v[2], crossing_face *g,
                      crossing_list *out);

/* May an edge v of f and an edge u of g, each in the plane of the other face, have a part in common? False: their boxes
 * are too far apart. */
bool crossing_may_have_common(const crossing_rules *rules, const crossing_face *f, const uint32_t v[2],
                              const crossing_face *g, const uint32_t u[2]);

/* Appends the overlap of an edge v of f and an edge u of g, if each lies in the plane of the other face. */
bool crossing_find_common(const crossing_rules *rules, crossing_face *f, const uint32_t v[2], crossing_face *g,
                          const uint32_t u[2], crossing_list *out);

void crossing_list_free(crossing_list *list);

#endif
