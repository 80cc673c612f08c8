/* outline.c - the outline of a solid in the picture. See outline.h. */
#include "hide/outline.h"

#include <math.h>

#include "hide/refine.h"

/* On a very small or flat solid, faces may count as edge-on within epsilon. Then the edges need not form one cycle. */
uint32_t outline_cycle(const hide_fronts *fronts, uint32_t solid, uint32_t *next, uint32_t *outline)
{
    const scene_solid *own = &fronts->scene->solid[solid];
    const scene_edge *e = fronts->scene->edge + own->stored, *end = e + (own[1].edge - own->edge);
    const unsigned char *facing = fronts->seen->facing + own->face;
    uint32_t edges = 0, start = ROBERTS_NONE, count = 0, size = own[1].vertex - own->vertex;
    for (uint32_t v = 0; v < size; v++)
        next[v] = ROBERTS_NONE;
    for (; e < end; e++) {
        bool left = facing[e->f[0]] == VIEW_FRONT;
        if (left == (facing[e->f[1]] == VIEW_FRONT))
            continue;
        start = e->v[!left]; /* v[0] -> v[1] runs counter-clockwise round f[0] */
        if (next[start] != ROBERTS_NONE)
            return 0;
        next[start] = e->v[left];
        edges++;
    }
    if (edges < 3)
        return 0;
    uint32_t v = start;
    do {
        outline[count++] = v + own->vertex;
        v = next[v];
    } while (v != start && v != ROBERTS_NONE && count < edges);
    return v == start && count == edges ? edges : 0;
}

/* Returns the longer of a side's two components. The length is at most sqrt(2) times as much. */
static double span_of(roberts_vec3 side)
{
    return greater(fabs(side.x), fabs(side.y));
}

/* Does the outline turn left at corner b or go straight on? Decided in double-double numbers. An inward turn counts as
 * straight if the lines of both sides cut off at most half an epsilon from a front of this size. A turn straight back
 * fails, and so does a turn after a side of zero length. */
static BITS_RARE bool turns_left(const hide_fronts *fronts, uint32_t a, uint32_t b, uint32_t c, double size)
{
    const roberts_vec3 *P = fronts->P;
    roberts_vec3 AB = vec3_sub(P[b], P[a]), BC = vec3_sub(P[c], P[b]);
    double left = refine_side(&fronts->space, a, b, refine_vertex(&fronts->space, c)); /* NaN if AB has zero length */
    if (AB.x * BC.x + AB.y * BC.y <= 0.0)
        return left > 0.0;
    return left >= -INWARD_TURN * fronts->seen->view.epsilon / size * span_of(BC);
}

/* Tests 2 to 4 need a convex polygon. They take the inside as the inner side of every side's line, so a single side in
 * a wrong direction may cut off the whole front. A polygon is convex if it turns left or goes straight on at each
 * corner, and goes round once. It goes round once if exactly one corner joins a side that does not rise to one that
 * rises. */
bool outline_is_convex(const hide_fronts *fronts, const uint32_t *outline, uint32_t corners, double size)
{
    const double plain =
        TURN_ROUNDINGS * fronts->seen->view.across_rounding * size; /* bounds the error of a product of two sides */
    int rounds = 0;
    if (corners < 3)
        return false;
    uint32_t a = outline[corners - 2], b = outline[corners - 1];
    roberts_vec3 AB = vec3_sub(fronts->P[b], fronts->P[a]);
    for (uint32_t i = 0; i < corners; i++) {
        uint32_t c = outline[i];
        roberts_vec3 BC = vec3_sub(fronts->P[c], fronts->P[b]);
        double left = AB.x * BC.y - AB.y * BC.x;
        if (left <= plain && !turns_left(fronts, a, b, c, size))
            return false;
        if (left >= 0.0 || AB.x * BC.x + AB.y * BC.y <= 0.0)
            rounds += AB.y <= 0.0 && BC.y > 0.0;
        else /* straight on, slightly to the right because of rounding */
            rounds -= AB.y > 0.0 && BC.y <= 0.0;
        a = b;
        b = c;
        AB = BC;
    }
    return rounds == 1;
}

/* Orders vertices by x, then by y; of several at one place, the nearest first. */
static bool comes_before(const hide_fronts *fronts, uint32_t a, uint32_t b)
{
    roberts_vec3 A = fronts->P[a], B = fronts->P[b];
    if (A.x != B.x)
        return A.x < B.x;
    if (A.y != B.y)
        return A.y < B.y;
    return A.z != B.z ? A.z > B.z : a < b;
}

/* Restores the heap item[0 .. count - 1], whose root is the vertex that comes last, if only item[root] is out of
 * place. */
static void sift(const hide_fronts *fronts, uint32_t *item, uint32_t root, uint32_t count)
{
    for (uint32_t child; (child = 2 * root + 1) < count; root = child) {
        if (child + 1 < count && comes_before(fronts, item[child], item[child + 1]))
            child++;
        if (!comes_before(fronts, item[root], item[child]))
            return;
        uint32_t moved = item[root];
        item[root] = item[child];
        item[child] = moved;
    }
}

static void sort(const hide_fronts *fronts, uint32_t *item, uint32_t count)
{
    for (uint32_t i = count / 2; i-- > 0;)
        sift(fronts, item, i, count);
    for (uint32_t end = count; end-- > 1;) {
        uint32_t last = item[0];
        item[0] = item[end];
        item[end] = last;
        sift(fronts, item, 0, end);
    }
}

/* Does the path a, b, c certainly turn left? If rounding could turn it right, b does not count as a corner. */
static bool is_left_turn(const hide_fronts *fronts, uint32_t a, uint32_t b, uint32_t c)
{
    const roberts_vec3 *P = fronts->P;
    roberts_vec3 AB = vec3_sub(P[b], P[a]), AC = vec3_sub(P[c], P[a]);
    return AB.x * AC.y - AB.y * AC.x > TURN_ROUNDINGS * fronts->seen->view.across_rounding * hypot(AC.x, AC.y);
}

/* Drops the last corners of a chain at which the path to c does not turn left. The first `kept` corners stay. */
static uint32_t drop_corners(const hide_fronts *fronts, const uint32_t *chain, uint32_t count, uint32_t kept,
                             uint32_t c)
{
    while (count > kept && !is_left_turn(fronts, chain[count - 2], chain[count - 1], c))
        count--;
    return count;
}

/* Andrew's monotone chain: from the first point to the last and back, along the corners below and above the line
 * between them. A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information Processing
 * Letters 9(5), 1979. */
uint32_t outline_hull(const hide_fronts *fronts, uint32_t solid, uint32_t *order, uint32_t *outline)
{
    const scene_solid *own = &fronts->scene->solid[solid];
    uint32_t size = own[1].vertex - own->vertex, count = 1;
    for (uint32_t v = 0; v < size; v++)
        order[v] = own->vertex + v;
    sort(fronts, order, size);
    uint32_t first = outline[0] = order[0], last = order[size - 1];
    for (uint32_t i = 1; i < size; i++) {
        count = drop_corners(fronts, outline, count, 1, order[i]);
        outline[count++] = order[i];
    }
    uint32_t below = count;
    for (uint32_t i = size - 1; i-- > 1;) {
        if (!is_left_turn(fronts, first, last, order[i]))
            continue;
        count = drop_corners(fronts, outline, count, below, order[i]);
        if (count == size)
            return 0; /* by rounding, a vertex above the line is also a corner below it */
        outline[count++] = order[i];
    }
    count = drop_corners(fronts, outline, count, below, first);
    return count >= 3 ? count : 0;
}
