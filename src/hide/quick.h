/* quick.h - tests 2 to 4 at a stroke, for an edge and an outline between which all signs are plain.
 *
 * A sign is plain where its cross product is larger than hide_space.plain: then it is the one that tests.c would find,
 * without looking at lengths and errors. The sides' functions H_i(A), H_i(B) are computed two at a time, in the form
 * that test 4 needs for t_i, so that the part found is the same to the last bit. Where one sign is not plain, or one
 * crossing not accurate, the verdict is left to tests.c. */
#ifndef ROBERTS_HIDE_QUICK_H
#define ROBERTS_HIDE_QUICK_H

#include "hide/space.h"

/* Corners of the outlines that are taken up; those of more are left to tests.c. Even. */
#define QUICK_CORNERS 16

/* An outline at hand, drawn together from the picture. An odd number of sides is made even: the last stands twice. */
typedef struct quick_outline {
    const uint32_t *corner; /* whose; NULL: nobody's */
    uint32_t count;
    double x[QUICK_CORNERS + 2], y[QUICK_CORNERS + 2]; /* corners, the first once more at the end */
    double ox[QUICK_CORNERS], oy[QUICK_CORNERS];       /* of side i the end of smaller number */
    double dx[QUICK_CORNERS], dy[QUICK_CORNERS];       /* ... and from its first corner to the next */
} quick_outline;

typedef enum quick_verdict {
    QUICK_UNCLEAR, /* ask tests 2 to 4 themselves */
    QUICK_MISSED,  /* test 2: the sight plane through AB misses the outline */
    QUICK_OUTSIDE, /* test 3: outside one side */
    QUICK_INSIDE,  /* test 3: inside all sides */
    QUICK_CUT,     /* test 4: a part is inside */
    QUICK_EMPTY,   /* test 4: none is */
} quick_verdict;

/* Takes up the outline P[corner[0]], P[corner[1]], ... of at most QUICK_CORNERS corners. */
void quick_take(quick_outline *o, const roberts_vec3 *P, const uint32_t *corner, uint32_t count);

/* Fills `part` where the verdict is QUICK_INSIDE or QUICK_CUT. */
quick_verdict quick_test(const quick_outline *o, const hide_space *space, const hide_edge *e, hide_part *part);

#endif
