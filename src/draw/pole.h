/* pole.h - the point of a region that is farthest from its border. */
#ifndef ROBERTS_DRAW_POLE_H
#define ROBERTS_DRAW_POLE_H

#include "roberts.h"

/* A point within a region, and how far its border is; model units of the picture. */
typedef struct pole {
    roberts_vec2 at;
    double distance;
} pole;

/* The pole of inaccessibility, to about a hundredth of the region's size. */
pole pole_find(const roberts_region_list *list, const roberts_region *region);

#endif
