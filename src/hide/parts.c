/* parts.c - see parts.h. */
#include "hide/parts.h"

#include <stdlib.h>

#include "base/array.h"

bool hide_parts_add(hide_parts *parts, uint32_t solid, hide_part part, size_t *slot)
{
    if (*slot == SIZE_MAX) {
        if (!array_reserve(&parts->item, &parts->room, parts->count + 1, sizeof *parts->item))
            return false;
        *slot = parts->count++;
        parts->item[*slot] = (hide_solid_part){part, solid};
        return true;
    }
    hide_part *hull = &parts->item[*slot].part;
    if (part.t0 < hull->t0 || (part.t0 == hull->t0 && part.e0 > hull->e0)) {
        hull->t0 = part.t0;
        hull->e0 = part.e0;
    }
    if (part.t1 > hull->t1 || (part.t1 == hull->t1 && part.e1 > hull->e1)) {
        hull->t1 = part.t1;
        hull->e1 = part.e1;
    }
    return true;
}

/* By where a part can first touch another; ties fall by what is left, so that the order in which the parts were found
 * leaves no trace. */
static int compare(const void *pa, const void *pb)
{
    const hide_solid_part *a = pa, *b = pb;
    double reach_a = a->part.t0 - a->part.e0, reach_b = b->part.t0 - b->part.e0;
    if (reach_a != reach_b)
        return reach_a < reach_b ? -1 : 1;
    if (a->part.t0 != b->part.t0)
        return a->part.t0 < b->part.t0 ? -1 : 1;
    return (a->solid > b->solid) - (a->solid < b->solid);
}

/* Few parts, as there mostly are, are put in their places one by one. */
static void sort(hide_parts *parts)
{
    if (parts->count > 16) {
        qsort(parts->item, parts->count, sizeof *parts->item, compare);
        return;
    }
    for (size_t i = 1; i < parts->count; i++) {
        hide_solid_part moved = parts->item[i];
        size_t k = i;
        for (; k > 0 && compare(&parts->item[k - 1], &moved) > 0; k--)
            parts->item[k] = parts->item[k - 1];
        parts->item[k] = moved;
    }
}

void hide_parts_unite(hide_parts *parts, double epsilon, double length)
{
    size_t kept = 0;
    sort(parts);
    for (size_t i = 0; i < parts->count; i++) {
        hide_part next = parts->item[i].part;
        hide_part *last = kept ? &parts->item[kept - 1].part : NULL;
        if (last && (next.t0 - next.e0 <= last->t1 + last->e1 || (next.t0 - last->t1) * length <= epsilon)) {
            if (next.t0 < last->t0)
                last->t0 = next.t0;
            double reach = greater(last->t1 + last->e1, next.t1 + next.e1); /* of any member, also of a shorter one */
            last->t1 = greater(last->t1, next.t1);
            last->e1 = reach - last->t1;
        } else {
            parts->item[kept++] = parts->item[i];
        }
    }
    parts->count = kept;
    if (kept) {
        hide_part *first = &parts->item[0].part, *last = &parts->item[kept - 1].part;
        if (first->t0 * length <= epsilon)
            first->t0 = 0.0;
        if ((1.0 - last->t1) * length <= epsilon)
            last->t1 = 1.0;
    }
}
