/* intervals.c - hidden parts of one edge and their union. See intervals.h. */
#include "hide/intervals.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/sort.h"

/* With more parts than this, a new part is not compared with the others, and a new hull only with this many of the last
 * ones. They are joined at the end. */
#define FEW 32
/* Up to SHORT_RUN parts are sorted by insertion. From MANY on, radix sort is faster than comparing. */
#define SHORT_RUN 16
#define MANY 256

static bool append_interval(hide_intervals *intervals, uint32_t solid, const hide_interval *part)
{
    if (!array_reserve(&intervals->item, &intervals->room, intervals->count + 1, sizeof *intervals->item))
        return false;
    intervals->item[intervals->count++] = (hide_solid_interval){*part, solid};
    return true;
}

bool hide_intervals_add_closely(hide_intervals *intervals, uint32_t solid, hide_interval *part)
{
    for (size_t i = intervals->count; intervals->count <= FEW && i-- > 0;) {
        if (!hide_intervals_touch(&intervals->item[i].part, part))
            continue;
        *part = hide_intervals_joined(&intervals->item[i].part, part);
        solid = intervals->item[i].solid < solid ? intervals->item[i].solid : solid;
        intervals->item[i] = intervals->item[--intervals->count];
        i = intervals->count; /* the larger part may touch others that the smaller did not */
    }
    return append_interval(intervals, solid, part);
}

/* Searches from the end: the faces of a solid usually come one after another. */
bool hide_intervals_hull(hide_intervals *hulls, uint32_t solid, hide_interval *part)
{
    size_t first = hulls->count > FEW ? hulls->count - FEW : 0;
    for (size_t i = hulls->count; i-- > first;)
        if (hulls->item[i].solid == solid) {
            hulls->item[i].part = *part = hide_intervals_joined(&hulls->item[i].part, part);
            return true;
        }
    return append_interval(hulls, solid, part);
}

/* Orders parts by where they can first touch another. Ties are broken by start and solid, so that the order in which
 * the parts were found does not matter. */
static int compare(const void *pa, const void *pb)
{
    const hide_solid_interval *a = pa, *b = pb;
    if (a->part.r0 != b->part.r0)
        return a->part.r0 < b->part.r0 ? -1 : 1;
    if (a->part.t0 != b->part.t0)
        return a->part.t0 < b->part.t0 ? -1 : 1;
    return (a->solid > b->solid) - (a->solid < b->solid);
}

static int compare_solids(const void *pa, const void *pb)
{
    const hide_solid_interval *a = pa, *b = pb;
    return a->solid != b->solid ? (a->solid > b->solid ? 1 : -1) : compare(pa, pb);
}

void hide_intervals_hulls_done(hide_intervals *hulls)
{
    size_t kept = 0;
    hide_solid_interval *item = hulls->item;
    if (hulls->count <= FEW)
        return;
    qsort(item, hulls->count, sizeof *item, compare_solids);
    for (size_t i = 0; i < hulls->count; i++)
        if (kept && item[kept - 1].solid == item[i].solid)
            item[kept - 1].part = hide_intervals_joined(&item[kept - 1].part, &item[i].part);
        else
            item[kept++] = item[i];
    hulls->count = kept;
}

/* Insertion sort, for runs that are nearly sorted. */
static void put_in_place(hide_solid_interval *item, size_t count)
{
    SORT_FEW(hide_solid_interval, item, count, compare(a, b) > 0)
}

static float begins(const hide_solid_interval *p)
{
    return (float)p->part.r0;
}

/* Radix-sorts by the start of the parts, rounded to float. False: no memory. */
static bool sort_roughly(hide_solid_interval *item, uint32_t count)
{
    uint32_t *key = alloc_array(count, sizeof *key), *order = alloc_array(count, sizeof *order);
    hide_solid_interval *sorted = alloc_array(count, sizeof *sorted);
    bool done = key && order && sorted;
    for (uint32_t i = 0; done && i < count; i++)
        key[i] = ~radix_key_descending(begins(&item[i]));
    done = done && radix_order(key, count, order);
    for (uint32_t i = 0; done && i < count; i++)
        sorted[i] = item[order[i]];
    if (done)
        memcpy(item, sorted, count * sizeof *item);
    free(key);
    free(order);
    free(sorted);
    return done;
}

/* Sorts the parts. Usually there are few, and insertion sort does. Many are radix-sorted by float first; then only
 * parts with equal float keys are compared. If memory runs out, qsort() sorts them all. */
static void sort(hide_intervals *intervals)
{
    size_t count = intervals->count;
    hide_solid_interval *item = intervals->item;
    if (count <= SHORT_RUN) {
        put_in_place(item, count);
        return;
    }
    if (count < MANY || count > UINT32_MAX || !sort_roughly(item, (uint32_t)count)) {
        qsort(item, count, sizeof *item, compare);
        return;
    }
    for (size_t first = 0, end; first < count; first = end) {
        for (end = first + 1; end < count && begins(&item[end]) == begins(&item[first]); end++) {
        }
        if (end - first <= SHORT_RUN)
            put_in_place(item + first, end - first);
        else
            qsort(item + first, end - first, sizeof *item, compare);
    }
}

void hide_intervals_join(hide_intervals *intervals, double epsilon, double length)
{
    size_t kept = 0;
    sort(intervals);
    for (size_t i = 0; i < intervals->count; i++) {
        hide_interval next = intervals->item[i].part;
        hide_interval *last = kept ? &intervals->item[kept - 1].part : NULL;
        if (last && (hide_intervals_touch(last, &next) || (next.t0 - last->t1) * length <= epsilon)) {
            *last = hide_intervals_joined(last, &next);
            if (intervals->item[i].solid < intervals->item[kept - 1].solid)
                intervals->item[kept - 1].solid = intervals->item[i].solid;
        } else {
            intervals->item[kept++] = intervals->item[i];
        }
    }
    intervals->count = kept;
}

size_t hide_intervals_first(const hide_intervals *intervals, double t)
{
    size_t low = 0, high = intervals->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (intervals->item[middle].part.t1 > t)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

bool hide_intervals_split(hide_intervals *intervals, double t)
{
    const size_t i = hide_intervals_first(intervals, t);
    if (i == intervals->count || !(intervals->item[i].part.t0 < t))
        return true;
    if (!array_reserve(&intervals->item, &intervals->room, intervals->count + 1, sizeof *intervals->item))
        return false;
    hide_solid_interval *item = intervals->item + i;
    memmove(item + 1, item, (intervals->count - i) * sizeof *item);
    intervals->count++;
    item[0].part.t1 = item[0].part.r1 = t;
    item[1].part.t0 = item[1].part.r0 = t;
    return true;
}

/* ---- the reach of a part ----------------------------------------------------------------------------------------- */

/* Returns where the edge is epsilon outside the line from P to Q, on its way out (or in). Infinite if it never is. Also
 * infinite if the side is no longer than epsilon: then its neighbours bound the polygon. */
static double leaves(const hide_space *space, const hide_edge *e, roberts_vec3 P, roberts_vec3 Q, bool out)
{
    double dx = Q.x - P.x, dy = Q.y - P.y, length = sqrt(dx * dx + dy * dy);
    double a = dx * (e->A.y - P.y) - dy * (e->A.x - P.x), b = dx * (e->B.y - P.y) - dy * (e->B.x - P.x);
    if (length <= space->epsilon || (out ? a <= b : b <= a))
        return out ? INFINITY : -INFINITY;
    return (a + space->epsilon * length) / (a - b);
}

/* Returns the parameter of the edge's point that is nearest to P in the picture. */
static double along(roberts_vec3 P, const hide_edge *e)
{
    return ((e->B.x - e->A.x) * (P.x - e->A.x) + (e->B.y - e->A.y) * (P.y - e->A.y)) / (e->length * e->length);
}

/* Walks along the border in the direction of the edge, from the crossed side to the end of the reach or the farthest
 * corner. (The sides before the crossing are flatter to the edge, so the edge is epsilon outside them later.) If the
 * edge enters, the walk goes backward: all parameters change sign. */
double reach_along(const hide_space *space, const hide_edge *e, const reach_border *border, double touch, double *t)
{
    const hide_face *F = border->F;
    double sign = border->out ? 1.0 : -1.0, epsilon = space->epsilon / e->length, begin = sign * *t;
    double s0 = sign * along(space->P[F->corner[border->first]], e), reach = begin + touch;
    double s1 = sign * along(space->P[F->corner[border->last]], e), farthest = greater(s0, s1);
    bool up = s1 >= s0;
    uint32_t from = up ? border->last : border->first;
    for (uint32_t n = 0; n < F->count && farthest < reach; n++) {
        uint32_t to = up ? (from + 1 < F->count ? from + 1 : 0) : (from > 0 ? from : F->count) - 1;
        double s = sign * along(space->P[F->corner[to]], e);
        if (s < farthest - epsilon) {
            begin = begin > farthest + epsilon ? farthest : begin;
            reach = lesser(reach, greater(farthest, begin) + epsilon);
            break;
        }
        roberts_vec3 P = space->P[F->corner[up ? from : to]], Q = space->P[F->corner[up ? to : from]];
        reach = lesser(reach, sign * leaves(space, e, P, Q, border->out));
        farthest = greater(farthest, s);
        from = to;
    }
    *t = sign * begin;
    return sign * greater(reach, begin + space->epsilon / e->length3);
}

void reach_corners(const hide_space *space, const hide_edge *e, const hide_face *F, hide_interval *part)
{
    double first = INFINITY, last = -INFINITY, epsilon = space->epsilon / e->length;
    for (uint32_t i = 0; i < F->count; i++) {
        double s = along(space->P[F->corner[i]], e);
        first = lesser(first, s);
        last = greater(last, s);
    }
    if (part->t0 < first - epsilon) {
        part->t0 = first;
        part->r0 = first - epsilon;
    }
    if (part->t1 > last + epsilon) {
        part->t1 = last;
        part->r1 = last + epsilon;
    }
}
