/* sight.h - sight lines against faces, in model space: what verify and pick have in common.
 *
 * A sight line runs from a point X toward the viewer: along dir, or to the eye. It meets a face F where X is behind F
 * and where the line passes all its sides AB on the inner side: v . (XA x XB) >= 0, six times the volume of the
 * tetrahedron that the pieces v and AB of two lines span. Divided by |v x AB| that is the distance of the lines from
 * each other, so it can be compared with a length, in both projections alike.
 *
 * No coordinate is turned or projected for that, and there are no tests 1 to 4 and no grid: nothing is shared with
 * what hides lines but the solids themselves and what the near plane leaves of them.
 *
 * Lengths are counted in `unit`, points from the scene's centre; products of coordinates stay far from over- and
 * underflow. */
#ifndef ROBERTS_RAY_SIGHT_H
#define ROBERTS_RAY_SIGHT_H

#include "model/scene.h"
#include "view/view.h"

enum {
    SIGHT_NOT_FRONT = 0, /* back, or edge-on */
    SIGHT_FRONT = 1,
    SIGHT_UNSURE = 2, /* front or edge-on: the picture is about as wide as epsilon */
};

typedef struct sight {
    const roberts_scene *scene;
    roberts_vec3 *P;       /* [vertex_count] */
    unsigned char *facing; /* [face_count] */
    float *dent;           /* [face_count] bound of how far a corner of the face lies outside of one of its sides: faces
                              that are given to few digits, or cut by the near plane, are only nearly convex */
    bool *sampled;         /* [face_count] see sight_through(); NULL: no face is */
    bool perspective;
    roberts_vec3 viewpoint; /* the direction toward the viewer, of length 1, or the eye */
    double unit;            /* model units, a power of two */
    /* The touching distance, measured after the view's map, as a length here: at least `tight`, at most `loose`, both
     * with a factor SIGHT_MARGIN to spare. Rounding of coordinates and distances is below `rounding`. */
    double tight, loose, rounding;
} sight;

/* How much a decision may depend on where exactly the touching distance lies. The rule compares distances from a face's
 * sides and plane, in view space, with epsilon; whoever measures them otherwise (from a corner, along another line)
 * comes out within this factor. */
#define SIGHT_MARGIN 4.0

/* Prepares `s` for `scene` seen by `camera`, with `v` from view_prepare() (its frame is not used, only unit, epsilon
 * and the distance of the eye). False: no memory. */
bool sight_prepare(sight *s, const roberts_scene *scene, const view *v);
void sight_free(sight *s);

/* Finds out which faces are sampled: for many questions, since it takes time in proportion to all corners times the
 * samples. False: no memory; sight_free() is due as before. */
bool sight_sample(sight *s);

/* A point of the model in these coordinates. */
static inline roberts_vec3 sight_point(const sight *s, roberts_vec3 p)
{
    return vec3_scale(1.0 / s->unit, vec3_sub(p, s->scene->centre));
}

/* From X toward the viewer; in perspective it ends at the eye. */
static inline roberts_vec3 sight_from(const sight *s, roberts_vec3 X)
{
    return s->perspective ? vec3_sub(s->viewpoint, X) : s->viewpoint;
}

/* F(X): how far X lies behind (> 0) or in front of a front face. */
static inline double sight_behind(const sight *s, uint32_t face, roberts_vec3 X)
{
    plane F = s->scene->face_plane[face];
    return F.a * X.x + F.b * X.y + F.c * X.z + F.d / s->unit;
}

/* Exact contact has its rule: on a side counts as inside, in the plane does not count as behind. Nearer than the
 * touching distance, but not in contact, either may be right: an edge that runs along a side is drawn as if it
 * touched, one that crosses it is cut at the crossing itself. */
typedef enum sight_answer { SIGHT_NO, SIGHT_POSSIBLY, SIGHT_SURELY } sight_answer;

/* Whether the line through X along v (toward the viewer) passes within the sides of the face. Outside of a side, but
 * within the touching distance, `slack` and the face's dents of it, it possibly does.
 *
 * Of a face of very many corners that is `sampled`, a side is asked before all, and whether the line passes well
 * within a triangle, or the polygon, of some of its corners: no side of the face cuts that, so that it passes within
 * all of them. */
sight_answer sight_through(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v, double slack);

/* Whether the line passes within the sides, farther from all of them than the touching distance. */
bool sight_well_through(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v);

/* Whether the face hides X from the viewer: X lies behind its plane and the sight line passes through it. Behind, but
 * by less than the touching distance and the face's departure from its plane, it possibly does. A face that is not
 * front hides nothing. */
sight_answer sight_hides(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v, double slack);

/* The same, but what is not in contact is only possible on both sides of where it touches: in front of the plane by
 * less than that distance, and inside of a side. For an edge that only just reaches behind a face may count as
 * touching it, and one that only just ends in front of it as ending in it. `ends`, of the edge that X lies on: where
 * they are not in contact as well, the edge crosses the plane or the side, near X and as exactly as it is computed,
 * and X may be on either side of it. */
sight_answer sight_hides_strictly(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v, double slack,
                                  const roberts_vec3 ends[2]);

/* A part of a segment, from t0 to t1. */
typedef struct sight_part {
    double t0, t1;
} sight_part;

/* The part of the segment AB that the face surely hides, 0 <= t0 <= t1 <= 1; the border counts in. False: none. After
 * M. Cyrus and J. Beck. Of a sampled face a part may come out shorter, or none, where the part lies wholly between a
 * few of its samples and its border. */
bool sight_hidden_part(const sight *s, uint32_t face, roberts_vec3 A, roberts_vec3 B, sight_part *part);

/* How far from the face's plane, on either side, all counts as in it. */
double sight_touch(const sight *s, uint32_t face);

/* Is X farther behind the front face, or nearly front face, than what counts as in its plane? A face that is not
 * front: yes. */
bool sight_well_behind(const sight *s, uint32_t face, roberts_vec3 X);

#endif
