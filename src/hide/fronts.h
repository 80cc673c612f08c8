/* fronts.h - the scene in view space: boxes of all solids, fronts of those that are not wholly hidden.
 *
 * A front is what one solid shows: its front faces under their common outline (the cycle of its edges with one front
 * face). The outline does in one go for all faces what tests 2 to 4 ask about sides. A solid whose front has many
 * faces is entered face by face instead, each a front of its own, or as a bundle (see bundle.h).
 *
 * Solids are taken nearest first, and a solid whose box lies behind the covers of those before it is culled: it is
 * neither mapped nor cut, and as it hides nothing that the covers do not hide, it is no front either. */
#ifndef ROBERTS_HIDE_FRONTS_H
#define ROBERTS_HIDE_FRONTS_H

#include "base/bits.h"
#include "hide/bundle.h"
#include "hide/cover.h"
#include "hide/tests_wide.h"
#include "hide/tolerance.h"

/* What a front is. The first two have an outline of their own. */
typedef enum hide_kind {
    HIDE_CONVEX_SOLID, /* all front faces of a convex solid, asked together */
    HIDE_BUNDLE,       /* all front faces of a convex solid, asked by a tree: bundle.h */
    HIDE_SOLID_FACE,   /* one face of a convex solid that is entered face by face; the solid hides the hull of what its
                          faces hide */
    HIDE_SURFACE_FACE, /* one face of a body that is not convex; it hides from both sides */
} hide_kind;

typedef struct hide_front {
    double reach; /* of a convex solid: distance from it up to which the planes of its faces can be trusted */
    uint32_t solid;
    uint32_t face; /* of hide_fronts.face, the first */
    uint32_t own;  /* its seen_face_key(): it does not hide lines that list this key */
    union {
        uint32_t outline; /* of hide_fronts.outline, the first corner: convex solid and bundle */
        uint32_t piece;   /* the face of the scene: a single face */
    };
    uint32_t corners; /* of the outline; 0: a face has corners of its own */
    float loose;      /* by how much its faces may leave its outline: by what they depart from their planes */
    float depth;      /* what is nowhere nearer is behind it wherever it is inside the outline */
    uint32_t face_count;
    uint8_t kind; /* hide_kind */
    bool listed;  /* false: a copy of another front */
} hide_front;

typedef struct hide_fronts {
    seen *seen;
    const roberts_scene *scene; /* seen->scene */
    const roberts_vec3 *P;      /* seen->P */
    hide_space space;
    hide_box *box;         /* [solid_count], until they are dropped */
    unsigned char *culled; /* [solid_count] also of one that the near plane has left nothing of */
    hide_face *face;       /* front faces; each front's lie together, but there is room between some */
    hide_front *front;     /* [front_count] */
    hide_box *front_box;   /* [front_count] */
    uint32_t front_count;
    double thickest;   /* what is farther than this above a front's box does not touch it; INFINITY: not known */
    uint32_t *outline; /* compact vertex numbers, likewise */
    bundle_table bundles;
    runs_table face_runs, outline_runs; /* of faces and of outlines of very many corners */
    cover cover;
    uint32_t most_corners;            /* of a face or an outline */
    size_t face_count, back, edge_on; /* of solids not culled */
    size_t culled_count;              /* solids that are hidden; the near plane's are not among them */
    roberts_vec2 low, high;           /* box of the picture, view units */
} hide_fronts;

/* Maps what is seen and makes its fronts. Of the options the number of threads counts, and whether hidden lines are
 * kept: if not, solids that are wholly hidden are left out. False: no memory, and `fronts` is empty. */
bool hide_fronts_build(hide_fronts *fronts, seen *s, const roberts_hide_options *options);

/* The same. looked_up: who is seen at a point will be asked, also where hidden lines are not kept. */
bool hide_fronts_build_for_looks(hide_fronts *fronts, seen *s, const roberts_hide_options *options, bool looked_up);
void hide_fronts_free(hide_fronts *fronts);

/* Releases the boxes of solids: edges ask those of fronts only. */
void hide_fronts_drop_boxes(hide_fronts *fronts);

/* Asks for what will soon be asked or written of a solid: it lies anywhere. (Inlined: see base/bits.h.) */
BITS_INLINE void hide_fronts_fetch(const hide_fronts *fronts, uint32_t solid)
{
    const roberts_scene *scene = fronts->scene;
    const scene_solid *s = &scene->solid[solid];
    size_t vertices = s[1].vertex - s->vertex, faces = s[1].face - s->face;
    FETCH_ARRAY(fronts->P + s->vertex, vertices * sizeof *fronts->P);
    FETCH_ARRAY(scene->face_plane + s->face, faces * sizeof *scene->face_plane);
    FETCH_AHEAD(fronts->seen->facing + s->face);
    FETCH_AHEAD(scene->edge + s->stored);
}

/* Is it a single face, with corners of its own? */
static inline bool hide_is_face(const hide_front *front)
{
    return front->kind >= HIDE_SOLID_FACE;
}

/* The outline of a front as a polygon for tests 2 to 4; its plane is not set, or that of its only face. */
static inline hide_face hide_outline(const hide_fronts *fronts, const hide_front *front)
{
    if (hide_is_face(front))
        return fronts->face[front->face];
    return (hide_face){.corner = fronts->outline + front->outline, .count = front->corners};
}

/* Is X inside a convex polygon of the picture, a face or an outline as `table` says, or no farther outside than
 * `slack`? */
static inline bool hide_polygon_holds(const hide_fronts *fronts, const runs_table *table, const uint32_t *corner,
                                      uint32_t count, roberts_vec2 X, double slack)
{
    const runs *r = runs_of(table, corner, count);
    if (r)
        return runs_hold_point(&fronts->space, r, corner, X.x, X.y, slack);
    for (uint32_t i = 0; i < count; i++)
        if (!hide_side_holds(fronts->P[corner[i]], fronts->P[corner[i + 1 < count ? i + 1 : 0]], X.x, X.y, slack))
            return false;
    return true;
}

#endif
