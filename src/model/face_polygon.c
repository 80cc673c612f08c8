/* face_polygon.c - whether a face is a convex simple polygon.
 *
 * Nearly all faces are strictly convex and are told by signs alone. The rest (corners in a line, coordinates rounded to
 * few digits, pentagrams, concave faces) is measured against the convex hull of the corners, found by the monotone
 * chain. Source: A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information
 * Processing Letters 9(5), 1979. */
#include "model/face_polygon.h"

#include <stdlib.h>

#include "base/array.h"

/* The polygon along the coordinate axis nearest to its normal: which axis, and whether it is seen from its end. */
static roberts_vec2 drop(roberts_vec3 p, int axis)
{
    return axis == 0 ? (roberts_vec2){p.y, p.z} : axis == 1 ? (roberts_vec2){p.z, p.x} : (roberts_vec2){p.x, p.y};
}

bool polygon_strictly_convex(const roberts_vec3 *corner, uint32_t count, roberts_vec3 n)
{
    double x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    int axis = x > y && x > z ? 0 : y > z ? 1 : 2;
    double sign = (axis == 0 ? n.x : axis == 1 ? n.y : n.z) < 0.0 ? -1.0 : 1.0;
    roberts_vec2 b = drop(corner[count - 1], axis), a = drop(corner[count - 2], axis);
    double ex = b.x - a.x, ey = b.y - a.y;
    bool rising = ey > 0.0 || (ey == 0.0 && ex > 0.0);
    unsigned starts = 0; /* sides where the direction comes into the upper half-plane: once for each turn */
    for (uint32_t i = 0; i < count; i++) {
        roberts_vec2 c = drop(corner[i], axis);
        double fx = c.x - b.x, fy = c.y - b.y;
        bool up = fy > 0.0 || (fy == 0.0 && fx > 0.0);
        if (!(sign * (ex * fy - ey * fx) > 0.0))
            return false;
        starts += up && !rising;
        rising = up;
        ex = fx;
        ey = fy;
        b = c;
    }
    return starts == 1;
}

typedef struct spot {
    double x, y;
    uint32_t at; /* corner */
} spot;

static int compare_spots(const void *a, const void *b)
{
    const spot *p = a, *q = b;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    if (p->y != q->y)
        return p->y < q->y ? -1 : 1;
    return (p->at > q->at) - (p->at < q->at);
}

/* > 0 where a, b, c turn left. */
static double turn(spot a, spot b, spot c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* Convex hull of the sorted spots, counter-clockwise, without corners in a line; hull has room for count + 1. */
static uint32_t monotone_chain(const spot *sorted, uint32_t count, spot *hull)
{
    uint32_t size = 0, lower;
    for (uint32_t i = 0; i < count; i++) {
        while (size >= 2 && turn(hull[size - 2], hull[size - 1], sorted[i]) <= 0.0)
            size--;
        hull[size++] = sorted[i];
    }
    lower = size + 1;
    for (uint32_t i = count - 1; i-- > 0;) {
        while (size >= lower && turn(hull[size - 2], hull[size - 1], sorted[i]) <= 0.0)
            size--;
        hull[size++] = sorted[i];
    }
    return size - 1; /* the last one is the first again */
}

static double distance(spot a, spot b)
{
    return hypot(b.x - a.x, b.y - a.y);
}

/* Walks the corners from hull[0] on: each is the hull's next vertex (or one after it, where those between are no farther
 * away than `allowed`), or lies beside the side that the walk is on, and there not behind where the walk already was. */
static double walk(const spot *polygon, uint32_t count, const spot *hull, uint32_t size, const uint32_t *rank,
                   double allowed, uint32_t *deepest)
{
    double dent = 0.0, reached = 0.0;
    uint32_t side = 0;
    for (uint32_t k = 1; k < count; k++) {
        spot c = polygon[(hull[0].at + (size_t)k) % count], a = hull[side], b = hull[side + 1];
        if (rank[c.at] != ROBERTS_NONE && rank[c.at] > side) {
            for (side++; side < rank[c.at]; side++)
                if (distance(hull[side], c) > allowed)
                    return INFINITY;
            reached = 0.0;
            continue;
        }
        double length = distance(a, b), depth = turn(a, b, c) / length;
        double along = ((c.x - a.x) * (b.x - a.x) + (c.y - a.y) * (b.y - a.y)) / length;
        if (depth > dent) {
            dent = depth;
            *deepest = c.at;
        }
        if (depth > allowed)
            continue; /* it may well turn back in there */
        if (along < reached - allowed)
            return INFINITY;
        reached = fmax(reached, along);
    }
    for (side++; side < size; side++)
        if (distance(hull[side], hull[0]) > allowed)
            return INFINITY;
    return dent;
}

double polygon_dent(const roberts_vec3 *corner, uint32_t count, roberts_vec3 n, double allowed, uint32_t *deepest)
{
    spot *polygon = alloc_array(count, sizeof *polygon), *sorted = alloc_array(count, sizeof *sorted);
    spot *hull = alloc_array((size_t)count + 1, sizeof *hull);
    uint32_t *rank = alloc_array(count, sizeof *rank), size; /* place in the hull, or ROBERTS_NONE */
    double dent = -1.0;
    if (polygon && sorted && hull && rank) {
        roberts_vec3 u = vec3_cross(fabs(n.x) < 0.6 ? (roberts_vec3){1, 0, 0} : (roberts_vec3){0, 1, 0}, n), v;
        u = vec3_scale(1.0 / vec3_length(u), u);
        v = vec3_cross(n, u);
        for (uint32_t i = 0; i < count; i++) {
            roberts_vec3 p = vec3_sub(corner[i], corner[0]);
            polygon[i] = sorted[i] = (spot){vec3_dot(u, p), vec3_dot(v, p), i};
            rank[i] = ROBERTS_NONE;
        }
        qsort(sorted, count, sizeof *sorted, compare_spots);
        size = monotone_chain(sorted, count, hull);
        for (uint32_t i = 0; i < size; i++)
            rank[hull[i].at] = i;
        dent = size < 3 ? 0.0 : walk(polygon, count, hull, size, rank, allowed, deepest);
    }
    free(polygon);
    free(sorted);
    free(hull);
    free(rank);
    return dent;
}

double polygon_spread(const roberts_vec3 *corner, uint32_t count)
{
    roberts_vec3 chord = {0, 0, 0};
    double squared = 0.0, greatest = 0.0;
    for (uint32_t i = 1; i < count; i++) {
        roberts_vec3 d = vec3_sub(corner[i], corner[0]);
        if (vec3_dot(d, d) > squared) {
            squared = vec3_dot(d, d);
            chord = d;
        }
    }
    for (uint32_t i = 1; i < count && squared > 0.0; i++)
        greatest = fmax(greatest, vec3_length(vec3_cross(chord, vec3_sub(corner[i], corner[0]))) / sqrt(squared));
    return greatest;
}
