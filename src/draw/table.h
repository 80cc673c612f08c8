/* table.h - segments as tables: CSV and JSON. */
#ifndef ROBERTS_DRAW_TABLE_H
#define ROBERTS_DRAW_TABLE_H

#include "draw/output.h"

/* Writes one row per segment, in the drawing's order; only visible segments, unless hidden ones are wanted. Of
 * `options` only the scene, the further columns and `hidden` count; they have been checked. The caller finishes `out`.
 */
void table_write_csv(const roberts_drawing *drawing, const roberts_draw_options *options, output *out);
void table_write_json(const roberts_drawing *drawing, const roberts_draw_options *options, output *out);

#endif
