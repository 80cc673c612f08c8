/* off_color.c - what the numbers of a colour mean.
 *
 * Three or four integers are 0..255; other numbers are 0..1, unless one of them is greater than 1, as in "255.0 0.0
 * 0.0": then they are 0..255 too (Geomview's rule). One integer is an index into a colour map. */
#include "model/off.h"

#include <math.h>

static bool make_color(const off_color_numbers *numbers, roberts_color *color)
{
    int count = numbers->count;
    double most = numbers->real ? 1.0 : 255.0;
    if (count != 1 && count != 3 && count != 4)
        return false;
    *color = (roberts_color){.count = (unsigned char)count};
    for (int i = 0; i < count; i++) {
        double v = numbers->value[i];
        if (!(v >= 0.0) || (count == 1 ? v != floor(v) || v > UINT32_MAX : v > 255.0))
            return false;
        if (v > most)
            most = 255.0;
    }
    for (int i = 0; i < count; i++)
        color->value[i] = (float)(count == 1 ? numbers->value[i] : numbers->value[i] / most);
    return true;
}

static roberts_status odd(off_reader *r)
{
    if (r->odd_colors++ == 0)
        r->first_odd_color = r->header.binary ? 0 : r->in.line;
    return ROBERTS_OK;
}

roberts_status off_color_vertex(off_reader *r, const off_color_numbers *numbers)
{
    roberts_color color;
    if (!make_color(numbers, &color))
        return odd(r);
    if (!mesh_color_vertex(r->mesh, r->mesh->vertex_count - 1, color, &r->vertices_filled))
        return error_no_memory(r->error);
    return ROBERTS_OK;
}

roberts_status off_color_face(off_reader *r, const off_color_numbers *numbers)
{
    roberts_color color;
    if (!make_color(numbers, &color))
        return odd(r);
    if (!mesh_color_face(r->mesh, r->mesh->face_count - 1, color, &r->faces_filled))
        return error_no_memory(r->error);
    return ROBERTS_OK;
}
