/* table.h - segments as tables: CSV and JSON. */
#ifndef ROBERTS_DRAW_TABLE_H
#define ROBERTS_DRAW_TABLE_H

#include "draw/output.h"

/* Writes one row per segment, in the drawing's order; without `with_hidden` only visible segments. `scene`: of
 * the drawing, or NULL, which leaves f0 and f1 of edges empty. The caller finishes `out`. */
void table_write_csv(const roberts_drawing *drawing, const roberts_scene *scene, bool with_hidden, output *out);
void table_write_json(const roberts_drawing *drawing, const roberts_scene *scene, bool with_hidden, output *out);

#endif
