/* region_table.h - visible regions as a table in JSON or CSV. */
#ifndef ROBERTS_DRAW_REGION_TABLE_H
#define ROBERTS_DRAW_REGION_TABLE_H

#include "draw/output.h"

/* Write one object or one row for each region. All numbers are finite. The caller finishes `out`. */
void region_table_write_json(const roberts_region_list *regions, output *out);
void region_table_write_csv(const roberts_region_list *regions, output *out);

#endif
