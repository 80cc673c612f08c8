/* occluders.h - all that may hide something: the front faces of a scene, in a tree of boxes, asked point by point. */
#ifndef ROBERTS_RAY_OCCLUDERS_H
#define ROBERTS_RAY_OCCLUDERS_H

#include "ray/sight.h"
#include "ray/tree.h"

typedef struct occluders {
    sight s;
    roberts_vec3 right, up, toward; /* the picture that the tree's boxes live in */
    tree_box window;                /* the scene's in it */
    tree t;               /* its items are ranges of faces, of which the front ones count, or nearly front ones */
    uint32_t *face_solid; /* [face_count] */
    uint32_t *twin;       /* [solid_count] the solid itself; where it is left out, a copy of it that is in the tree */
    double *slack;        /* [solid_count] how far a back edge may stick out of the picture of its solid's front faces
                             where coordinates are rounded: by what all its faces depart from their planes */
} occluders;

/* Prepares `o` for `scene` seen by `v`; rays: [solid_count] about how many will be cast that ask for the solid's faces.
 * False: no memory, and `o` is empty. */
bool occluders_build(occluders *o, const roberts_scene *scene, const view *v, const double *rays);
void occluders_free(occluders *o);

/* A key for X's place in the picture: points of like keys are near each other. */
uint32_t occluders_place(const occluders *o, roberts_vec3 X);

/* What may hide X, a point of an edge of `solid`: faces of all other solids, and if `own` those of that one too. If
 * `ends`, by sight_hides_strictly(), and surely only what is well behind all front faces of a solid: what is about in the plane
 * of one of them is in front of the solid, were its corners and planes exact.
 * `hider`: where the answer is SIGHT_SURELY, a face that does. */
typedef struct sight_question {
    roberts_vec3 X;
    uint32_t solid;
    bool own;
    const roberts_vec3 *ends; /* [2] NULL: not strictly; of the edge that X lies on */
    sight_answer answer;
    uint32_t hider;
} sight_question;

/* Fills in the answers to `count` questions, TREE_POINTS at the most: whether anything hides X. Points next to each other
 * are asked best together, and one such lot after the other, for they have to do with the same faces. w: from
 * tree_walk_init(); `hider` depends on where it has been. */
void occluders_cast(const occluders *o, tree_walk *w, sight_question *question, uint32_t count);

#endif
