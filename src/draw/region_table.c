/* region_table.c - visible regions as JSON: an array with one object, on a line of its own, for each face that is seen.
 *
 * Numbers have 17 significant digits, as in the tables of segments. `face` is null for a face that the input does not
 * have, and `color` where the input gives none. */
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

void region_table_write(const roberts_region_list *regions, output *out)
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
