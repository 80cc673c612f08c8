/* parts.h - hidden parts of one edge and their union.
 *
 * What one convex solid hides of an edge is one interval, because the volume behind it is convex (see pair.h). Parts of
 * different solids, and of the faces of a solid of many faces, are joined where they overlap or touch. */
#ifndef ROBERTS_HIDE_PARTS_H
#define ROBERTS_HIDE_PARTS_H

#include "hide/space.h"

typedef struct hide_solid_part {
    hide_part part;
    uint32_t solid;
} hide_solid_part;

typedef struct hide_parts {
    hide_solid_part *item; /* [count] */
    size_t count, room;
} hide_parts;

/* Is every point between them within reach of one of them? */
static inline bool hide_parts_touch(const hide_part *a, const hide_part *b)
{
    return a->r0 <= b->r1 && b->r0 <= a->r1;
}

/* Their union, which reaches as far as either of them, also where the shorter one reaches farther. */
static inline hide_part hide_parts_joined(const hide_part *a, const hide_part *b)
{
    return (hide_part){lesser(a->t0, b->t0), greater(a->t1, b->t1), lesser(a->r0, b->r0), greater(a->r1, b->r1)};
}

bool hide_parts_add_closely(hide_parts *parts, uint32_t solid, hide_part *part);

/* Adds what a front of `solid` hides, joined with the parts that it overlaps or touches (as long as these are few);
 * `*part` becomes what it has grown to. False: no memory. Mostly there is one part, or none. */
static inline bool hide_parts_add(hide_parts *parts, uint32_t solid, hide_part *part)
{
    hide_solid_part *only = parts->item;
    if (parts->count == 1 && hide_parts_touch(&only->part, part)) {
        only->part = *part = hide_parts_joined(&only->part, part);
        only->solid = solid < only->solid ? solid : only->solid;
        return true;
    }
    if (parts->count > 0 || parts->room == 0)
        return hide_parts_add_closely(parts, solid, part);
    parts->item[parts->count++] = (hide_solid_part){*part, solid};
    return true;
}

/* Adds what one face of `solid` hides to the hull of what its other faces do, which `*part` becomes: faces given to few
 * digits, or cut by the near plane, leave gaps between them, and the solid none. Of very many solids one may have several
 * hulls until hide_parts_hulls_done(). False: no memory. */
bool hide_parts_hull(hide_parts *hulls, uint32_t solid, hide_part *part);

/* Leaves one hull of each solid. */
void hide_parts_hulls_done(hide_parts *hulls);

/* Parts nearer than `epsilon` to an end of the edge reach it. */
static inline void hide_parts_reach_ends(hide_parts *parts, double epsilon, double length)
{
    hide_part *first = &parts->item[0].part, *last = &parts->item[parts->count - 1].part;
    if (first->t0 * length <= epsilon)
        first->t0 = 0.0;
    if ((1.0 - last->t1) * length <= epsilon)
        last->t1 = 1.0;
}

/* Puts several parts in order and joins those that touch. */
void hide_parts_join(hide_parts *parts, double epsilon, double length);

/* Unites the parts in place: afterwards they ascend and are disjoint, with more than `epsilon` between them and between
 * them and the ends of the edge, `length` long (in space, the unit of epsilon). `solid` of a union is the smallest
 * of its members'. */
static inline void hide_parts_unite(hide_parts *parts, double epsilon, double length)
{
    if (parts->count > 1)
        hide_parts_join(parts, epsilon, length);
    if (parts->count)
        hide_parts_reach_ends(parts, epsilon, length);
}

#endif
