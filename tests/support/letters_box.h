/* letters_box.h - the box round a line of letters. */
#ifndef ROBERTS_TESTS_LETTERS_BOX_H
#define ROBERTS_TESTS_LETTERS_BOX_H

#include <math.h>

#include "draw/free_space.h"
#include "draw/letters.h"
#include "testing.h"

/* Returns the box of the strokes alone, without the space around them, mm. */
static inline space_box letters_box(text_line line)
{
    polylines out = {0};
    space_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    assert_true(letters_draw(&line, 1000.0, &out));
    for (size_t k = 0; k < out.point_count; k++) {
        box.min = (roberts_vec2){fmin(box.min.x, out.point[k].x / 1000.0), fmin(box.min.y, out.point[k].y / 1000.0)};
        box.max = (roberts_vec2){fmax(box.max.x, out.point[k].x / 1000.0), fmax(box.max.y, out.point[k].y / 1000.0)};
    }
    polylines_free(&out);
    return box;
}

static inline bool is_apart(space_box a, space_box b)
{
    return a.max.x < b.min.x || b.max.x < a.min.x || a.max.y < b.min.y || b.max.y < a.min.y;
}

#endif
