/* region_table.h - visible regions as a table in JSON. */
#ifndef ROBERTS_DRAW_REGION_TABLE_H
#define ROBERTS_DRAW_REGION_TABLE_H

#include "draw/output.h"

/* Writes an array with one object for each region. All numbers are finite. The caller finishes `out`. */
void region_table_write(const roberts_region_list *regions, output *out);

#endif
