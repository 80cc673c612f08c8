/* cover.h - the nearest cover of each cell.
 *
 * Source: the lecture's "la face la plus proche qui recouvre le pave". Here not only a face may cover a cell, but also
 * the whole front of a solid, if its outline holds the cell. Each cell keeps its nearest cover. Covers are compared by
 * their farthest depth over the cell: everything that is nowhere nearer than that lies behind the cover. The faces of
 * a body that is not convex cover cells one by one, and together: see cover_add_body().
 *
 * Covers have cells of their own, finer than those of Objet[i][j] (see cells.h), because a front does not cover the
 * cells that its outline crosses. */
#ifndef ROBERTS_HIDE_COVER_H
#define ROBERTS_HIDE_COVER_H

#include "base/threads.h"
#include "hide/cells.h"
#include "hide/types.h"

typedef struct cover {
    scan_frame frame;
    float *depth; /* [nx * ny] of the cover; -infinity: there is none. NULL: no covers are kept */
    uint32_t *by; /* [nx * ny] what covers the cell: cover_front.by */
} cover;

/* Makes the cells of a frame, none of which is covered, and takes the frame's warps. In a frame without columns no
 * covers are kept. False: no memory; call cover_free() in any case. */
bool cover_init(cover *c, scan_frame frame, int threads);
/* The same for bodies in a part of the picture, low..high. No other cells are used. */
bool cover_init_part(cover *c, scan_frame frame, roberts_vec2 low, roberts_vec2 high);
void cover_free(cover *c);

/* A front that covers cells. */
typedef struct cover_front {
    const uint32_t *corner; /* [count] of its outline, convex, counter-clockwise */
    uint32_t count;
    uint32_t by;           /* the name that its cells keep */
    const hide_face *face; /* [face_count] their planes give the depth cell by cell; none: `depth` holds everywhere */
    uint32_t face_count;
    double depth; /* the front is nowhere farther away than this */
    double slack; /* what is nearer than the front's depth by more than this does not touch the front */
    double loose; /* the front may leave gaps of this width in its outline */
} cover_front;

/* Adds a front to the covers. P: view points of the scene. s: scratch memory, with as many columns as the frame. */
void cover_add(cover *c, scan *s, const roberts_vec3 *P, const cover_front *front);

/* Do covers certainly hide the whole box? */
bool cover_hides(const cover *c, const hide_box *box);

struct hide_fronts;

/* Memory of one thread, zeroed except for the scan, which has as many columns as the frame. */
typedef struct cover_scratch {
    scan scan;
    float *depth;         /* [cells of a body's box] of the farthest face in the cell */
    unsigned char *taken; /* [faces of a body] 1: the face counts */
    size_t depth_room, taken_room;
    char apart[THREADS_APART];
} cover_scratch;

void cover_scratch_free(cover_scratch *w);

/* Adds the faces of a body that is not convex. It is mapped, and the facing of its faces is known. late: the facing of
 * faces that lie behind the others, if there is one; else VIEW_EDGE_ON.
 *
 * Faces smaller than a cell cover no cell alone. But suppose that no fold of the body meets a cell (see layers.h). Then
 * equally many faces lie over all points of the cell, so if one face touches it, faces cover it together. Faces that
 * are late do not count here, and an edge between such a face and another one is a fold. False: no memory. */
bool cover_add_body(struct hide_fronts *fronts, cover_scratch *w, uint32_t body, int late);

/* Makes covers of the faces of one such body, which are the fronts first..end-1, if they lie over one another many
 * times (hide_fronts.own). Fronts that these hide are not listed. False: no memory. */
bool cover_add_own(struct hide_fronts *fronts, uint32_t body, uint32_t first, uint32_t end);

/* Do the fronts added so far certainly hide the solid? box: that of the solid. The solid need not be mapped. */
bool cover_hides_solid(const struct hide_fronts *fronts, const hide_box *box, uint32_t solid);

/* Is there a cover at the picture point (x, y) that is certainly nearer than z? */
static inline bool cover_nearer(const cover *c, double x, double y, float z)
{
    return c->depth[scan_cell(&c->frame, x, y)] > z;
}

/* Returns the `by` of that cover; ROBERTS_NONE: there is no such cover. */
uint32_t cover_at(const cover *c, double x, double y, float z);

/* Do covers certainly hide the whole edge AB? */
bool cover_hides_edge(const cover *c, roberts_vec3 A, roberts_vec3 B);

#endif
