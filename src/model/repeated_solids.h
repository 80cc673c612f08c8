/* repeated_solids.h - solids whose faces are the same but for where their numbers begin.
 *
 * Most files repeat a few solids. Of two with the same pattern, corner by corner counted from the first vertex, the edges are
 * the same too, so that those of the first serve all; only which way round the solid is wound makes a difference. */
#ifndef ROBERTS_MODEL_REPEATED_SOLIDS_H
#define ROBERTS_MODEL_REPEATED_SOLIDS_H

#include <stdbool.h>

#include "model/edges.h"
#include "model/scene.h"

enum { REPEATED_RECENT = 4 }; /* so many are compared with: files that take turns among more are rare */

typedef struct repeated_solid {
    uint32_t solid;   /* the first that has it */
    uint32_t members; /* how many have it */
    uint32_t stored;  /* where scene->edge has its edges; ROBERTS_NONE: each solid has its own */
} repeated_solid;

/* Zeroed = empty. */
typedef struct repeated_solids {
    repeated_solid *item; /* [count] */
    uint32_t *of;         /* [solids joined] the pattern of each */
    size_t room, of_room;
    uint32_t count, recent_count;
    uint32_t recent[REPEATED_RECENT]; /* the last ones met, the last first */
} repeated_solids;

/* The recent pattern that solid s has, whose faces begin at solid[s].face and its vertices at solid[s].vertex; ROBERTS_NONE:
 * none of them fits. Corners are in the order of the input, in faces up to face_count. */
uint32_t repeated_match(repeated_solids *list, const scene_solid *solid, uint32_t s, const uint32_t *start,
                        const uint32_t *corner, uint32_t face_count);

/* Gives solid s that pattern (ROBERTS_NONE: one of its own), after all solids before it. False: no memory. */
bool repeated_join(repeated_solids *list, uint32_t s, uint32_t number);

/* Does so for all solids of a scene that is laid out. False: no memory. */
bool repeated_find(repeated_solids *list, roberts_scene *scene);

/* Numbers the edges of all solids, makes room for them, and stores those of the patterns. False: no memory. */
bool repeated_number_edges(repeated_solids *list, roberts_scene *scene, edge_scratch *scratch);

void repeated_free(repeated_solids *list);

#endif
