/* span.h - boxes of view points, first as they are and then rounded outward. */
#ifndef ROBERTS_HIDE_SPAN_H
#define ROBERTS_HIDE_SPAN_H

#include "base/lanes.h"
#include "hide/space.h"

/* A box of view points as they are; one of none is empty. */
typedef struct span {
    roberts_vec3 low, high;
} span;

static const span empty_span = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static inline void span_widen(span *s, roberts_vec3 p)
{
    s->low = (roberts_vec3){lesser(s->low.x, p.x), lesser(s->low.y, p.y), lesser(s->low.z, p.z)};
    s->high = (roberts_vec3){greater(s->high.x, p.x), greater(s->high.y, p.y), greater(s->high.z, p.z)};
}

/* The same of several points, x and y side by side. */
static inline void span_widen_all(span *s, const roberts_vec3 *P, uint32_t count)
{
    two low = two_of(s->low.x, s->low.y), high = two_of(s->high.x, s->high.y);
    for (uint32_t i = 0; i < count; i++) {
        two xy = two_of(P[i].x, P[i].y);
        low = two_lesser(low, xy);
        high = two_greater(high, xy);
        s->low.z = lesser(s->low.z, P[i].z);
        s->high.z = greater(s->high.z, P[i].z);
    }
    two_part(&s->low.x, &s->low.y, low);
    two_part(&s->high.x, &s->high.y, high);
}

static inline hide_box span_box(const span *s)
{
    if (s->low.x > s->high.x)
        return (hide_box){INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY};
    return (hide_box){hide_float_below(s->low.x),  hide_float_above(s->high.x), hide_float_below(s->low.y),
                      hide_float_above(s->high.y), hide_float_below(s->low.z),  hide_float_above(s->high.z)};
}

#endif
