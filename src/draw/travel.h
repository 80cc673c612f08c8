/* travel.h - the order and the direction in which polylines are drawn. */
#ifndef ROBERTS_DRAW_TRAVEL_H
#define ROBERTS_DRAW_TRAVEL_H

#include "draw/chain.h"

/* Orders item[first ..] of `p` so that the lifted pen, which starts at `*pen`, travels little. Open polylines may be
 * turned round. `*pen` becomes the end of the last one. False: no memory, and nothing has changed. */
bool travel_order(polylines *p, size_t first, page_point *pen);

/* Where the pen goes down and where it is lifted. */
static inline page_point polyline_start(const polylines *p, const polyline *line)
{
    return p->point[line->first];
}

static inline page_point polyline_end(const polylines *p, const polyline *line)
{
    return p->point[line->first + (line->closed ? 0 : line->count - 1)];
}

#endif
