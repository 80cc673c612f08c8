/* weld.c - vertices at the same position become one.
 *
 * Idea: the vertices are dealt into as many buckets as there are vertices, by a hash of their position, and each bucket is
 * sorted. Nearly all buckets hold one position, so that the time is linear; whatever the positions, it is at most
 * n log n. */
#include "model/weld.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/sort.h"
#include "base/vec.h"

enum { SHORT_BUCKET = 16 };

typedef struct spot {
    roberts_vec3 at;
    uint32_t vertex;
} spot;

static int compare_spots(const void *a, const void *b)
{
    const spot *p = a, *q = b;
    int order = vec3_compare(p->at, q->at);
    if (order)
        return order;
    return (p->vertex > q->vertex) - (p->vertex < q->vertex);
}

static uint64_t mix(uint64_t hash, double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15u; /* 2^64 over the golden ratio: spreads low bits upward */
    return hash ^ hash >> 29;
}

static uint32_t bucket_of(roberts_vec3 p, uint32_t buckets)
{
    return (uint32_t)((mix(mix(mix(0, p.x), p.y), p.z) >> 32) * buckets >> 32);
}

static void sort_bucket(spot *first, uint32_t count)
{
    if (count > SHORT_BUCKET) {
        qsort(first, count, sizeof *first, compare_spots);
        return;
    }
    SORT_FEW(spot, first, count, compare_spots(a, b) > 0)
}

/* Deals the vertices; end[b] becomes the end of bucket b. */
static void deal(spot *sorted, uint32_t *end, const uint32_t *listed, uint32_t count, const roberts_vec3 *point)
{
    uint32_t sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        roberts_vec3 p = point[listed[i]];
        end[bucket_of((roberts_vec3){p.x + 0.0, p.y + 0.0, p.z + 0.0}, count)]++;
    }
    for (uint32_t b = 0; b < count; b++) {
        uint32_t here = end[b];
        end[b] = sum;
        sum += here;
    }
    for (uint32_t i = 0; i < count; i++) {
        roberts_vec3 p = point[listed[i]], at = {p.x + 0.0, p.y + 0.0, p.z + 0.0}; /* -0 + 0 is +0 */
        uint32_t b = bucket_of(at, count);
        sorted[end[b]++] = (spot){at, listed[i]};
    }
}

bool weld_vertices(uint32_t *name, const uint32_t *listed, uint32_t count, const roberts_vec3 *point)
{
    spot *sorted = alloc_array(count, sizeof *sorted);
    uint32_t *end = alloc_zeroed(count, sizeof *end);
    bool enough = sorted && end;
    if (enough) {
        deal(sorted, end, listed, count, point);
        for (uint32_t b = 0; b < count; b++)
            sort_bucket(sorted + (b ? end[b - 1] : 0), end[b] - (b ? end[b - 1] : 0));
        for (uint32_t i = 0; i < count; i++) {
            bool same = i > 0 && sorted[i].at.x == sorted[i - 1].at.x && sorted[i].at.y == sorted[i - 1].at.y &&
                        sorted[i].at.z == sorted[i - 1].at.z;
            name[sorted[i].vertex] = same ? name[sorted[i - 1].vertex] : sorted[i].vertex;
        }
    }
    free(sorted);
    free(end);
    return enough;
}
