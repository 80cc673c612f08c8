/* overlap.c - no line is drawn twice.
 *
 * Edges of solids that touch coincide, and so do edges behind one another. Pieces are first sorted to the lines that
 * they lie on, by a hash of direction and distance from the origin. On each line the nearest pieces form the upper
 * envelope of depth over position. Halving and merging finds it in O(n log n) time, however many pieces lie on one
 * another (J. Hershberger, "Finding the upper envelope of n line segments in O(n log n) time", Information Processing
 * Letters 33(4), 1989). If two coincident pieces pass one another in depth, the middle of each stretch between ends
 * decides which is nearer. */
#include "draw/overlap.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/sort.h"
#include "base/vec.h"
#include "draw/strokes.h"

/* ---- the lines that pieces lie on -------------------------------------------------------------------------------- */

/* The cells of the hash are wider than the distance at which pieces coincide. So a piece is compared within its own
 * cell, and with a neighbour only if it lies near the border. In drawings of millions of pieces a cell holds many
 * lines. The distance and direction stored with each line exclude nearly all that do not coincide, without reading its
 * longest piece.
 *
 * A direction is measured on the upper half of the diamond |x| + |y| = 1, from 0 to 2. It grows at least half as fast
 * as the angle. Directions are turned first, so that the wrap from 2 to 0, where a line's sign changes, is at an angle
 * that is rare in drawings. */

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

/* One line with pieces on it. */
typedef struct page_line {
    double distance;       /* of its first piece from the middle of all pieces, without a sign */
    float near, direction; /* of its longest piece: distance without a sign, and direction */
    uint32_t longest;      /* piece */
    uint32_t count;        /* pieces */
    uint32_t hash;         /* of the cell that its first piece lies in */
    union {
        uint32_t next;  /* while pieces are sorted: the next line in its cell */
        uint32_t start; /* afterwards: of its pieces in `member` */
    };
} page_line;

typedef struct page_lines {
    page_line *item;
    uint32_t count;
    uint32_t most;    /* pieces on a line */
    uint32_t *member; /* the pieces of each line that has several; ascends */
} page_lines;

static inline double piece_length(const piece *p)
{
    double x = p->b.x - p->a.x, y = p->b.y - p->a.y;
    return vec2_length(x, y); /* three times as fast as hypot() */
}

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

/* Sorts pieces to lines, in the order of the pieces. A line is represented by its longest piece; a piece joins the
 * first line found that it coincides with. Call
 * collinear_free() in any case. False: no memory. */
static bool collinear_find(page_lines *c, const pieces *p)
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

static void collinear_free(page_lines *c)
{
    free(c->item);
    free(c->member);
    *c = (page_lines){0};
}

/* ---- the nearest on a line --------------------------------------------------------------------------------------- */

enum { AHEAD = 16 }; /* memory is prefetched this many pieces ahead */

/* A stretch of a line. */
typedef struct span {
    double t0, t1;
    uint32_t piece; /* the one seen there */
    uint32_t first; /* of the pieces joined into the stretch, the smallest number */
} span;

/* Positions along a line, and the depths of its pieces. */
typedef struct line_view {
    const pieces *p;
    roberts_vec2 from, u; /* u of length 1 */
    double tie;
} line_view;

static double position(const line_view *v, roberts_vec2 q)
{
    return (q.x - v->from.x) * v->u.x + (q.y - v->from.y) * v->u.y;
}

static double depth(const line_view *v, const piece *p, double t)
{
    double ta = position(v, p->a), tb = position(v, p->b);
    return p->za + (p->zb - p->za) * ((t - ta) / (tb - ta));
}

/* Of classes that coincide, the one of smallest rank is drawn. */
static const uint8_t rank[] = {
    [ROBERTS_OUTLINE] = 0, [ROBERTS_BORDER] = 1, [ROBERTS_CREASE] = 2, [ROBERTS_INTERSECTION] = 3,
    [ROBERTS_WIRE] = 4,    [ROBERTS_BACK] = 5,   [LINE_HATCH] = 6};

/* Whether piece p is drawn rather than q, if p is nearer by `nearer`. A visible piece always wins over a hidden one,
 * and any line over hatching. The loser may be nearer: it may lie just below the surface of the solid whose edge is
 * seen. */
static bool is_drawn_first(const piece *p, const piece *q, double nearer, double tie)
{
    const uint8_t back = rank[ROBERTS_BACK];
    if (p->line != q->line && (rank[p->line] >= back || rank[q->line] >= back))
        return rank[p->line] < rank[q->line];
    if (fabs(nearer) > tie)
        return nearer > 0.0;
    return p->line != q->line ? rank[p->line] < rank[q->line] : p->number < q->number;
}

/* Whether piece i is drawn rather than piece j at t. */
static bool is_before(const line_view *v, uint32_t i, uint32_t j, double t)
{
    const piece *p = &v->p->item[i], *q = &v->p->item[j];
    return is_drawn_first(p, q, depth(v, p, t) - depth(v, q, t), v->tie);
}

static void emit(span *out, size_t *count, uint32_t piece_index, double t0, double t1)
{
    if (t1 <= t0)
        return;
    if (*count && out[*count - 1].piece == piece_index && out[*count - 1].t1 == t0)
        out[*count - 1].t1 = t1;
    else
        out[(*count)++] = (span){t0, t1, piece_index, piece_index};
}

/* Merges two envelopes, each sorted and free of overlap; `out` has room for 2 (na + nb). */
static size_t merge_spans(const line_view *v, const span *a, size_t na, const span *b, size_t nb, span *out)
{
    size_t i = 0, j = 0, count = 0;
    double at = -INFINITY;
    while (i < na || j < nb) {
        double sa = i < na ? greater(a[i].t0, at) : INFINITY, sb = j < nb ? greater(b[j].t0, at) : INFINITY;
        double from = lesser(sa, sb);
        bool in_a = sa <= from, in_b = sb <= from;
        double to = lesser(in_a ? a[i].t1 : sa, in_b ? b[j].t1 : sb);
        bool take_a = in_a && (!in_b || is_before(v, a[i].piece, b[j].piece, 0.5 * (from + to)));
        emit(out, &count, take_a ? a[i].piece : b[j].piece, from, to);
        at = to;
        i += i < na && a[i].t1 <= at;
        j += j < nb && b[j].t1 <= at;
    }
    return count;
}

/* Replaces item[0 .. count-1] by their envelope. `item` and `work` have room for 2 count. Returns its size. */
static size_t envelope(const line_view *v, span *item, size_t count, span *work)
{
    if (count < 2)
        return count;
    size_t half = count / 2;
    memmove(item + 2 * half, item + half, (count - half) * sizeof *item);
    size_t na = envelope(v, item, half, work), nb = envelope(v, item + 2 * half, count - half, work);
    size_t merged = merge_spans(v, item, na, item + 2 * half, nb, work);
    memcpy(item, work, merged * sizeof *item);
    return merged;
}

/* Whether pieces i and j may be joined. */
static bool is_one_part(const pieces *p, uint32_t i, uint32_t j)
{
    return !p->part || p->part[p->item[i].number] == p->part[p->item[j].number];
}

/* Joins neighbours of one class and part. A stretch shorter than PIECE_TOUCH goes to a neighbour that it touches. */
static size_t join_spans(const line_view *v, span *item, size_t count)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        span *last = kept ? &item[kept - 1] : NULL;
        const piece *own = &v->p->item[item[i].piece];
        bool touches = last && item[i].t0 - last->t1 <= PIECE_TOUCH;
        bool same =
            touches && v->p->item[last->piece].line == own->line && is_one_part(v->p, last->first, item[i].first);
        if (same && own->number < v->p->item[last->first].number)
            last->first = item[i].first;
        if (same || (touches && item[i].t1 - item[i].t0 < PIECE_TOUCH)) {
            last->t1 = item[i].t1;
        } else if (touches && last->t1 - last->t0 < PIECE_TOUCH) {
            last->piece = item[i].piece;
            last->first = item[i].first;
            last->t1 = item[i].t1;
        } else {
            item[kept++] = item[i];
        }
    }
    return kept;
}

static int by_start(const void *a, const void *b)
{
    const span *p = a, *q = b;
    if (p->t0 != q->t0)
        return p->t0 < q->t0 ? -1 : 1;
    return p->piece < q->piece ? -1 : p->piece > q->piece;
}

/* ---- all lines ---- */

typedef struct result {
    piece *item;
    size_t count, room;
} result;

/* Appends the piece that a stretch is drawn as. It has the direction of the stretch's first piece. */
static bool add_seen_span(result *out, const line_view *v, const span *s)
{
    const piece *first = &v->p->item[s->first], *seen = &v->p->item[s->piece];
    roberts_vec2 a = {v->from.x + s->t0 * v->u.x, v->from.y + s->t0 * v->u.y};
    roberts_vec2 b = {v->from.x + s->t1 * v->u.x, v->from.y + s->t1 * v->u.y};
    bool forward = position(v, first->a) <= position(v, first->b);
    if (!array_reserve(&out->item, &out->room, out->count + 1, sizeof *out->item))
        return false;
    double za = depth(v, seen, s->t0), zb = depth(v, seen, s->t1);
    out->item[out->count++] = (piece){.a = forward ? a : b,
                                      .b = forward ? b : a,
                                      .za = forward ? za : zb,
                                      .zb = forward ? zb : za,
                                      .number = first->number,
                                      .line = seen->line};
    return true;
}

/* Draws a group: the stretches item[0 .. count-1], sorted; each one but the first touches an earlier one. */
static bool draw_group(const line_view *v, span *item, size_t count, span *pool, result *out)
{
    if (count == 1)
        return true; /* the piece stays as it is */
    span *work = pool + 2 * count;
    memcpy(pool, item, count * sizeof *item);
    size_t kept = join_spans(v, pool, envelope(v, pool, count, work));
    for (size_t i = 0; i < kept; i++)
        if (!add_seen_span(out, v, &pool[i]))
            return false;
    for (size_t i = 0; i < count; i++)
        v->p->item[item[i].piece].line = PIECE_GONE;
    return true;
}

static bool draw_line(const pieces *p, const page_line *c, const uint32_t *member, span *pool, double tie, result *out)
{
    const piece *longest = &p->item[c->longest];
    double length = piece_length(longest);
    line_view v = {
        p, longest->a, {(longest->b.x - longest->a.x) / length, (longest->b.y - longest->a.y) / length}, tie};
    span *item = pool;
    for (uint32_t i = 0; i < c->count; i++) {
        const piece *own = &p->item[member[i]];
        double ta = position(&v, own->a), tb = position(&v, own->b);
        if (i + AHEAD < c->count)
            FETCH_AHEAD(&p->item[member[i + AHEAD]]);
        item[i] = (span){lesser(ta, tb), greater(ta, tb), member[i], member[i]};
    }
    qsort(item, c->count, sizeof *item, by_start);
    for (size_t first = 0, end; first < c->count; first = end) {
        double reach = item[first].t1;
        for (end = first + 1; end < c->count && item[end].t0 <= reach + PIECE_TOUCH; end++)
            reach = greater(reach, item[end].t1);
        if (!draw_group(&v, item + first, end - first, pool + c->count, out))
            return false;
    }
    return true;
}

static bool draw_lines(const pieces *p, const page_lines *lines, double tie, result *out)
{
    span *pool = alloc_array(lines->most, 5 * sizeof *pool); /* stretches, their envelope, work */
    bool done = pool != NULL;
    for (uint32_t l = 0; l < lines->count && done; l++)
        if (lines->item[l].count > 1)
            done = draw_line(p, &lines->item[l], lines->member + lines->item[l].start, pool, tie, out);
    free(pool);
    return done;
}

/* Drops the removed pieces and merges in those that replace them, by number. */
static bool replace(pieces *p, const result *by)
{
    size_t kept = 0, room = p->count, left = by->count;
    uint32_t *key = alloc_array(left, sizeof *key), *order = alloc_array(left, sizeof *order);
    for (size_t i = 0; i < left && key; i++)
        key[i] = by->item[i].number;
    bool done = key && order && radix_order(key, (uint32_t)left, order);
    for (size_t i = 0; i < p->count && done; i++)
        if (p->item[i].line != PIECE_GONE)
            p->item[kept++] = p->item[i];
    done = done && array_reserve(&p->item, &room, kept + left, sizeof *p->item);
    if (done) {
        p->count = kept + left;
        for (size_t to = p->count; left > 0;) { /* from the end, so that nothing is overwritten */
            const piece *last = &by->item[order[left - 1]];
            bool moves = kept > 0 && p->item[kept - 1].number > last->number;
            p->item[--to] = moves ? p->item[--kept] : *last;
            left -= !moves;
        }
    }
    free(key);
    free(order);
    return done;
}

/* ---- twins: pieces from one place to another ---- */

enum { TWIN_CELL = 16 /* units; wide, so that few ends lie near a border */ };

#define NO_PIECE UINT32_MAX

typedef struct twins {
    pieces *p;
    uint32_t *head, *next; /* pieces by cells of their ends */
    unsigned bits;
    double tie;
} twins;

/* The ends of a piece, rounded. */
typedef struct rounded_ends {
    page_point a, b;
} rounded_ends;

static rounded_ends ends_of(const piece *p)
{
    return (rounded_ends){page_rounded(p->a), page_rounded(p->b)};
}

static bool are_twins(rounded_ends p, rounded_ends q)
{
    return (page_touches(p.a, q.a) && page_touches(p.b, q.b)) || (page_touches(p.a, q.b) && page_touches(p.b, q.a));
}

/* Finds the hashes of the cells near a point, its own cell first. Returns their number. */
static int end_hashes(page_point at, uint64_t hash[4])
{
    int32_t x[2], y[2];
    int columns = page_cells(at.x, TWIN_CELL, x), rows = page_cells(at.y, TWIN_CELL, y), count = 0;
    for (int i = 0; i < columns; i++)
        for (int k = 0; k < rows; k++)
            hash[count++] = ((uint64_t)(uint32_t)x[i] << 32 | (uint32_t)y[k]) * 0x9e3779b97f4a7c15u;
    return count;
}

/* The list of pieces with ends in two cells, either way round. */
static uint32_t *list_of(const twins *t, uint64_t a, uint64_t b)
{
    uint64_t mixed = (a ^ a >> 29) + (b ^ b >> 29);
    return &t->head[mixed * 0xbf58476d1ce4e5b9u >> (64 - t->bits)];
}

/* Puts piece i into its list. If it has a twin, one of the two is dropped. */
static void add_or_drop(twins *t, uint32_t i)
{
    piece *own = &t->p->item[i];
    const rounded_ends ends = ends_of(own);
    uint64_t a[4], b[4];
    int as = end_hashes(ends.a, a), bs = end_hashes(ends.b, b);
    for (int m = 0; m < as; m++)
        for (int n = 0; n < bs; n++)
            for (uint32_t k = *list_of(t, a[m], b[n]); k != NO_PIECE; k = t->next[k]) {
                piece *other = &t->p->item[k];
                if (other->line == PIECE_GONE || !are_twins(ends, ends_of(other)))
                    continue;
                double nearer = 0.5 * (own->za + own->zb - other->za - other->zb);
                if (!is_drawn_first(own, other, nearer, t->tie)) {
                    own->line = PIECE_GONE;
                    return;
                }
                other->line = PIECE_GONE;
            }
    uint32_t *list = list_of(t, a[0], b[0]);
    t->next[i] = *list;
    *list = i;
}

/* Keeps one of several pieces between the same two places. Edges of solids thinner than PIECE_TOUCH are such pieces.
 * They do not always lie on one line, but rounding would draw them as one. False: no memory. */
static bool drop_twins(pieces *p, double tie)
{
    size_t kept = 0;
    twins t = {.p = p, .bits = 4, .tie = tie};
    while (t.bits < 31 && p->count >> t.bits)
        t.bits++;
    size_t cells = (size_t)1 << t.bits;
    t.head = alloc_array(cells, sizeof *t.head);
    t.next = alloc_array(p->count, sizeof *t.next);
    bool done = t.head && t.next;
    if (done)
        memset(t.head, 0xff, cells * sizeof *t.head);
    for (size_t i = 0; i < p->count && done; i++)
        add_or_drop(&t, (uint32_t)i);
    for (size_t i = 0; i < p->count && done; i++)
        if (p->item[i].line != PIECE_GONE)
            p->item[kept++] = p->item[i];
    if (done)
        p->count = kept;
    free(t.head);
    free(t.next);
    return done;
}

bool overlap_remove(pieces *p, double tie)
{
    page_lines lines;
    result out = {0};
    if (p->count < 2)
        return true;
    bool done = collinear_find(&lines, p) && draw_lines(p, &lines, tie, &out);
    collinear_free(&lines);
    done = done && (out.count == 0 || replace(p, &out)) && drop_twins(p, tie);
    free(out.item);
    return done;
}
