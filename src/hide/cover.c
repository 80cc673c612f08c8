/* cover.c - see cover.h. */
#include "hide/cover.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"

bool cover_init(cover *c, roberts_vec2 low, roberts_vec2 high, uint32_t n, double margin)
{
    *c = (cover){0};
    if (n == 0)
        return true;
    c->frame = scan_frame_over(low, high, n, margin);
    c->depth = alloc_array((size_t)n * n, sizeof *c->depth);
    if (!c->depth || !scan_init(&c->scan, n))
        return false;
    for (size_t i = 0; i < (size_t)n * n; i++)
        c->depth[i] = -INFINITY;
    return true;
}

void cover_free(cover *c)
{
    free(c->depth);
    scan_free(&c->scan);
    *c = (cover){0};
}

/* Least depth of the faces' planes over the cell. Each is least in one corner; c < 0, z = (a x + b y + d) / -c. */
static double depth_over(const scan_frame *f, uint32_t i, uint32_t j, const hide_face *face, uint32_t face_count)
{
    double least = INFINITY;
    for (uint32_t k = 0; k < face_count; k++) {
        plane F = face[k].F;
        double x = f->x0 + (F.a > 0.0 ? i : i + 1) * f->dx, y = f->y0 + (F.b > 0.0 ? j : j + 1) * f->dy;
        least = lesser(least, (F.a * x + F.b * y + F.d) / -F.c);
    }
    return least;
}

void cover_add(cover *c, const roberts_vec3 *P, const uint32_t *corner, uint32_t count, double depth,
               const hide_face *face, uint32_t face_count, double slack)
{
    const scan_frame *f = &c->frame;
    if (!c->depth)
        return;
    scan_polygon(&c->scan, f, P, corner, count);
    for (uint32_t i = c->scan.inner_first; i <= c->scan.inner_last; i++) {
        uint32_t first, last;
        float *cell = c->depth + (size_t)i * f->n;
        if (!scan_inside(&c->scan, f, i, &first, &last))
            continue;
        for (uint32_t j = first; j <= last; j++) {
            double at = face_count ? greater(depth, depth_over(f, i, j, face, face_count)) : depth;
            float bound = hide_float_below(at - slack);
            if (bound > cell[j])
                cell[j] = bound;
        }
    }
}

bool cover_hides(const cover *c, const hide_box *box)
{
    const scan_frame *f = &c->frame;
    if (!c->depth)
        return false;
    double m = f->margin;
    uint32_t last = scan_column(f, (double)box->x1 + m);
    uint32_t low = scan_row(f, (double)box->y0 - m), high = scan_row(f, (double)box->y1 + m);
    for (uint32_t i = scan_column(f, (double)box->x0 - m); i <= last; i++) {
        const float *cell = c->depth + (size_t)i * f->n;
        for (uint32_t j = low; j <= high; j++)
            if (!(cell[j] > box->z1))
                return false;
    }
    return true;
}
