/* parts.c - see parts.h. */
#include "hide/parts.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/sort.h"

/* With more parts than this a new one is not held against each, or with more hulls only against so many of the last: they
 * are joined when all are there. */
#define FEW 32
/* So many are put in order one by one; and from so many on comparing takes longer than counting digits. */
#define SHORT_RUN 16
#define MANY 256

static bool append(hide_parts *parts, uint32_t solid, const hide_part *part)
{
    if (!array_reserve(&parts->item, &parts->room, parts->count + 1, sizeof *parts->item))
        return false;
    parts->item[parts->count++] = (hide_solid_part){*part, solid};
    return true;
}

bool hide_parts_add_closely(hide_parts *parts, uint32_t solid, hide_part *part)
{
    for (size_t i = parts->count; parts->count <= FEW && i-- > 0;) {
        if (!hide_parts_touch(&parts->item[i].part, part))
            continue;
        *part = hide_parts_joined(&parts->item[i].part, part);
        solid = parts->item[i].solid < solid ? parts->item[i].solid : solid;
        parts->item[i] = parts->item[--parts->count];
        i = parts->count; /* the greater part may touch what the smaller did not */
    }
    return append(parts, solid, part);
}

/* From the end: the faces of a solid mostly come one after another. */
bool hide_parts_hull(hide_parts *hulls, uint32_t solid, hide_part *part)
{
    size_t first = hulls->count > FEW ? hulls->count - FEW : 0;
    for (size_t i = hulls->count; i-- > first;)
        if (hulls->item[i].solid == solid) {
            hulls->item[i].part = *part = hide_parts_joined(&hulls->item[i].part, part);
            return true;
        }
    return append(hulls, solid, part);
}

/* By where a part can first touch another; ties fall by what is left, so that the order in which the parts were found
 * leaves no trace. */
static int compare(const void *pa, const void *pb)
{
    const hide_solid_part *a = pa, *b = pb;
    if (a->part.r0 != b->part.r0)
        return a->part.r0 < b->part.r0 ? -1 : 1;
    if (a->part.t0 != b->part.t0)
        return a->part.t0 < b->part.t0 ? -1 : 1;
    return (a->solid > b->solid) - (a->solid < b->solid);
}

static int compare_solids(const void *pa, const void *pb)
{
    const hide_solid_part *a = pa, *b = pb;
    return a->solid != b->solid ? (a->solid > b->solid ? 1 : -1) : compare(pa, pb);
}

void hide_parts_hulls_done(hide_parts *hulls)
{
    size_t kept = 0;
    hide_solid_part *item = hulls->item;
    if (hulls->count <= FEW)
        return;
    qsort(item, hulls->count, sizeof *item, compare_solids);
    for (size_t i = 0; i < hulls->count; i++)
        if (kept && item[kept - 1].solid == item[i].solid)
            item[kept - 1].part = hide_parts_joined(&item[kept - 1].part, &item[i].part);
        else
            item[kept++] = item[i];
    hulls->count = kept;
}

/* A run in which few are far from their places, one by one. */
static void put_in_place(hide_solid_part *item, size_t count)
{
    SORT_FEW(hide_solid_part, item, count, compare(a, b) > 0)
}

static float begins(const hide_solid_part *p)
{
    return (float)p->part.r0;
}

/* By a float's worth of where they begin, without comparing; false: no memory. */
static bool sort_roughly(hide_solid_part *item, uint32_t count)
{
    uint32_t *key = alloc_array(count, sizeof *key), *order = alloc_array(count, sizeof *order);
    hide_solid_part *sorted = alloc_array(count, sizeof *sorted);
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

/* Few parts, as there mostly are, are put in their places one by one. Of many, those that begin in the same float are
 * left to be sorted; without memory, all. */
static void sort(hide_parts *parts)
{
    size_t count = parts->count;
    hide_solid_part *item = parts->item;
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

void hide_parts_join(hide_parts *parts, double epsilon, double length)
{
    size_t kept = 0;
    sort(parts);
    for (size_t i = 0; i < parts->count; i++) {
        hide_part next = parts->item[i].part;
        hide_part *last = kept ? &parts->item[kept - 1].part : NULL;
        if (last && (hide_parts_touch(last, &next) || (next.t0 - last->t1) * length <= epsilon)) {
            *last = hide_parts_joined(last, &next);
            if (parts->item[i].solid < parts->item[kept - 1].solid)
                parts->item[kept - 1].solid = parts->item[i].solid;
        } else {
            parts->item[kept++] = parts->item[i];
        }
    }
    parts->count = kept;
}
