/* rows.h - the file of a part: the lines of its bodies that have segments, and these segments.
 *
 *   rows_head   what belongs to the whole, and which part this is
 *   names       of the inputs, each with its NUL, and zero bytes up to a multiple of 8
 *   lines       rows_line, each followed by its segments: rows_segment. First the edges, by body; then the
 *               intersections, by their faces
 *   rows_end    how many there are, and a hash of the lines and segments
 *
 * All numbers are those of the whole scene. Numbers are stored as the machine has them, so no digit is lost. */
#ifndef ROBERTS_PART_ROWS_H
#define ROBERTS_PART_ROWS_H

#include "part/plan.h"

#define ROWS_MAGIC "roberts part 1\n"

typedef struct rows_head {
    char magic[16];
    plan_facts facts;
    uint32_t number, of; /* part `number` of `of`, from 1 */
    uint64_t names;      /* bytes */
} rows_head;

typedef struct rows_line {
    uint32_t solid, v0, v1, segments; /* v0, v1: ROBERTS_NONE for an intersection */
    roberts_known_edge known;
} rows_line;

typedef struct rows_segment {
    double t0, t1, z0, z1;
    roberts_vec2 p0, p1;
    uint32_t by;
    uint8_t state, line;
    uint16_t level;
} rows_segment;

typedef struct rows_end {
    char magic[16];
    uint64_t lines, crossings, segments; /* crossings: how many of the lines */
    uint64_t hash;
} rows_end;

#endif
