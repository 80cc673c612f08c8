/* fronts.h - the scene in view space: the boxes of all bodies, and the fronts of those that may be seen.
 *
 * A front is what can hide lines. A convex solid is one front: its front faces, within their common outline (the cycle
 * of its edges with one front face). Tests 2 to 4 use this outline once for all faces. If there are many front faces,
 * each of them is a front, or all of them are a bundle (see bundle.h). In other bodies each face is a front.
 *
 * Bodies are taken nearest first. A body whose box lies behind the covers of earlier ones is culled: it is not mapped,
 * none of its edges is a line, and it has no front, since it hides nothing that the covers do not hide. */
#ifndef ROBERTS_HIDE_FRONTS_H
#define ROBERTS_HIDE_FRONTS_H

#include "base/bits.h"
#include "hide/bundle.h"
#include "hide/cover.h"
#include "hide/runs.h"

/* The first two kinds are whole fronts, with an outline; the others are single faces. */
typedef enum hide_kind {
    HIDE_CONVEX_SOLID, /* all front faces of a convex solid, tested together */
    HIDE_BUNDLE,       /* all front faces of a convex solid, tested by a tree: bundle.h */
    HIDE_SOLID_FACE,   /* one face of a convex solid; the solid hides the hull of what its faces hide */
    HIDE_SURFACE_FACE, /* one face of a body that is not convex; it hides from both sides */
} hide_kind;

typedef struct hide_front {
    uint32_t solid;
    uint32_t piece; /* a single face: its number in the scene */
    uint8_t kind;   /* hide_kind */
    bool listed;    /* false: a copy of another front, or hidden by faces of its own body */
} hide_front;

/* Additional data of a whole front. */
typedef struct hide_whole_front {
    double reach;        /* distance from the solid up to which the planes of its faces can be trusted */
    uint32_t face;       /* first of its faces in hide_fronts.face */
    uint32_t outline;    /* first of its corners in hide_fronts.outline */
    uint32_t corners;    /* of the outline */
    float loose;         /* the front may leave gaps of this width in its outline */
    float depth;         /* inside the outline, everything that is nowhere nearer than this is behind the front */
    uint32_t face_count; /* of its faces */
} hide_whole_front;

/* A single face, computed whenever it is needed: most faces of a mesh never are. */
typedef struct hide_single {
    uint32_t front; /* whose face it is; ROBERTS_NONE: nothing is computed yet */
    hide_face face;
    uint32_t turned[SEEN_TURNED]; /* room for its corners: see seen_corners() */
} hide_single;

/* A triangle in the picture, rounded to floats: x of its corners counter-clockwise, and of the first two again; then y.
 * NaN: the front is no triangle. */
typedef struct hide_triangle {
    float x[5], y[5];
} hide_triangle;

typedef struct hide_fronts {
    seen *seen;
    const roberts_scene *scene; /* seen->scene */
    const roberts_vec3 *P;      /* seen->P */
    hide_space space;
    hide_box *box;         /* [solid_count]; NULL after hide_fronts_drop_boxes() */
    unsigned char *culled; /* [solid_count] 1: hidden, or the near plane has left nothing of it */
    unsigned char *late;   /* [solid_count] facing that the faces at the back of a closed body probably have; a wrong
                              guess costs time alone. VIEW_UNKNOWN, or NULL: no guess */
    unsigned char *rear;   /* [solid_count] star_body_rear(): these faces hide nothing that others of their body do not
                              hide, and their body hides what lies in them. NULL: not known of any */
    bool waits;            /* late faces are no fronts yet: see layers_add_late() */
    hide_face *face;       /* faces of whole fronts, front by front; there may be unused entries between fronts */
    hide_whole_front *whole; /* [whole_count] */
    hide_front *front;       /* [front_count] whole fronts come first */
    hide_box *front_box;     /* [front_count] */
    hide_triangle *triangle; /* [front_count] the fronts in the picture. NULL: not kept. See hide_fronts_keep() */
    uint32_t convex_count;   /* convex solids of the scene */
    uint32_t *next_copy;     /* [whole_count] of each front, another copy of it, or ROBERTS_NONE; NULL: no copies */
    uint32_t whole_count, front_count;
    size_t room;       /* of `front` and `front_box` */
    double thickest;   /* what is nearer than a front's box by more than this does not touch it; INFINITY: unknown */
    uint32_t *outline; /* corners of outlines, front by front, as compact vertex numbers; with unused entries too */
    bundle_table bundles;
    runs_table face_runs, outline_runs; /* of faces and of outlines with very many corners */
    cover cover;
    cover **own;                      /* [solid_count] covers that hide faces and lines of their own body; or NULL */
    uint32_t most_corners;            /* of a face or an outline */
    double hull_gap;                  /* view units: how far outlines lie inside the hulls that replace them */
    size_t face_count, back, edge_on; /* faces of bodies that are not culled, by their facing */
    size_t culled_count;              /* bodies that are hidden; not those that the near plane has removed */
    roberts_vec2 low, high;           /* box of the picture, view units */
} hide_fronts;

/* Maps what is seen and makes its fronts. Two of the options matter: the number of threads, and whether hidden lines
 * are kept. If they are not, bodies that are wholly hidden are culled. looked_up: point_solid() will be called, even
 * if hidden lines are not kept. False: no memory, and `fronts` is empty. */
bool hide_fronts_build(hide_fronts *fronts, seen *s, const roberts_hide_options *options, bool looked_up);
void hide_fronts_free(hide_fronts *fronts);

/* Keeps the triangles of fronts as floats, side by side, for bodies whose own data lie anywhere in memory. False: no
 * memory. */
bool hide_fronts_keep(hide_fronts *fronts, uint32_t threads);

/* Frees the boxes of bodies, unless there are single faces: only these need them from now on. */
void hide_fronts_drop_boxes(hide_fronts *fronts);

/* Prefetches the data of a solid that will soon be read or written; they may lie anywhere in memory. (Inlined: see
 * base/bits.h.) */
BITS_INLINE void hide_fronts_fetch(const hide_fronts *fronts, uint32_t solid)
{
    const roberts_scene *scene = fronts->scene;
    const scene_solid *s = &scene->solid[solid];
    size_t vertices = s[1].vertex - s->vertex, faces = s[1].face - s->face;
    FETCH_ARRAY(fronts->P + s->vertex, vertices * sizeof *fronts->P);
    if (scene->face_plane)
        FETCH_ARRAY(scene->face_plane + s->face, faces * sizeof *scene->face_plane);
    FETCH_AHEAD(fronts->seen->facing + s->face);
    FETCH_AHEAD(scene->edge + s->stored);
}

/* Is the front a single face? */
static inline bool hide_is_face(const hide_front *front)
{
    return front->kind >= HIDE_SOLID_FACE;
}

/* Returns the covers that hide faces and lines of their own body, or NULL. */
static inline const cover *hide_own_cover(const hide_fronts *fronts, uint32_t body)
{
    return fronts->own ? fronts->own[body] : NULL;
}

/* Has the body lines? One that the near plane has removed has only clipped ones. */
static inline bool hide_has_lines(const hide_fronts *fronts, uint32_t body)
{
    return !fronts->culled[body] || (fronts->seen->clip.clipped && fronts->seen->rules.hidden);
}

/* Returns the depth of the farthest of these vertices. */
static inline double hide_farthest(const hide_fronts *fronts, const uint32_t *corner, uint32_t corners)
{
    double depth = INFINITY;
    for (uint32_t i = 0; i < corners; i++)
        depth = lesser(depth, fronts->P[corner[i]].z);
    return depth;
}

/* Returns the key of a front: it does not hide lines that list this key. */
static inline uint32_t hide_key(const hide_fronts *fronts, const hide_front *front)
{
    return front->kind == HIDE_SURFACE_FACE ? scene_plane_number(fronts->scene, front->piece)
                                            : seen_body_key(front->solid);
}

/* Returns star_body_rear() of a body. Otherwise than VIEW_UNKNOWN: no two of its faces cross. */
static inline unsigned char hide_rear_facing(const hide_fronts *fronts, uint32_t body)
{
    return fronts->rear ? fronts->rear[body] : VIEW_UNKNOWN;
}

/* Returns the facing of the late faces of a body. VIEW_UNKNOWN: it has none. */
static inline unsigned char hide_late_facing(const hide_fronts *fronts, uint32_t body)
{
    return fronts->late && !fronts->culled[body] ? fronts->late[body] : VIEW_UNKNOWN;
}

/* Returns the outline of a front as a polygon for tests 2 to 4; only its corners are set. turned: as in
 * seen_corners(). */
static inline hide_face hide_outline(const hide_fronts *fronts, uint32_t front, uint32_t turned[SEEN_TURNED])
{
    hide_face outline = {.corner = NULL};
    if (hide_is_face(&fronts->front[front])) {
        outline.corner = seen_corners(fronts->seen, fronts->front[front].piece, &outline.count, turned);
    } else {
        outline.corner = fronts->outline + fronts->whole[front].outline;
        outline.count = fronts->whole[front].corners;
    }
    return outline;
}

/* Computes a single face of a body. (In front.c.) */
void hide_make_face(const hide_fronts *fronts, uint32_t solid, uint32_t piece, hide_single *to);

/* Returns the faces of a front. `single` is the room for a single face, which may be there already. */
static inline const hide_face *hide_faces(const hide_fronts *fronts, uint32_t front, uint32_t *count,
                                          hide_single *single)
{
    const hide_front *f = &fronts->front[front];
    *count = 1;
    if (hide_is_face(f)) {
        if (single->front != front) {
            hide_make_face(fronts, f->solid, f->piece, single);
            single->front = front;
        }
        return &single->face;
    }
    *count = fronts->whole[front].face_count;
    return fronts->face + fronts->whole[front].face;
}

/* Returns the tree over a front's faces; NULL: there is none. */
static inline const bundle *hide_bundle(const hide_fronts *fronts, uint32_t front)
{
    if (hide_is_face(&fronts->front[front]))
        return NULL;
    return bundle_of(&fronts->bundles, fronts->whole[front].face, fronts->whole[front].face_count);
}

/* Returns how wide the gaps are that a front may leave in its outline. */
static inline double hide_loose(const hide_fronts *fronts, uint32_t front)
{
    return front < fronts->whole_count ? (double)fronts->whole[front].loose : 0.0;
}

/* Is X inside a convex polygon of the picture, or no farther outside than `slack`? table: that of faces or that of
 * outlines. */
static inline bool hide_polygon_holds(const hide_fronts *fronts, const runs_table *table, const uint32_t *corner,
                                      uint32_t count, roberts_vec2 X, double slack)
{
    const runs *r = runs_of(table, corner, count);
    if (r)
        return runs_hold_point(&fronts->space, r, corner, X, slack);
    for (uint32_t i = 0; i < count; i++)
        if (!hide_side_holds(fronts->P[corner[i]], fronts->P[corner[i + 1 < count ? i + 1 : 0]], X, slack,
                             fronts->space.epsilon))
            return false;
    return true;
}

#endif
