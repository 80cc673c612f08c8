/* quick.c - see quick.h. */
#include "hide/quick.h"

#include "base/lanes.h"

void quick_take(quick_outline *o, const roberts_vec3 *P, const uint32_t *corner, uint32_t count)
{
    uint32_t last = count - 1;
    o->corner = corner;
    o->count = count;
    for (uint32_t i = 0; i < count; i++) {
        o->x[i] = P[corner[i]].x;
        o->y[i] = P[corner[i]].y;
    }
    o->x[count] = o->x[0];
    o->y[count] = o->y[0];
    for (uint32_t i = 0; i < last; i++) {
        bool second = corner[i] > corner[i + 1];
        o->ox[i] = o->x[i + second];
        o->oy[i] = o->y[i + second];
    }
    o->ox[last] = corner[last] < corner[0] ? o->x[last] : o->x[0];
    o->oy[last] = corner[last] < corner[0] ? o->y[last] : o->y[0];
    for (uint32_t i = 0; i < count; i += 2) {
        two_store(o->dx + i, two_sub(two_load(o->x + i + 1), two_load(o->x + i)));
        two_store(o->dy + i, two_sub(two_load(o->y + i + 1), two_load(o->y + i)));
    }
    if (count % 2) {
        o->ox[count] = o->ox[last];
        o->oy[count] = o->oy[last];
        o->dx[count] = o->dx[last];
        o->dy[count] = o->dy[last];
    }
}

static bool all_above(const double *h, uint32_t count, double least)
{
    for (uint32_t i = 0; i < count; i++)
        if (!(h[i] > least))
            return false;
    return true;
}

/* As look_closely() in tests.c. */
bool quick_settle(const quick_outline *o, const hide_space *space, const hide_edge *e, quick_sides *H)
{
    bool a_inside = all_above(H->a, o->count, space->plain);
    const double *h = a_inside ? H->b : H->a;
    roberts_vec3 X = a_inside ? e->B : e->A;
    uint32_t out = 0;
    if (!a_inside && !all_above(H->b, o->count, space->plain))
        return false;
    for (uint32_t i = 0; i < o->count; i++) {
        double length = sqrt(o->dx[i] * o->dx[i] + o->dy[i] * o->dy[i]), on = space->epsilon * length;
        double error = 2.0 * space->rounding * (length + fabs(X.x - o->ox[i]) + fabs(X.y - o->oy[i]));
        if (length <= space->epsilon)
            continue;
        if (error > HIDE_TRUSTED * on && fabs(h[i]) <= on + error)
            return false;
        out |= (h[i] < -on ? 1u : 0u) << i;
    }
    H->out_a = a_inside ? 0 : out;
    H->out_b = a_inside ? out : 0;
    return true;
}
