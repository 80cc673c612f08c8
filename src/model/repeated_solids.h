/* repeated_solids.h - solids that repeat one another: their faces are the same, but for where their numbers begin.
 *
 * Most files repeat a few solids. Two solids have the same *pattern* if their corners are the same numbers, counted
 * from the solid's first vertex. Then their edges are the same too, and are found and stored once for all of them. Only
 * the winding makes a difference, so they are stored both ways round. */
#ifndef ROBERTS_MODEL_REPEATED_SOLIDS_H
#define ROBERTS_MODEL_REPEATED_SOLIDS_H

#include <stdbool.h>

#include "model/edges.h"
#include "model/scene_arrays.h"

enum { REPEATED_RECENT = 4 }; /* how many patterns a solid is compared with; few files take turns among more */

/* A pattern. */
typedef struct repeated_solid {
    uint32_t solid;   /* the first that has it */
    uint32_t members; /* how many have it */
    uint32_t stored;  /* where scene->edge has its edges; ROBERTS_NONE: each solid has its own */
} repeated_solid;

/* All patterns; zeroed = empty. */
typedef struct repeated_solids {
    repeated_solid *item; /* [count] */
    uint32_t *of;         /* [solids joined] the pattern of each */
    size_t room, of_room;
    uint32_t count, recent_count;
    uint32_t recent[REPEATED_RECENT]; /* [recent_count] the patterns met last, the latest first */
} repeated_solids;

/* Finds the pattern of each solid of a scene that is laid out. False: no memory. */
bool repeated_find(repeated_solids *list, roberts_scene *scene);

/* Numbers the edges of all solids, allocates scene->edge, and stores the edges of each pattern that several solids
 * have. False: no memory. */
bool repeated_number_edges(repeated_solids *list, roberts_scene *scene, edge_scratch *scratch);

void repeated_free(repeated_solids *list);

/* ---- components that follow one another in the file ------------------------------------------------------------ */

/* Finds components where they follow one another in the file: they use every vertex, their vertices and faces come
 * without a gap, each is like a sphere, and no corner repeats another of its face. Then it fills in scene->solid, the
 * counts and the patterns, and sets *found. Otherwise it changes nothing. False: no memory. */
bool components_in_a_row(roberts_scene *scene, const polygons *faces, repeated_solids *list, bool *found);

#endif
