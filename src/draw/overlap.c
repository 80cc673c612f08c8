/* overlap.c - no line is drawn twice.
 *
 * Edges of solids that touch coincide, and so do edges behind one another. Pieces are first sorted to lines, by a hash
 * of direction and distance from the origin: a piece belongs to the first line found that it coincides with, and its
 * longest piece stands for a line. The cells of the hash are wider than what coincides, so that a piece looks into its
 * own cell, and into a neighbour only where it lies near the border. On each line the nearest pieces make the upper
 * envelope of depth over position, by halving and merging (Hershberger, "Finding the upper envelope of n line segments
 * in O(n log n) time", Information Processing Letters 33(4), 1989): n log n however many lie on one another. Two that
 * coincide and pass one another in depth are told apart in the middle of each stretch between ends.
 *
 * Directions are measured as x + y of a point on the diamond |x| + |y| = 1, upper half: 0 to 2, no slower than the angle
 * by more than a half. They are turned first, so that the wrap from 2 to 0, where a line's sign changes, is at no
 * direction that drawings are full of. */
#include "draw/overlap.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/radix.h"
#include "base/vec.h"

/* Radians by which coincident pieces may differ: 0.001 mm on 100 mm. Shorter ones are held to it all the same, so that
 * fine facets keep their bends; what coincides exactly is rounded to far less. */
static const double same_direction = 1e-5;

enum { DIRECTIONS = 25000 }; /* cells from 0 to 2, 8 times as wide as what coincides */

static const double direction_cell = 2.0 / DIRECTIONS;

#define NO_LINE UINT32_MAX

/* One line with pieces on it. */
typedef struct carrier {
    double distance;  /* of its first piece from the origin, with no sign: looked at before the pieces are */
    uint32_t longest; /* piece */
    uint32_t next;    /* in the same cell of the hash */
    uint32_t count;   /* pieces */
} carrier;

/* Where a piece lies among all lines. */
typedef struct bearing {
    double direction; /* 0 .. 2 */
    double distance;  /* of the line from the origin, with a sign */
} bearing;

typedef struct sorter {
    const pieces *p;
    roberts_vec2 origin;  /* the middle of all pieces */
    double reach;         /* distances of coincident lines differ by no more */
    uint32_t *head, bits; /* of the hash: first line of a cell, NO_LINE */
    carrier *line;
    uint32_t line_count, *line_of; /* [pieces] */
} sorter;

/* A stretch of a line. */
typedef struct span {
    double t0, t1;
    uint32_t piece; /* that is seen there */
    uint32_t first; /* the one of least number that was joined to it */
} span;

/* ---- lines ---- */

static double length_of(const piece *p)
{
    double x = p->b.x - p->a.x, y = p->b.y - p->a.y;
    return sqrt(x * x + y * y); /* three times as fast as hypot(); a page is far from overflow */
}

static bearing bearing_of(const sorter *s, const piece *p)
{
    const double cosine = 0.8253356149096783, sine = 0.5646424733950354; /* of 0.6 radians */
    double x = p->b.x - p->a.x, y = p->b.y - p->a.y, length = length_of(p);
    double u = cosine * x - sine * y, v = sine * x + cosine * y;
    double sign = v < 0.0 || (v == 0.0 && u < 0.0) ? -1.0 : 1.0;
    double along = sign * u / (fabs(u) + fabs(v)); /* 1 .. -1 as the angle goes from 0 to 180 degrees */
    double cross = x * (s->origin.y - p->a.y) - y * (s->origin.x - p->a.x);
    return (bearing){1.0 - along, sign * cross / length};
}

/* Whether the ends of the shorter lie on the line of the longer, and they run the same way or opposite ways. */
static bool coincide(const piece *p, const piece *q)
{
    double lp = length_of(p), lq = length_of(q);
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

static uint32_t *cell_of(const sorter *s, int64_t direction, int64_t distance)
{
    uint64_t key = ((uint64_t)direction << 40) ^ (uint64_t)distance;
    return &s->head[(key * 0x9e3779b97f4a7c15u) >> (64 - s->bits)];
}

static uint32_t find_in_cell(const sorter *s, const piece *p, double from_origin, int64_t direction, int64_t distance)
{
    uint32_t line = *cell_of(s, direction, distance);
    while (line != NO_LINE &&
           (fabs(s->line[line].distance - from_origin) > s->reach || !coincide(p, &s->p->item[s->line[line].longest])))
        line = s->line[line].next;
    return line;
}

/* The two cells of a value, or one twice, where neighbours need not be looked at. */
static void cells_near(double value, double width, double reach, int64_t cell[2])
{
    cell[0] = (int64_t)floor(value / width);
    double in = value - (double)cell[0] * width;
    cell[1] = in < reach ? cell[0] - 1 : in > width - reach ? cell[0] + 1 : cell[0];
}

static double distance_cell(const sorter *s)
{
    return 2.0 * s->reach; /* narrow: of a million lines few are to be in one */
}

/* A line that piece p lies on, NO_LINE; `own` becomes its own cell. */
static uint32_t find_line(const sorter *s, const piece *p, bearing at, uint32_t **own)
{
    int64_t direction[2], distance[2];
    uint32_t line = NO_LINE;
    cells_near(at.direction, direction_cell, same_direction, direction);
    int sectors = direction[1] != direction[0] ? 2 : 1;
    for (int i = 0; i < sectors && line == NO_LINE; i++) {
        bool wraps = direction[i] < 0 || direction[i] >= DIRECTIONS;
        cells_near(wraps ? -at.distance : at.distance, distance_cell(s), s->reach, distance);
        int64_t d = (direction[i] + DIRECTIONS) % DIRECTIONS;
        if (i == 0)
            *own = cell_of(s, d, distance[0]);
        line = find_in_cell(s, p, fabs(at.distance), d, distance[0]);
        if (line == NO_LINE && distance[1] != distance[0])
            line = find_in_cell(s, p, fabs(at.distance), d, distance[1]);
    }
    return line;
}

static void sort_to_lines(sorter *s)
{
    for (uint32_t i = 0; i < s->p->count; i++) {
        const piece *p = &s->p->item[i];
        bearing at = bearing_of(s, p);
        uint32_t *own = NULL, line = find_line(s, p, at, &own);
        if (line == NO_LINE) {
            line = s->line_count++;
            s->line[line] = (carrier){.distance = fabs(at.distance), .longest = i, .next = *own};
            *own = line;
        } else if (length_of(p) > length_of(&s->p->item[s->line[line].longest])) {
            s->line[line].longest = i;
        }
        s->line[line].count++;
        s->line_of[i] = line;
    }
}

/* ---- the nearest on a line ---- */

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

/* Whether piece i is drawn rather than j at t. */
static bool is_before(const line_view *v, uint32_t i, uint32_t j, double t)
{
    const piece *p = &v->p->item[i], *q = &v->p->item[j];
    double nearer = depth(v, p, t) - depth(v, q, t);
    if (fabs(nearer) > v->tie)
        return nearer > 0.0;
    return p->line != q->line ? p->line < q->line : p->number < q->number;
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
static size_t merge(const line_view *v, const span *a, size_t na, const span *b, size_t nb, span *out)
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

/* Envelope of item[0 .. count-1] into the same array, which has room for 2 count; `work` has as much. */
static size_t envelope(const line_view *v, span *item, size_t count, span *work)
{
    if (count < 2)
        return count;
    size_t half = count / 2;
    memmove(item + 2 * half, item + half, (count - half) * sizeof *item);
    size_t na = envelope(v, item, half, work), nb = envelope(v, item + 2 * half, count - half, work);
    size_t merged = merge(v, item, na, item + 2 * half, nb, work);
    memcpy(item, work, merged * sizeof *item);
    return merged;
}

/* Joins neighbours of one class; what is shorter than PIECE_TOUCH goes to a neighbour that it touches. */
static size_t join(const line_view *v, span *item, size_t count)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        span *last = kept ? &item[kept - 1] : NULL;
        const piece *own = &v->p->item[item[i].piece];
        bool touches = last && item[i].t0 - last->t1 <= PIECE_TOUCH;
        bool same = touches && v->p->item[last->piece].line == own->line;
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

/* What a stretch is drawn as; it runs the way its first piece does. */
static bool add_piece(result *out, const line_view *v, const span *s)
{
    const piece *first = &v->p->item[s->first], *seen = &v->p->item[s->piece];
    roberts_vec2 a = {v->from.x + s->t0 * v->u.x, v->from.y + s->t0 * v->u.y};
    roberts_vec2 b = {v->from.x + s->t1 * v->u.x, v->from.y + s->t1 * v->u.y};
    bool forward = position(v, first->a) <= position(v, first->b);
    if (!array_reserve(&out->item, &out->room, out->count + 1, sizeof *out->item))
        return false;
    out->item[out->count++] =
        (piece){.a = forward ? a : b, .b = forward ? b : a, .number = first->number, .line = seen->line};
    return true;
}

/* The stretches item[0 .. count-1], sorted, one group of which each touches one before. */
static bool do_group(const line_view *v, span *item, size_t count, span *pool, result *out)
{
    if (count == 1)
        return true; /* stays as it is */
    span *work = pool + 2 * count;
    memcpy(pool, item, count * sizeof *item);
    size_t kept = join(v, pool, envelope(v, pool, count, work));
    for (size_t i = 0; i < kept; i++)
        if (!add_piece(out, v, &pool[i]))
            return false;
    for (size_t i = 0; i < count; i++)
        v->p->item[item[i].piece].line = PIECE_GONE;
    return true;
}

static bool do_line(const sorter *s, uint32_t line, const uint32_t *member, span *pool, double tie, result *out)
{
    const carrier *c = &s->line[line];
    const piece *longest = &s->p->item[c->longest];
    double length = length_of(longest);
    line_view v = {
        s->p, longest->a, {(longest->b.x - longest->a.x) / length, (longest->b.y - longest->a.y) / length}, tie};
    span *item = pool;
    for (uint32_t i = 0; i < c->count; i++) {
        double ta = position(&v, s->p->item[member[i]].a), tb = position(&v, s->p->item[member[i]].b);
        item[i] = (span){lesser(ta, tb), greater(ta, tb), member[i], member[i]};
    }
    qsort(item, c->count, sizeof *item, by_start);
    for (size_t first = 0, end; first < c->count; first = end) {
        double reach = item[first].t1;
        for (end = first + 1; end < c->count && item[end].t0 <= reach + PIECE_TOUCH; end++)
            reach = greater(reach, item[end].t1);
        if (!do_group(&v, item + first, end - first, pool + c->count, out))
            return false;
    }
    return true;
}

/* Fills member[start ..] with the pieces of the lines that have several; `start` of a line becomes the end of its own.
 * Returns the greatest number of pieces on a line. */
static uint32_t list_members(const sorter *s, uint32_t *start, uint32_t *member)
{
    uint32_t most = 0, total = 0;
    for (uint32_t l = 0; l < s->line_count; l++) {
        start[l] = total;
        if (s->line[l].count > 1)
            total += s->line[l].count;
        if (s->line[l].count > most)
            most = s->line[l].count;
    }
    for (uint32_t i = 0; i < s->p->count; i++)
        if (s->line[s->line_of[i]].count > 1)
            member[start[s->line_of[i]]++] = i;
    return most;
}

static bool do_lines(const sorter *s, double tie, result *out)
{
    uint32_t *start = alloc_array(s->line_count, sizeof *start), *member = alloc_array(s->p->count, sizeof *member);
    span *pool = NULL;
    bool done = false;
    if (!start || !member)
        goto done;
    pool = alloc_array(list_members(s, start, member), 5 * sizeof *pool); /* stretches, their envelope, work */
    if (!pool)
        goto done;
    done = true;
    for (uint32_t l = 0; l < s->line_count && done; l++)
        if (s->line[l].count > 1)
            done = do_line(s, l, member + start[l] - s->line[l].count, pool, tie, out);
done:
    free(start);
    free(member);
    free(pool);
    return done;
}

/* Drops what is gone, adds what came for it, and sorts by number. */
static bool replace(pieces *p, const result *by)
{
    size_t kept = 0;
    for (size_t i = 0; i < p->count; i++)
        if (p->item[i].line != PIECE_GONE)
            p->item[kept++] = p->item[i];
    size_t total = kept + by->count;
    piece *sorted = alloc_array(total, sizeof *sorted);
    uint32_t *key = alloc_array(total, sizeof *key), *order = alloc_array(total, sizeof *order);
    bool done = sorted && key && order;
    for (size_t i = 0; i < total && done; i++)
        key[i] = i < kept ? p->item[i].number : by->item[i - kept].number;
    done = done && radix_order(key, (uint32_t)total, order);
    for (size_t i = 0; i < total && done; i++)
        sorted[i] = order[i] < kept ? p->item[order[i]] : by->item[order[i] - kept];
    free(key);
    free(order);
    if (!done) {
        free(sorted);
        return false;
    }
    free(p->item);
    *p = (pieces){sorted, total};
    return true;
}

/* The origin of distances: near the pieces, so that the distance of a line suffers least from its direction. */
static void prepare(sorter *s)
{
    roberts_vec2 min = {INFINITY, INFINITY}, max = {-INFINITY, -INFINITY};
    for (size_t i = 0; i < s->p->count; i++) {
        const piece *p = &s->p->item[i];
        min = (roberts_vec2){lesser(min.x, lesser(p->a.x, p->b.x)), lesser(min.y, lesser(p->a.y, p->b.y))};
        max = (roberts_vec2){greater(max.x, greater(p->a.x, p->b.x)), greater(max.y, greater(p->a.y, p->b.y))};
    }
    s->origin = (roberts_vec2){0.5 * (min.x + max.x), 0.5 * (min.y + max.y)};
    s->reach = PIECE_TOUCH + same_direction * 0.5 * hypot(max.x - min.x, max.y - min.y);
    for (s->bits = 4; s->bits < 31 && s->p->count >> s->bits; s->bits++)
        ;
}

bool overlap_remove(pieces *p, double tie)
{
    sorter s = {.p = p};
    result out = {0};
    bool done = false;
    if (p->count < 2)
        return true;
    prepare(&s);
    s.head = alloc_array((size_t)1 << s.bits, sizeof *s.head);
    s.line = alloc_array(p->count, sizeof *s.line);
    s.line_of = alloc_array(p->count, sizeof *s.line_of);
    if (!s.head || !s.line || !s.line_of)
        goto done;
    memset(s.head, 0xff, ((size_t)1 << s.bits) * sizeof *s.head);
    sort_to_lines(&s);
    done = do_lines(&s, tie, &out) && (out.count == 0 || replace(p, &out));
done:
    free(s.head);
    free(s.line);
    free(s.line_of);
    free(out.item);
    return done;
}
