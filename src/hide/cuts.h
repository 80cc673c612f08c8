/* cuts.h - the lines along which the near plane cuts bodies: the outlines of caps, and the borders of what is left of
 * open bodies. Nothing is nearer, so all of them are seen. (Those of a section that is seen edge-on lie on one line of
 * the picture, where some lie behind others.) They are no edges. */
#ifndef ROBERTS_HIDE_CUTS_H
#define ROBERTS_HIDE_CUTS_H

#include "hide/fronts.h"

/* Finds the lines, body by body; of culled bodies none. The scene is clipped. Call cuts_free() in any case. False: no
 * memory. */
bool cuts_find(const hide_fronts *fronts, seen_further *lines);
void cuts_free(seen_further *lines);

/* Appends them to the drawing's segments, as roberts_drawing.cut_count says. unite: all bodies are drawn as one. False:
 * no memory. */
bool cuts_draw(const hide_fronts *fronts, const seen_further *lines, bool unite, roberts_drawing *drawing);

#endif
