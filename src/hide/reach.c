/* reach.c - how far along an edge its hider's border is within epsilon. See reach.h. */
#include "hide/reach.h"

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
