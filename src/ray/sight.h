/* sight.h - sight lines against faces, in model space. The basis of `--verify` and `--pick`.
 *
 * A sight line runs from a point X toward the viewer: along dir, or to the eye. It meets a face F if X is behind F and
 * the line passes every side AB of F on the inner side: v . (XA x XB) >= 0. The product is six times the volume of the
 * tetrahedron spanned by the segments v and AB of the two lines. Divided by |v x AB| it is the distance of the lines,
 * which can be compared with a length, in both projections alike.
 *
 * No coordinate is turned or projected, and there are no tests 1 to 4 and no grid. Only the solids, and what the near
 * plane leaves of them, are shared with hidden-line removal.
 *
 * Lengths are in `unit`, and points are relative to the scene's centre. So products of coordinates stay far from
 * overflow and underflow. */
#ifndef ROBERTS_RAY_SIGHT_H
#define ROBERTS_RAY_SIGHT_H

#include "model/scene.h"
#include "view/view.h"

enum {
    SIGHT_NOT_FRONT = 0, /* back or edge-on */
    SIGHT_FRONT = 1,
    SIGHT_UNSURE = 2, /* front or edge-on: the picture is about epsilon wide */
};

typedef struct sight {
    const roberts_scene *scene; /* the given scene, or `turned` */
    /* NULL if all bodies are convex. Otherwise the scene with all faces of the other bodies turned toward the viewer,
     * plane and corners, since they hide from both sides: each of them is front or edge-on. */
    roberts_scene *turned;
    roberts_vec3 *P;       /* [vertex_count] */
    unsigned char *facing; /* [face_count] */
    /* [face_count] how far a corner of the face lies outside one of its sides at most. Faces given to few digits, or
     * clipped by the near plane, are only nearly convex. */
    float *dent;
    bool *sampled; /* [face_count] see sight_through(); NULL: no face is sampled */
    bool perspective;
    roberts_vec3 viewpoint; /* the eye, or the unit vector toward the viewer */
    double unit;            /* model units, a power of two */
    /* The touching distance is measured after the view's map. In model space it is at least `tight` and at most
     * `loose`, both with an extra factor SIGHT_MARGIN. The rounding of coordinates and distances is below
     * `rounding`. */
    double tight, loose, rounding;
} sight;

/* Tolerated factor in the touching distance. The rule compares distances in view space, from the sides and the plane of
 * a face, with epsilon. Distances measured in another way (from a corner, along another line) agree with those within
 * this factor. */
#define SIGHT_MARGIN 4.0

/* Prepares `s` for `scene` as seen by `v`, from view_prepare(). Of `v`, only unit, epsilon and the distance of the eye
 * are used, not the frame. False: no memory. */
bool sight_prepare(sight *s, const roberts_scene *scene, const view *v);
void sight_free(sight *s);

/* Determines which faces are sampled. This pays for many queries: the time is proportional to all corners times the
 * samples. False: no memory; sight_free() is still needed. */
bool sight_sample(sight *s);

/* Converts a point of the model to these coordinates. */
static inline roberts_vec3 sight_point(const sight *s, roberts_vec3 p)
{
    return vec3_scale(1.0 / s->unit, vec3_sub(p, s->scene->centre));
}

/* Returns the vector from X toward the viewer; in perspective it ends at the eye. */
static inline roberts_vec3 sight_from(const sight *s, roberts_vec3 X)
{
    return s->perspective ? vec3_sub(s->viewpoint, X) : s->viewpoint;
}

/* Returns F(X): how far X lies behind (> 0) or in front of a front face. */
static inline double sight_behind(const sight *s, uint32_t face, roberts_vec3 X)
{
    plane F = scene_plane(s->scene, face);
    return F.a * X.x + F.b * X.y + F.c * X.z + F.d / s->unit;
}

/* How certain an answer is. Exact contact has a rule: a point on a side is inside, and a point in the plane is not
 * behind it. Within the touching distance but not in contact, either answer may be right: an edge that runs along a
 * side is drawn as if it touched it, but an edge that crosses the side is cut at the crossing itself. */
typedef enum sight_answer { SIGHT_NO, SIGHT_POSSIBLY, SIGHT_SURELY } sight_answer;

/* Does the line through X along v, toward the viewer, pass within the sides of the face? The answer is "possibly" if it
 * passes outside a side by no more than the touching distance, `slack` and the face's dents together.
 *
 * A `sampled` face has very many corners. Most lines need only one of its sides, or a triangle of some of its corners:
 * no side cuts that triangle, so a line well within it passes within all sides. */
sight_answer sight_through(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v, double slack);

/* Does the line pass within the sides, farther from all of them than the touching distance? */
bool sight_well_through(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v);

/* Returns the point where the line through X along v meets the plane of the face: F(X) + t (v . n) = 0. */
roberts_vec3 sight_meet(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v);

/* Does the face hide X? It does if X lies behind its plane and the sight line passes through it. The answer is
 * "possibly" if X lies behind by less than the touching distance plus the face's departure from its plane. A face that
 * is not front hides nothing. */
sight_answer sight_hides(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v, double slack);

/* Does the same by stricter rules: near the plane or a side the answer is "possibly" on both sides of it, in front and
 * behind, outside and inside, except in contact. An edge that only just reaches behind a face may count as touching it,
 * and one that ends just in front of it as ending in it.
 *
 * `ends`: of the edge that X lies on. If X is in contact but the ends are not, the edge crosses the plane or the side
 * at X. Rounding decides exactly where, so this is also only "possibly". */
sight_answer sight_hides_strictly(const sight *s, uint32_t face, roberts_vec3 X, roberts_vec3 v, double slack,
                                  const roberts_vec3 ends[2]);

/* A part of a segment, from t0 to t1. */
typedef struct sight_part {
    double t0, t1;
} sight_part;

/* Finds the part of the segment AB that the face certainly hides, 0 <= t0 <= t1 <= 1; the border counts as inside.
 * False: none. Uses the clipping of Cyrus and Beck. For a sampled face the part may be too short, or be missed, if it
 * lies completely between a few samples and the border. */
bool sight_hidden_part(const sight *s, uint32_t face, roberts_vec3 A, roberts_vec3 B, sight_part *part);

/* Returns the distance from the face's plane, on either side, that counts as lying in it. */
double sight_touch(const sight *s, uint32_t face);

/* Does X lie behind the face by more than sight_touch()? True for a face that is not front. */
bool sight_well_behind(const sight *s, uint32_t face, roberts_vec3 X);

#endif
