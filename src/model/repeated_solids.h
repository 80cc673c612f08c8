/* repeated_solids.h - solids that repeat one another: their faces are the same, except for where their numbers begin.
 *
 * Most files repeat a few solids. Two solids have the same *pattern* if their corners are the same numbers, counted
 * from the solid's first vertex. Then their edges are the same too, and are found and stored once for all of them.
 * Since only the winding may differ, they are stored for both windings. */
#ifndef ROBERTS_MODEL_REPEATED_SOLIDS_H
#define ROBERTS_MODEL_REPEATED_SOLIDS_H

#include <stdbool.h>

#include "model/scene.h"
#include "model/solid.h"

enum { REPEATED_RECENT = 4 }; /* how many patterns a solid is compared with; few files alternate among more */

/* A pattern. */
typedef struct repeated_solid {
    uint32_t solid;   /* the first solid that has it */
    uint32_t members; /* number of solids that have it */
    uint32_t stored;  /* index of its edges in scene->edge; ROBERTS_NONE: each solid has its own */
} repeated_solid;

/* All patterns; zeroed = empty. */
typedef struct repeated_solids {
    repeated_solid *item; /* [count] */
    uint32_t *of;         /* [solids joined] the pattern of each */
    size_t room, of_room;
    uint32_t count, recent_count;
    uint32_t recent[REPEATED_RECENT]; /* [recent_count] the last patterns found, most recent first */
} repeated_solids;

/* Finds the pattern of each solid of a scene that is laid out. False: no memory. */
bool repeated_find(repeated_solids *list, roberts_scene *scene);

/* Numbers the edges of all solids, allocates scene->edge, and stores the edges of each pattern shared by several
 * solids. False: no memory. */
bool repeated_number_edges(repeated_solids *list, roberts_scene *scene, edge_scratch *scratch);

void repeated_free(repeated_solids *list);

/* ---- components that follow one another in the file ------------------------------------------------------------ */

/* Finds components that follow one another in the file: they use every vertex, their vertices and faces have no gaps,
 * each is like a sphere, and no corner repeats another of its face. If so, fills in scene->solid, the counts and the
 * patterns, and sets *found. Otherwise changes nothing. False: no memory. */
bool components_in_a_row(roberts_scene *scene, const polygons *faces, repeated_solids *list, bool *found);

#endif
