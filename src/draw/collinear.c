/* collinear.c - pieces are sorted to the lines that they lie on, by a hash of direction and distance from the origin.
 *
 * The cells of the hash are wider than the distance at which pieces coincide. So a piece is compared within its own
 * cell, and with a neighbour only if it lies near the border. In drawings of millions of pieces a cell holds many
 * lines. The distance and direction stored with each line exclude nearly all that do not coincide, without reading its
 * longest piece.
 *
 * A direction is measured on the upper half of the diamond |x| + |y| = 1, from 0 to 2. It grows at least half as fast
 * as the angle. Directions are turned first, so that the wrap from 2 to 0, where a line's sign changes, is at an angle
 * that is rare in drawings. */
#include "draw/collinear.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/vec.h"

/* Coincident pieces differ by this many radians at most: 0.001 mm on 30 mm, enough for models whose coordinates have
 * five digits. It holds for shorter pieces too, so that fine facets keep their bends. */
static const double same_direction = 3e-5;

enum { DIRECTIONS = 25000 }; /* cells from 0 to 2, each 2.7 times as wide as same_direction */

static const double direction_cell = 2.0 / DIRECTIONS;

/* In large drawings nearly every step waits for memory. So pieces are taken in groups, and each step on a group
 * prefetches the memory that the next step needs. Groups of 16 are as fast as groups of 64. */
enum { AT_A_TIME = 16 };

enum { BITS_MOST = 31 }; /* of the hash */

#define NO_LINE UINT32_MAX

/* Where a piece lies among all lines. */
typedef struct bearing {
    double direction; /* 0 .. 2 */
    double distance;  /* of the line from the origin, with a sign */
} bearing;

typedef struct sorter {
    const pieces *p;
    page_lines *lines;
    roberts_vec2 origin;  /* the middle of all pieces */
    double half;          /* half of the diagonal round them */
    double reach;         /* greatest difference of the distances of coincident lines */
    uint32_t *head, bits; /* of the hash, 2^bits cells: the first line of each, or NO_LINE */
    uint32_t *line_of;    /* [pieces] */
} sorter;

static bearing bearing_of(const sorter *s, const piece *p)
{
    const double cosine = 0.8253356149096783, sine = 0.5646424733950354; /* of 0.6 radians */
    double x = p->b.x - p->a.x, y = p->b.y - p->a.y, length = piece_length(p);
    double u = cosine * x - sine * y, v = sine * x + cosine * y;
    double sign = v < 0.0 || (v == 0.0 && u < 0.0) ? -1.0 : 1.0;
    double along = sign * u / (fabs(u) + fabs(v)); /* 1 .. -1 as the angle goes from 0 to 180 degrees */
    double cross = x * (s->origin.y - p->a.y) - y * (s->origin.x - p->a.x);
    return (bearing){1.0 - along, sign * cross / length};
}

/* Whether both ends of the shorter piece lie on the line of the longer one, and both pieces have one direction, or
 * opposite ones. */
static bool coincide(const piece *p, const piece *q)
{
    double lp = piece_length(p), lq = piece_length(q);
    if (lp < lq) {
        const piece *swap = p;
        double l = lp;
        p = q, q = swap;
        lp = lq, lq = l;
    }
    double x = (p->b.x - p->a.x) / lp, y = (p->b.y - p->a.y) / lp;
    double da = x * (q->a.y - p->a.y) - y * (q->a.x - p->a.x), db = x * (q->b.y - p->a.y) - y * (q->b.x - p->a.x);
    return fabs(da) <= PIECE_TOUCH && fabs(db) <= PIECE_TOUCH && fabs(da - db) <= same_direction * lq;
}

static uint32_t hash_of(int64_t direction, int64_t distance)
{
    uint64_t key = ((uint64_t)direction << 40) ^ (uint64_t)distance;
    return (uint32_t)(key * 0x9e3779b97f4a7c15u >> 32);
}

static uint32_t *bucket_of_hash(const sorter *s, uint32_t hash)
{
    return &s->head[hash >> (32 - s->bits)];
}

/* Makes the hash large enough for `lines` lines to have a cell each if they are spread evenly. */
static bool make_cells(sorter *s, size_t lines)
{
    if (s->head && (s->bits == BITS_MOST || lines >> s->bits == 0))
        return true;
    while (s->bits < BITS_MOST && lines >> s->bits)
        s->bits++;
    size_t size = ((size_t)1 << s->bits) * sizeof *s->head;
    free(s->head);
    s->head = alloc_array(size, 1);
    if (!s->head)
        return false;
    memset(s->head, 0xff, size);
    for (uint32_t l = 0; l < s->lines->count; l++) { /* in this order the newest line of a cell stays its first */
        uint32_t *cell = bucket_of_hash(s, s->lines->item[l].hash);
        s->lines->item[l].next = *cell;
        *cell = l;
    }
    return true;
}

/* False if a piece with the bearing `at` (distance without a sign) cannot coincide with the longest piece of line c.
 * If they coincide, the shorter one ends within PIECE_TOUCH of the line of the longer, and within `half` of the
 * origin. So their distances differ by at most PIECE_TOUCH plus `half` times the angle between them, and the angle is
 * at most twice the difference of the directions. */
static bool may_coincide(const sorter *s, const page_line *c, bearing at)
{
    const double rounding = 1e-3 + 1e-6 * s->half; /* units: floats of up to `half`, and of up to 2, times twice that */
    double angle =
        2.0 * fabs(at.direction - (double)c->direction); /* far too large where directions wrap, which is harmless */
    return fabs((double)c->near - at.distance) <= PIECE_TOUCH + rounding + angle * s->half;
}

/* The first line that piece p lies on, among `line` and those after it in its cell; NO_LINE if there is none. */
static uint32_t find_in_cell(const sorter *s, const piece *p, bearing at, uint32_t line)
{
    while (line != NO_LINE &&
           (fabs(s->lines->item[line].distance - at.distance) > s->reach ||
            !may_coincide(s, &s->lines->item[line], at) || !coincide(p, &s->p->item[s->lines->item[line].longest])))
        line = s->lines->item[line].next;
    return line;
}

/* The cell of a value, and the neighbour within `reach` of it; the cell twice if there is none. */
static void cells_near(double value, double width, double reach, int64_t cell[2])
{
    double cells = value / width;
    cell[0] = (int64_t)cells - (cells < (double)(int64_t)cells); /* rounded down */
    double in = value - (double)cell[0] * width;
    cell[1] = in < reach ? cell[0] - 1 : in > width - reach ? cell[0] + 1 : cell[0];
}

static double distance_cell(const sorter *s)
{
    return 2.0 * s->reach; /* narrow, so that a cell holds few of a million lines */
}

/* The cells of the hash that may hold the line of a piece. */
typedef struct search {
    uint32_t hash[4]; /* of cells; the first is its own */
    int cells;
    bearing at; /* the distance without a sign */
} search;

static search search_for(const sorter *s, const piece *p)
{
    const bearing at = bearing_of(s, p);
    search f = {.at = {at.direction, fabs(at.distance)}};
    int64_t direction[2], distance[2];
    cells_near(at.direction, direction_cell, same_direction, direction);
    int sectors = direction[1] != direction[0] ? 2 : 1;
    for (int i = 0; i < sectors; i++) {
        bool wraps = direction[i] < 0 || direction[i] >= DIRECTIONS;
        int64_t d = direction[i] < 0 ? direction[i] + DIRECTIONS : wraps ? direction[i] - DIRECTIONS : direction[i];
        cells_near(wraps ? -at.distance : at.distance, distance_cell(s), s->reach, distance);
        f.hash[f.cells++] = hash_of(d, distance[0]);
        if (distance[1] != distance[0])
            f.hash[f.cells++] = hash_of(d, distance[1]);
    }
    return f;
}

/* The first line that a piece may have to be compared with; NO_LINE if there is none. */
static uint32_t likely_line(const sorter *s, const search *f)
{
    uint32_t line = NO_LINE;
    for (int k = 0; k < f->cells && line == NO_LINE; k++) {
        line = *bucket_of_hash(s, f->hash[k]);
        while (line != NO_LINE && !may_coincide(s, &s->lines->item[line], f->at))
            line = s->lines->item[line].next;
    }
    return line;
}

static void set_longest(page_line *c, uint32_t i, bearing at)
{
    c->longest = i;
    c->near = (float)at.distance;
    c->direction = (float)at.direction;
}

/* Puts piece i on the first line found that it lies on, or on a new one. */
static void sort_to_line(sorter *s, uint32_t i, const search *f)
{
    const piece *p = &s->p->item[i];
    uint32_t line = NO_LINE;
    for (int k = 0; k < f->cells && line == NO_LINE; k++)
        line = find_in_cell(s, p, f->at, *bucket_of_hash(s, f->hash[k]));
    if (line == NO_LINE) {
        uint32_t *cell = bucket_of_hash(s, f->hash[0]);
        line = s->lines->count++;
        s->lines->item[line] = (page_line){.distance = f->at.distance, .hash = f->hash[0], .next = *cell};
        *cell = line;
        set_longest(&s->lines->item[line], i, f->at);
    } else if (piece_length(p) > piece_length(&s->p->item[s->lines->item[line].longest])) {
        set_longest(&s->lines->item[line], i, f->at);
    }
    s->lines->item[line].count++;
    s->line_of[i] = line;
}

/* Sorts the pieces first .. first + count - 1, whose cells have been prefetched. */
static void sort_some(sorter *s, const search *f, size_t first, size_t count)
{
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < f[i].cells; k++)
            if (*bucket_of_hash(s, f[i].hash[k]) != NO_LINE)
                FETCH_AHEAD(&s->lines->item[*bucket_of_hash(s, f[i].hash[k])]);
    for (size_t i = 0; i < count; i++) {
        uint32_t line = likely_line(s, &f[i]);
        if (line != NO_LINE)
            FETCH_AHEAD(&s->p->item[s->lines->item[line].longest]);
    }
    for (size_t i = 0; i < count; i++)
        sort_to_line(s, (uint32_t)(first + i), &f[i]);
}

/* False: no memory. */
static bool sort_to_lines(sorter *s)
{
    search f[AT_A_TIME];
    for (size_t first = 0, count; first < s->p->count; first += count) {
        count = s->p->count - first < AT_A_TIME ? s->p->count - first : AT_A_TIME;
        if (!make_cells(s, s->lines->count + count))
            return false;
        for (size_t i = 0; i < count; i++) {
            f[i] = search_for(s, &s->p->item[first + i]);
            for (int k = 0; k < f[i].cells; k++)
                FETCH_AHEAD(bucket_of_hash(s, f[i].hash[k]));
        }
        sort_some(s, f, first, count);
    }
    return true;
}

/* Sets the origin in the middle of the pieces, where an error in a line's direction changes its distance least. */
static void prepare_sorter(sorter *s)
{
    roberts_vec2 min = {INFINITY, INFINITY}, max = {-INFINITY, -INFINITY};
    for (size_t i = 0; i < s->p->count; i++) {
        const piece *p = &s->p->item[i];
        min = (roberts_vec2){lesser(min.x, lesser(p->a.x, p->b.x)), lesser(min.y, lesser(p->a.y, p->b.y))};
        max = (roberts_vec2){greater(max.x, greater(p->a.x, p->b.x)), greater(max.y, greater(p->a.y, p->b.y))};
    }
    s->origin = (roberts_vec2){0.5 * (min.x + max.x), 0.5 * (min.y + max.y)};
    s->half = 0.5 * hypot(max.x - min.x, max.y - min.y);
    s->reach = PIECE_TOUCH + same_direction * s->half;
}

static void list_members(const sorter *s)
{
    page_lines *lines = s->lines;
    uint32_t total = 0;
    for (uint32_t l = 0; l < lines->count; l++) {
        page_line *c = &lines->item[l];
        c->start = total;
        total += c->count > 1 ? c->count : 0;
        lines->most = c->count > lines->most ? c->count : lines->most;
    }
    for (uint32_t i = 0; i < s->p->count; i++) { /* meanwhile `start` moves on to the end of the line's pieces */
        page_line *c = &lines->item[s->line_of[i]];
        if (i + AT_A_TIME < s->p->count)
            FETCH_AHEAD(&lines->item[s->line_of[i + AT_A_TIME]]);
        if (c->count > 1)
            lines->member[c->start++] = i;
    }
    for (uint32_t l = 0; l < lines->count; l++)
        if (lines->item[l].count > 1)
            lines->item[l].start -= lines->item[l].count;
}

bool collinear_find(page_lines *c, const pieces *p)
{
    sorter s = {.p = p, .lines = c, .line_of = alloc_array(p->count, sizeof *s.line_of)};
    *c = (page_lines){.item = alloc_array(p->count, sizeof *c->item),
                      .member = alloc_array(p->count, sizeof *c->member)};
    prepare_sorter(&s);
    bool done = c->item && c->member && s.line_of && sort_to_lines(&s);
    if (done)
        list_members(&s);
    free(s.head);
    free(s.line_of);
    return done;
}

void collinear_free(page_lines *c)
{
    free(c->item);
    free(c->member);
    *c = (page_lines){0};
}
