/* occluders.h - all that may hide something: the front faces of a scene, in a tree of boxes, asked point by point. */
#ifndef ROBERTS_RAY_OCCLUDERS_H
#define ROBERTS_RAY_OCCLUDERS_H

#include "ray/sight.h"
#include "ray/tree.h"

typedef struct occluders {
    sight s;
    roberts_vec3 right, up, toward; /* the picture that the tree's boxes live in */
    tree t;
    uint32_t *box_face;   /* [items of the tree] front faces, or nearly; a long one has several boxes */
    uint32_t *face_solid; /* [face_count] */
    double *slack;        /* [solid_count] how far a back edge may stick out of the picture of its solid's front faces
                             where coordinates are rounded: by what all its faces depart from their planes */
} occluders;

/* Prepares `o` for `scene` seen by `v`; rays: [solid_count] about how many will be cast that ask for the solid's faces.
 * False: no memory, and `o` is empty. */
bool occluders_build(occluders *o, const roberts_scene *scene, const view *v, const double *rays);
void occluders_free(occluders *o);

/* What may hide X, a point of an edge of `solid`: faces of all other solids, and if `own` those of that one too. */
typedef struct sight_question {
    roberts_vec3 X;
    uint32_t solid;
    bool own;
} sight_question;

/* Whether anything hides X. `*hider`: a face to ask first, or ROBERTS_NONE; where the answer is SIGHT_SURELY, a face
 * that does. Points next to each other are mostly hidden by the same one. */
sight_answer occluders_cast(const occluders *o, const sight_question *q, uint32_t *hider);

#endif
