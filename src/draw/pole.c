/* pole.c - the point of a region that is farthest from its border, by a grid of points that is refined about the best
 * one. That may miss the best point of a region of very many arms, but never leaves the region. */
#include "draw/pole.h"

#include <math.h>

#include "base/vec.h"

enum { GRID = 16, ROUNDS = 5 };

static double segment_distance(roberts_vec2 p, roberts_vec2 a, roberts_vec2 b)
{
    const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    const double t = square > 0.0 ? fmin(fmax(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0), 1.0) : 0.0;
    return hypot(a.x + t * x - p.x, a.y + t * y - p.y);
}

/* How far the border is from p: > 0 within the region (by the parity of crossings), < 0 outside. */
static double depth_of(const roberts_region_list *list, const roberts_region *region, roberts_vec2 p)
{
    double least = INFINITY;
    bool inside = false;
    for (size_t r = region->first_ring; r < region->first_ring + region->ring_count; r++) {
        const size_t start = list->ring_start[r], end = list->ring_start[r + 1];
        for (size_t i = start; i < end; i++) {
            const roberts_vec2 a = list->corner[i], b = list->corner[i + 1 < end ? i + 1 : start];
            least = fmin(least, segment_distance(p, a, b));
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
                inside = !inside;
        }
    }
    return inside ? least : -least;
}

/* Of points that are nearly as far from the border, the one in the middle is the best: in a long strip all are. */
static const double off_middle = 0.2;

static void find_box(const roberts_region_list *list, const roberts_region *region, roberts_vec2 *min,
                     roberts_vec2 *max)
{
    *min = (roberts_vec2){INFINITY, INFINITY};
    *max = (roberts_vec2){-INFINITY, -INFINITY};
    const size_t start = list->ring_start[region->first_ring],
                 end = list->ring_start[region->first_ring + region->ring_count];
    for (size_t i = start; i < end; i++) {
        const roberts_vec2 p = list->corner[i];
        *min = (roberts_vec2){fmin(min->x, p.x), fmin(min->y, p.y)};
        *max = (roberts_vec2){fmax(max->x, p.x), fmax(max->y, p.y)};
    }
}

pole pole_find(const roberts_region_list *list, const roberts_region *region)
{
    roberts_vec2 min, max;
    find_box(list, region, &min, &max);
    pole best = {{min.x / 2.0 + max.x / 2.0, min.y / 2.0 + max.y / 2.0}, -INFINITY};
    const roberts_vec2 middle = best.at;
    roberts_vec2 size = {max.x - min.x, max.y - min.y};
    const double half = hypot(size.x, size.y) / 2.0;
    double most = -INFINITY;
    for (int round = 0; round < ROUNDS; round++) {
        const roberts_vec2 from = {best.at.x - size.x / 2.0, best.at.y - size.y / 2.0};
        for (int i = 0; i < GRID * GRID; i++) {
            const roberts_vec2 p = {from.x + (i % GRID + 0.5) / GRID * size.x,
                                    from.y + (i / GRID + 0.5) / GRID * size.y};
            const double depth = depth_of(list, region, p);
            const double off = half > 0.0 ? hypot(p.x - middle.x, p.y - middle.y) / half : 0.0;
            const double worth = depth > 0.0 ? depth * (1.0 - off_middle * off) : depth;
            if (worth > most) {
                most = worth;
                best = (pole){p, depth};
            }
        }
        size = (roberts_vec2){size.x / 4.0, size.y / 4.0};
    }
    best.distance = fmax(best.distance, 0.0);
    return best;
}
