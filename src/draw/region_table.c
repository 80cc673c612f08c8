/* region_table.c - visible regions as JSON, an array with one object, on a line of its own, for each face that is seen;
 * or as CSV with one row for each, whose polygon is well-known text (ISO 19125-1).
 *
 * Numbers have 17 significant digits, as in the tables of segments. `face` is null or empty for a face that the input
 * does not have, and `color` where the input gives none. */
#include "draw/region_table.h"

static void write_point(roberts_vec2 p, output *out)
{
    output_text(out, "[");
    output_number(out, p.x);
    output_text(out, ",");
    output_number(out, p.y);
    output_text(out, "]");
}

static void write_member(const char *name, double value, output *out)
{
    output_text(out, name);
    output_number(out, value);
}

/* One number is an index into a colour map, three or four are red, green, blue and alpha. */
static void write_color(const roberts_color *color, output *out)
{
    output_text(out, color->count ? ",\"color\":[" : ",\"color\":null");
    for (int i = 0; i < color->count; i++) {
        output_text(out, i ? "," : "");
        output_number(out, (double)color->value[i]);
    }
    output_text(out, color->count ? "]" : "");
}

static void write_rings(const roberts_region_list *regions, const roberts_region *r, output *out)
{
    output_text(out, ",\"rings\":[");
    for (size_t k = r->first_ring; k < r->first_ring + r->ring_count; k++) {
        output_text(out, k > r->first_ring ? ",[" : "[");
        for (size_t c = regions->ring_start[k]; c < regions->ring_start[k + 1]; c++) {
            output_text(out, c > regions->ring_start[k] ? "," : "");
            write_point(regions->corner[c], out);
        }
        output_text(out, "]");
    }
    output_text(out, "]}");
}

void region_table_write_json(const roberts_region_list *regions, output *out)
{
    output_text(out, "[");
    for (size_t i = 0; i < regions->count; i++) {
        const roberts_region *r = &regions->region[i];
        output_text(out, i ? ",\n{\"body\":" : "\n{\"body\":");
        output_integer(out, r->solid);
        output_text(out, ",\"face\":");
        if (r->face == ROBERTS_NONE)
            output_text(out, "null");
        else
            output_integer(out, r->face);
        write_member(",\"area\":", r->area, out);
        write_member(",\"z0\":", r->z_min, out);
        write_member(",\"z1\":", r->z_max, out);
        write_color(&r->color, out);
        write_rings(regions, r, out);
    }
    output_text(out, "\n]\n");
}

/* ---- CSV ---- */

/* A ring of well-known text ends with its first corner. */
static void write_text_ring(const roberts_region_list *regions, size_t ring, output *out)
{
    const size_t first = regions->ring_start[ring], count = regions->ring_start[ring + 1] - first;
    output_text(out, "(");
    for (size_t k = 0; k <= count; k++) {
        const roberts_vec2 p = regions->corner[first + (k < count ? k : 0)];
        output_text(out, k > 0 ? "," : "");
        output_number(out, p.x);
        output_text(out, " ");
        output_number(out, p.y);
    }
    output_text(out, ")");
}

/* Whether a ring bounds a piece, and not a hole in the piece before: its area is then > 0. */
static bool is_piece(const roberts_region_list *regions, size_t ring)
{
    const size_t first = regions->ring_start[ring], end = regions->ring_start[ring + 1];
    const roberts_vec2 o = regions->corner[first];
    double sum = 0.0;
    for (size_t k = first; k + 1 < end; k++) {
        const roberts_vec2 p = regions->corner[k], q = regions->corner[k + 1];
        sum += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
    }
    return sum > 0.0;
}

static void write_polygon(const roberts_region_list *regions, const roberts_region *r, output *out)
{
    output_text(out, "\"MULTIPOLYGON (");
    for (size_t i = 0; i < r->ring_count; i++) {
        const bool piece = i == 0 || is_piece(regions, r->first_ring + i);
        if (i > 0)
            output_text(out, piece ? ")," : ",");
        if (piece)
            output_text(out, "(");
        write_text_ring(regions, r->first_ring + i, out);
    }
    output_text(out, "))\"\n");
}

static void write_field(double value, output *out)
{
    output_text(out, ",");
    output_number(out, value);
}

void region_table_write_csv(const roberts_region_list *regions, output *out)
{
    output_text(out, "body,face,area,z0,z1,color,polygon\n");
    for (size_t i = 0; i < regions->count; i++) {
        const roberts_region *r = &regions->region[i];
        output_integer(out, r->solid);
        output_text(out, ",");
        if (r->face != ROBERTS_NONE)
            output_integer(out, r->face);
        write_field(r->area, out);
        write_field(r->z_min, out);
        write_field(r->z_max, out);
        for (int k = 0; k < r->color.count; k++) {
            output_text(out, k == 0 ? "," : " ");
            output_number(out, (double)r->color.value[k]);
        }
        output_text(out, r->color.count ? "," : ",,");
        write_polygon(regions, r, out);
    }
}
