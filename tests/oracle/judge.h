/* judge.h - runs the program's library and the oracle on one scene and compares every edge. */
#ifndef ROBERTS_TESTS_JUDGE_H
#define ROBERTS_TESTS_JUDGE_H

#include <stdio.h>

#include "families.h"

/* An edge fails if program and oracle differ on more than this fraction of it; in rough scenes, if they also differ on
 * more than four times the slack. */
#define JUDGE_LIMIT 1e-9

typedef struct judge_total {
    size_t scenes, edges, drawn, cut; /* compared; not all behind their own solid; cut by a border at least once */
    size_t clipped;                   /* reach the near plane */
    size_t disagreements;             /* edges, or whole scenes that the program refused */
    double unjudged;                  /* length in t that was not judged because of slack; a whole edge counts 1 */
    size_t slivers; /* edges that differ by more than JUDGE_LIMIT, but by less than the uncertainty of their ends */
    double worst;   /* greatest difference on an edge that did not fail */
    size_t pairs, exact;   /* pairs of edge and solid clipped by the oracle; of these, with rational numbers */
    size_t seen;           /* hidden segments whose `by` was compared */
    size_t reordered;      /* scenes drawn again in another order */
    size_t reordered_open; /* of these, with other lines where contact is undetermined */
} judge_total;

/* Compares all edges of a scene and adds to `total`. `name` ("crowd-17") is used for file names. For each of the first
 * few failing edges, reports to `out`: both lists of intervals; the smallest part of the scene that still fails,
 * written to FOLDER/failures/; and the command that draws it. Returns whether everything agreed. */
bool judge_scene(const char *name, const test_scene *scene, const char *folder, judge_total *total, FILE *out);

/* Returns the library's camera for the scene's viewer. */
roberts_camera judge_camera(const test_scene *scene);

/* Writes a mesh as OFF with a comment, every coordinate with 17 digits; false: errno. */
bool judge_write_off(const char *path, const roberts_mesh *mesh, const char *comment);

enum { JUDGE_PATH = 700 };

/* Writes a mesh as FOLDER/failures/NAME.off, whose name is returned in `path`; false: errno. */
bool judge_write_failure(const char *folder, const char *name, const roberts_mesh *mesh, const char *comment,
                         char path[JUDGE_PATH]);

/* Prints a line of intervals after a title. */
void judge_print_intervals(FILE *out, const char *title, const oracle_interval *list, size_t count);

/* Returns the length in t of a \ b; both lists ascend. */
double judge_outside(const oracle_interval *a, size_t a_count, const oracle_interval *b, size_t b_count);

#endif
