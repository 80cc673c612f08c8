/* span.h - boxes of view points, first as they are and then rounded outward. */
#ifndef ROBERTS_HIDE_SPAN_H
#define ROBERTS_HIDE_SPAN_H

#include "base/box.h"
#include "hide/space.h"

/* A box of view points as they are; one of none is empty. */
typedef struct span {
    roberts_vec3 low, high;
} span;

static const span empty_span = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static inline hide_box span_box(const span *s)
{
    if (s->low.x > s->high.x)
        return (hide_box){INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY};
    return (hide_box){hide_float_below(s->low.x),  hide_float_above(s->high.x), hide_float_below(s->low.y),
                      hide_float_above(s->high.y), hide_float_below(s->low.z),  hide_float_above(s->high.z)};
}

#endif
