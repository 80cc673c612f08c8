/* tiles.h - the solids in groups that threads take at the same time, and where in the picture's arrays each group's fronts go.
 *
 * Where covers are kept a tile holds the solids whose middle is in a square of TILE_CELLS cells: what they touch of the
 * covers stays in a cache. Tiles are taken in rounds. No two tiles of a round lie beside one another, and no solid reaches
 * farther out of its tile than nearly half of one: so what solids of different tiles of a round ask and enter of the
 * covers is never the same, and what is culled does not depend on the threads. The few solids that reach farther are a tile
 * by themselves, and a round, the first. Without covers tiles are solids that follow one another, in one round.
 *
 * A solid has at most one front that stands for all of it, no more front faces than faces and no more corners in its
 * outline than vertices: a tile begins where those before it must end. Room that is not used is never touched. */
#ifndef ROBERTS_HIDE_TILES_H
#define ROBERTS_HIDE_TILES_H

#include "base/threads.h"
#include "hide/picture.h"

/* The first round's one tile is for solids that reach far; then four rounds, by odd and even columns and rows of tiles. */
enum { TILE_ROUNDS = 5 };

typedef struct picture_tile {
    uint32_t first, end;           /* of tiles.solid */
    uint32_t front, face, outline; /* of the picture's arrays: the next to be written */
    hide_front *single;            /* fronts of one face each, of solids that are entered face by face */
    hide_box *single_box;
    size_t single_count, single_room, single_box_room;
    size_t faces, back, edge_on, culled;
    uint32_t most_corners;
    char apart[THREADS_APART];
} picture_tile;

typedef struct tiles {
    picture_tile *tile;
    uint32_t count, round[TILE_ROUNDS + 1]; /* first tile of each round, and the last one's end */
    uint32_t *solid;                        /* tile by tile; NULL: as they are numbered */
} tiles;

/* The picture has its boxes and the covers' frame. By so many threads. False: no memory; tiles_free() is due in any case. */
bool tiles_make(tiles *t, const hide_picture *picture, int threads);
void tiles_free(tiles *t);

/* Orders a tile's solids, nearest first, ties by number. False: no memory. */
bool tiles_order(tiles *t, const picture_tile *of, const hide_picture *picture);

#endif
