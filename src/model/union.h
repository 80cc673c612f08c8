/* union.h - where the lines of all bodies remain when the bodies are taken together as one (`--union`).
 *
 * The union is not built. Around a point of a line, in the plane across it, every closed body at that point fills an
 * angle: the wedge of an edge, the half-plane of a face, or everything if the point is inside the body. The line is
 * drawn there unless the bodies together fill nothing (but see below), everything, or exactly a half-plane. Events are
 * places where the line enters, leaves or passes a face. Between two events, the answer does not change.
 *
 *       |##########       the foot of a leg on a slab: a quarter and a half-plane fill three quarters;
 *       |##########       the line is drawn, and its sides are the leg's side and the slab's top
 *    ---+----------
 *    ##############
 *
 * All decisions are made in model space, within a touching distance: that of the view plus the departures of both
 * bodies' faces from their planes. A line lies in a face if its whole part over the face is within this distance of the
 * face's plane. Two faces that meet at the line leave it in one direction if the smaller stays within this distance of
 * the other. So doubles suffice: their errors are far below the distance.
 *
 * Faces of a closed body that lie on one another may enclose nothing, but they hide what is behind them. They count as
 * sides of the region.
 *
 * Where the near plane has cut the scene, an edge of a face in this plane is judged by what the bodies fill beyond it.
 *
 * Open bodies fill nothing, and their edges are not tested. But a line in which a sheet, a face of an open body, meets
 * a closed one is judged by what the closed bodies fill there. There is a line if the filled region has sides on both
 * sides of the sheet, whichever bodies they belong to, and no edge is drawn in this place. So in the plane of a seam, a
 * sheet meets flush bodies as it would meet one wall. */
#ifndef ROBERTS_MODEL_UNION_H
#define ROBERTS_MODEL_UNION_H

#include "base/search.h"
#include "model/scene.h"

/* What becomes of a piece of a line. */
typedef enum union_state {
    UNION_ALONE,  /* no other body matters: the line is the same as without the union. Also if its body only touches or
                     crosses itself */
    UNION_DRAWN,  /* drawn; its class is determined by its sides */
    UNION_SEAM,   /* not drawn: the bodies fill exactly a half-plane, or their faces cover one another */
    UNION_INSIDE, /* not drawn: it lies inside a body */
    UNION_TWICE,  /* not drawn: another line in the same place is drawn, see below */
    UNION_MET,    /* drawn: a sheet meets a seam, or one of the faces that bound the filled region */
} union_state;

/* Of several lines in one place, one is drawn. Of edges, it is that of the body with the smallest number. A line where
 * two faces cross is drawn if there is no edge, and if both faces, or the faces chosen for their planes, bound the
 * filled region. */

/* A face that bounds the region filled by the bodies together. */
typedef struct union_side {
    uint32_t face; /* compact number */
    bool turned; /* the face is on the right of the line, seen from where its plane has F < 0; otherwise on the left */
    uint32_t body;  /* the face's body */
    roberts_vec3 d; /* unit vector in which the face leaves the line */
    double reach;   /* how far the face extends, scene units */
} union_side;

typedef struct union_piece {
    double t0, t1;
    union_state state;
    uint32_t first, count; /* UNION_DRAWN: its sides in union_work.side, sorted by angle */
} union_piece;

/* A line in space. */
typedef struct union_line {
    roberts_vec3 A, B;   /* as scene->point */
    uint32_t body;       /* the edge's body; ROBERTS_NONE: two faces cross in the line */
    uint32_t crossed[2]; /* the bodies of the two faces that cross; the closed one twice if the other is a sheet */
    roberts_vec3 sheet;  /* unit normal of the sheet; 0: it is none */
    uint32_t number;     /* with a sheet: scene_face_number() of the closed body's face */
    const uint32_t *own; /* [own_count] the faces that meet in the line, compact numbers, possibly with MANY_TURNED */
    uint32_t own_count;
} union_line;

/* The closed bodies of a scene. Lengths are in scene units, positions relative to the scene's centre. Once prepared, it
 * is only read, so several threads may use it. */
typedef struct union_bodies {
    const roberts_scene *scene;
    double touch;      /* touching distance */
    double diameter;   /* of the scene */
    double *departure; /* [solid_count] the greatest departure of a face from its plane */
    box3 *box;         /* [solid_count] of closed bodies, widened by the touching distance */
    uint32_t *root;    /* [solid_count] root of the tree over each body's faces; ROBERTS_NONE: it has few faces */
    uint32_t bodies;   /* root of the tree over the closed bodies; ROBERTS_NONE: there are none */
    box_tree tree;
    int32_t *winding; /* [face_count] see winding_find() */
    bool *cut;        /* [solid_count] has the near plane cut the body? NULL: there is none */
    plane near;       /* it */
} union_bodies;

typedef struct union_contact union_contact;
typedef struct union_ray union_ray;
typedef struct union_fill union_fill;

/* Scratch memory of one thread, and the result. Zeroed at first. */
typedef struct union_work {
    union_piece *piece;
    union_side *side;
    size_t piece_count, piece_room, side_count, side_room;
    /* private */
    union_contact *contacts; /* of the whole line; `contact`: at the current piece */
    union_fill *fills;       /* the same of bodies */
    size_t contacts_count, contacts_room, fills_count, fills_room;
    union_contact *contact;
    union_ray *ray;
    union_fill *fill;
    double *event;
    size_t contact_count, contact_room, ray_count, ray_room, fill_count, fill_room, event_count, event_room;
} union_work;

/* Prepares the closed bodies of a scene. left: the scene, or what the near plane leaves of it; a body without vertices
 * there fills nothing. touch: the touching distance, model units. False: no memory. */
bool union_prepare(union_bodies *all, const roberts_scene *scene, const roberts_scene *left, double touch);

/* Tells of a near plane that has cut the scene; its distances are model units, its positions relative to the scene's
 * centre. False: no memory. */
bool union_set_near(union_bodies *all, plane near);

/* Cuts a line of a closed body into work->piece. The pieces cover 0 to 1 without gaps, and adjacent pieces differ.
 * False: no memory. */
bool union_cut(const union_bodies *all, const union_line *line, union_work *work);

/* Returns an edge of closed body s as a line. `own` has room for two faces. */
union_line union_line_of_edge(const roberts_scene *scene, uint32_t s, uint32_t e, uint32_t own[2]);

void union_free(union_bodies *all);
void union_work_free(union_work *work);

/* Is the body closed, and so part of the union? */
static inline bool union_takes(const roberts_scene *scene, uint32_t s)
{
    return scene->solid[s + 1].face > scene->solid[s].face &&
           (!scene->surface || scene->surface->kind[s] != ROBERTS_OPEN);
}

#endif
