/* planar_map.h - segments of the picture as a planar map: nodes, and straight lines between them that meet in nodes
 * only.
 *
 * Ends within the touching distance of one another become one node: that of the smallest number, which keeps its
 * coordinates. A node within that distance of a line divides the line. Where lines cross, both are divided at a new
 * node. Lines between the same two nodes are one. Divided lines bend a little, which may cause new crossings; so all
 * this is repeated until nothing changes. Exact signs decide whether lines cross. So the result is planar, however
 * coordinates are rounded. */
#ifndef ROBERTS_HIDE_PLANAR_MAP_H
#define ROBERTS_HIDE_PLANAR_MAP_H

#include "base/vec.h"

typedef struct planar_map {
    roberts_vec2 *node;  /* [node_count] some may be on no line */
    uint32_t (*line)[2]; /* [line_count] by their nodes, the smaller node first; each once */
    size_t node_count, line_count, node_room, line_room;
    uint32_t *slot; /* [slot_count] hash table by place: the number of the node, plus 1; 0: free. NULL after division */
    size_t slot_count;
} planar_map;

/* Adds a segment, unless it has no length. Ends at exactly the same place are one node. False: no
 * memory; then, and after planar_map_divide(), nothing can be added. */
bool planar_map_add(planar_map *m, roberts_vec2 a, roberts_vec2 b);

/* Makes the map planar. False: no memory. */
bool planar_map_divide(planar_map *m, double touching);

/* Joins each end that no other line has to what is within `reach`, so that lines that should meet do if the model is
 * rounded. Does nothing unless `reach` exceeds `touching`. The map is planar, and remains so. False: no memory. */
bool planar_map_join_loose(planar_map *m, double touching, double reach);

void planar_map_free(planar_map *m);

/* ---- cells: what the lines part the picture into ---------------------------------------------------------------
 *
 * Each line is two half-edges: 2 i runs from line[i][0] to line[i][1], and 2 i + 1 runs back. The cell of a half-edge
 * is the one on its left. A cell has one cycle round it, counter-clockwise, and one for each group of lines that lies
 * in it, clockwise. Cell 0 is what is outside of all. */

typedef struct map_cells {
    uint32_t *next;  /* [2 lines] the half-edge that follows on the same cycle: the next one clockwise about its node */
    uint32_t *cycle; /* [2 lines] of each half-edge */
    uint32_t *first; /* [cycle_count] a half-edge of each cycle */
    double *area;    /* [cycle_count] > 0: it runs counter-clockwise */
    uint32_t *cell;  /* [cycle_count] */
    size_t cycle_count, cell_count;
} map_cells;

/* Finds the cells. Dead ends are removed from the map first. False: no memory; call map_cells_free() in any case. */
bool map_cells_find(map_cells *c, planar_map *m);
void map_cells_free(map_cells *c);

static inline uint32_t map_from(const planar_map *m, uint32_t half)
{
    return m->line[half >> 1][half & 1];
}

static inline uint32_t map_cell_of(const map_cells *c, uint32_t half)
{
    return c->cell[c->cycle[half]];
}

/* The half-edge that follows once the lines in `gone`, [lines], are removed. */
static inline uint32_t map_next(const map_cells *c, uint32_t half, const uint8_t *gone)
{
    uint32_t next = c->next[half];
    while (gone[next >> 1])
        next = c->next[next ^ 1];
    return next;
}

/* The area within a ring of half-edges, > 0 if it runs counter-clockwise; the sign is right. */
double map_area(const planar_map *m, const uint32_t *half, size_t count);

#endif
