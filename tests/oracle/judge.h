/* judge.h - runs the program's library and the oracle on one scene and compares every edge. */
#ifndef ROBERTS_TESTS_JUDGE_H
#define ROBERTS_TESTS_JUDGE_H

#include <stdio.h>

#include "families.h"

/* An edge fails where program and oracle differ on more than this part of it; in rough scenes, where they differ on
 * more than four times the slack besides. */
#define JUDGE_LIMIT 1e-9

typedef struct judge_total {
    size_t scenes, edges, drawn, cut; /* compared; not wholly behind their own solid; cut by a border at least once */
    size_t clipped;                   /* reach the near plane */
    size_t disagreements;             /* edges, or whole scenes that the program refused */
    double unjudged;                  /* length of t that was not judged, because of slack; whole edges count 1 */
    size_t slivers;        /* edges that differ by more than JUDGE_LIMIT, but by less than their ends are open by */
    double worst;          /* greatest difference on an edge that did not fail */
    size_t pairs, exact;   /* of edge and solid, clipped by the oracle; thereof with rational numbers */
    size_t seen;           /* hidden segments whose `by` was compared */
    size_t reordered;      /* scenes drawn once more in another order */
    size_t reordered_open; /* thereof with other lines where contact is open */
} judge_total;

/* Compares all edges of a scene and adds to `total`. `name` ("crowd-17") names files. For each of the first few edges
 * that fail, a report goes to `out`: both lists of intervals, the smallest part of the scene that still fails, written
 * to FOLDER/failures/, and the command that draws it. Returns whether everything agreed. */
bool judge_scene(const char *name, const test_scene *scene, const char *folder, judge_total *total, FILE *out);

/* The camera of the library for the scene's viewer. */
roberts_camera judge_camera(const test_scene *scene);

/* Writes a mesh as OFF, every coordinate with 17 digits, after a comment; false: errno. */
bool judge_write_off(const char *path, const roberts_mesh *mesh, const char *comment);

/* Length of t of a \ b; lists ascend. */
double judge_outside(const oracle_interval *a, size_t a_count, const oracle_interval *b, size_t b_count);

#endif
