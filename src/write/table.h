/* table.h - segments and visible regions as tables: CSV and JSON. */
#ifndef ROBERTS_WRITE_TABLE_H
#define ROBERTS_WRITE_TABLE_H

#include "base/output.h"

/* A drawing, and its name if it is one view of several: then the table's first column is `view`. Otherwise NULL. */
typedef struct table_view {
    const roberts_drawing *drawing;
    const char *name;
} table_view;

/* Writes one row per segment, view by view, in the order of each drawing; only visible segments, unless hidden ones are
 * wanted. Of `options` only the scene, the further columns and `hidden` count; they have been checked. The caller
 * finishes `out`. */
void table_write_csv(const table_view *view, size_t count, const roberts_draw_options *options, output *out);
void table_write_json(const table_view *view, size_t count, const roberts_draw_options *options, output *out);

/* ---- visible regions --------------------------------------------------------------------------------------------- */

/* Write one object or one row for each region. All numbers are finite. The caller finishes `out`. */
void region_table_write_json(const roberts_region_list *regions, output *out);
void region_table_write_csv(const roberts_region_list *regions, output *out);

#endif
