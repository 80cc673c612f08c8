/* pair.h - what the front of one solid hides of one edge of another: one interval.
 *
 * The volume behind a convex solid is { X : X inside the outline, F(X) > 0 for every front face F }. So for the front as
 * a whole the four tests read:
 *
 *   1. Some face has A and B in front of it or on it: visible.
 *   2. The outline lies on one side of the sight plane through AB: visible.
 *   3. and 4. as for one face, with the outline's sides in place of a face's; the part found is cut where AB pierces the
 *      plane of any of the faces, if A and B are not both behind all of them.
 *
 * Planes are asked far from their faces here. An edge out of the reach of what they can be trusted (see set_trust() in
 * picture.c: beyond a thousand widths of a face, or at once for models given to few digits) meets the faces one by one,
 * tests 1 to 4 each, and the hull of what they hide is the front's part. So does it a front of one face. */
#ifndef ROBERTS_HIDE_PAIR_H
#define ROBERTS_HIDE_PAIR_H

#include "hide/picture.h"
#include "hide/tests.h"

/* How edges are held against a front. */
typedef enum hide_approach {
    HIDE_ONE_FACE,     /* it is one face of a solid of many */
    HIDE_WITHIN_REACH, /* all faces at once: the edges are within the reach of all planes */
    HIDE_ASK_REACH,    /* ... where that turns out to be so, else face by face */
} hide_approach;

/* That for edges within `box`. */
hide_approach hide_approach_front(const hide_picture *picture, const hide_front *front, const hide_box *box);

/* False where the front hides nothing of e. sides: room for the picture's most_corners. */
bool hide_by_front(const hide_picture *picture, const hide_front *front, hide_approach approach, const hide_edge *e,
                   hide_sides *sides, roberts_tally *tally, hide_part *part);

#endif
