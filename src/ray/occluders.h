/* occluders.h - the front faces of a scene in a tree of boxes. Finds which of them hide a point, or a part of a
 * segment.
 *
 * For bodies that are not convex, all faces except edge-on ones count as front (see sight.turned). */
#ifndef ROBERTS_RAY_OCCLUDERS_H
#define ROBERTS_RAY_OCCLUDERS_H

#include "ray/sight.h"
#include "ray/tree.h"
#include "view/seen.h"

typedef struct occluders {
    sight s;
    roberts_vec3 right, up, toward; /* axes of the picture that contains the tree's boxes */
    box3 window;                    /* the box of the scene in that picture */
    tree t;                         /* its items are ranges of faces; those that are certainly not front are ignored */
    uint32_t *face_solid;           /* [face_count] */
    uint32_t *twin; /* [solid_count] the solid itself or, if it is not in the tree, a copy of it that is */
    /* [solid_count] how far a back edge may stick out of the picture of its solid's front faces. If coordinates are
     * rounded, faces depart from their planes. */
    double *slack;
} occluders;

/* Prepares `o` for `scene` seen by `v`. rays: [solid_count] the estimated number of rays that will query each solid's
 * faces. False: no memory, and `o` is empty. */
bool occluders_build(occluders *o, const roberts_scene *scene, const view *v, const double *rays);
void occluders_free(occluders *o);

/* Returns a key for the position of X in the picture. Nearby points usually have similar keys. */
uint32_t occluders_place(const occluders *o, roberts_vec3 X);

/* The origin of a query: an edge of `solid`. */
typedef struct occluders_asker {
    uint32_t solid;
    bool own;      /* faces of `solid` itself take part */
    seen_own none; /* faces that do not take part because the edge lies in them */
} occluders_asker;

/* May a face hide points of this edge? Not if the edge lies in it. */
bool occluders_take_part(const occluders *o, const occluders_asker *of, uint32_t face);

/* A query about X, a point of an edge: which faces hide it?
 *
 * `ends`: NULL, or the ends of the edge that X lies on. With them, sight_hides_strictly() gives the answer, which is
 * "surely" only if X is well behind all front faces of a solid. Near the plane of one of them, the rounding of corners
 * and planes may decide whether X is in front of the solid.
 *
 * `nearest`: find the hider nearest to the viewer, not just any hider. */
typedef struct sight_question {
    roberts_vec3 X;
    occluders_asker of;
    bool nearest;
    const roberts_vec3 *ends; /* [2] */
    sight_answer answer;
    uint32_t hider; /* a face that hides X, if the answer is SIGHT_SURELY */
    double height;  /* `nearest`: the picture's z of the hider at X */
} sight_question;

/* Answers `count` queries, at most TREE_POINTS. It is fastest if nearby points are queried together, and nearby groups
 * one after another, because they meet the same faces. w: from tree_walk_init(). Earlier walks affect which of several
 * hiders is found. */
void occluders_cast(const occluders *o, tree_walk *w, sight_question *question, uint32_t count);

/* A search for the faces that hide a part of a segment. */
typedef struct occluders_search {
    const occluders *o;
    roberts_vec3 A, B;
    occluders_asker of;
    tree_search tree;
    const tree_item *item, *item_end; /* items of the leaf that are still to be tested */
    uint32_t face, face_end;          /* faces of the item that are still to be tested */
} occluders_search;

/* Starts a search for faces that hide parts of AB, which lies on the edge `of`. */
void occluders_search_start(occluders_search *s, const occluders *o, roberts_vec3 A, roberts_vec3 B,
                            occluders_asker of);

/* Finds the next face and the part of AB that it certainly hides. False at the end. A face may be found more than
 * once. */
bool occluders_search_next(occluders_search *s, uint32_t *face, sight_part *part);

#endif
