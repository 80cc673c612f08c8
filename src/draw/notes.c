/* notes.c - text on a page beside the drawing. */
#include "draw/notes.h"

#include <stdlib.h>
#include <string.h>

#include "base/angle.h"
#include "base/array.h"

bool notes_add_text(notes *n, const text_line *line)
{
    const size_t size = strlen(line->text) + 1;
    if (!array_reserve(&n->item, &n->room, n->count + 1, sizeof *n->item) ||
        !array_reserve(&n->chars, &n->char_room, n->char_count + size, 1))
        return false;
    memcpy(n->chars + n->char_count, line->text, size);
    n->item[n->count++] = (note){.text = n->char_count,
                                 .at = line->at,
                                 .height_mm = line->height_mm,
                                 .align = line->align,
                                 .along = line->along};
    n->char_count += size;
    return true;
}

bool notes_add_label(notes *n, const text_line *line, const roberts_name *of, bool is_back)
{
    if (!notes_add_text(n, line))
        return false;
    n->item[n->count - 1].is_back = is_back;
    n->item[n->count - 1].of = *of;
    return true;
}

/* Does the line from a to b hold p? */
static bool holds_point(page_point a, page_point b, page_point p)
{
    const double x = (double)b.x - a.x, y = (double)b.y - a.y, u = (double)p.x - a.x, v = (double)p.y - a.y;
    const double length = page_distance(a, b), along = x * u + y * v;
    return fabs(x * v - y * u) <= PIECE_TOUCH * length && along >= -PIECE_TOUCH * length &&
           along <= (length + PIECE_TOUCH) * length;
}

/* Finds a line that holds the line from p to q, or that this line holds; such a one is lengthened. False: there is
 * none. */
static bool join_line(notes *n, page_point p, page_point q)
{
    for (size_t i = 0; i < n->lines.count; i++) {
        const polyline *line = &n->lines.item[i];
        page_point *a = &n->lines.point[line->first], *b = a + 1;
        if (line->count != 2)
            continue;
        if (holds_point(*a, *b, p) && holds_point(*a, *b, q))
            return true;
        if (holds_point(p, q, *a) && holds_point(p, q, *b)) {
            *a = p;
            *b = q;
            return true;
        }
    }
    return false;
}

bool notes_add_line(notes *n, roberts_vec2 a, roberts_vec2 b, double units_per_mm)
{
    const page_point p = page_from_mm(a, units_per_mm), q = page_from_mm(b, units_per_mm);
    if ((p.x == q.x && p.y == q.y) || join_line(n, p, q))
        return true;
    return polylines_start(&n->lines) && polylines_append(&n->lines, p) && polylines_append(&n->lines, q);
}

bool notes_add_dot(notes *n, roberts_vec2 at, double radius_mm, double units_per_mm)
{
    enum { CORNERS = 8 };
    bool done = polylines_start(&n->lines);
    for (int i = 0; i < CORNERS && done; i++) {
        const roberts_vec2 d = angle_unit(360.0 / CORNERS * i);
        const roberts_vec2 p = {at.x + radius_mm * d.x, at.y + radius_mm * d.y};
        done = polylines_append(&n->lines, page_from_mm(p, units_per_mm));
    }
    if (done)
        n->lines.item[n->lines.count - 1].closed = true;
    return done;
}

bool notes_add_box(notes *n, roberts_vec2 a, roberts_vec2 b, double units_per_mm)
{
    const roberts_vec2 corner[4] = {a, {b.x, a.y}, b, {a.x, b.y}};
    bool done = polylines_start(&n->lines);
    for (int i = 0; i < 4 && done; i++)
        done = polylines_append(&n->lines, page_from_mm(corner[i], units_per_mm));
    if (done)
        n->lines.item[n->lines.count - 1].closed = true;
    return done;
}

text_line notes_line(const notes *n, size_t i)
{
    const note *from = &n->item[i];
    return (text_line){n->chars + from->text, from->at, from->height_mm, from->align, from->along};
}

bool notes_draw(const notes *n, bool is_back, bool native, double units_per_mm, polylines *out)
{
    if (!is_back && !polylines_copy(&n->lines, 0, n->lines.count, out))
        return false;
    for (size_t i = 0; i < n->count && !native; i++) {
        const text_line line = notes_line(n, i);
        if (n->item[i].is_back == is_back && !letters_draw(&line, units_per_mm, out))
            return false;
    }
    return true;
}

void notes_free(notes *n)
{
    free(n->chars);
    free(n->item);
    polylines_free(&n->lines);
    *n = (notes){0};
}
