/* region_faces.h - what regions take from their faces: colours, directions, which neighbours lie in one plane, and
 * where the near plane cuts. */
#ifndef ROBERTS_HIDE_REGION_FACES_H
#define ROBERTS_HIDE_REGION_FACES_H

#include "hide/fronts.h"
#include "hide/segments.h"
#include "view/seen.h"

/* Faces are those of job->fronts.scene; of several pieces, the first. */

/* The colour of a face in the input. If it has none, the mean colour of its corners, provided that all of them have
 * one. */
roberts_color region_color(const hide_job *job, uint32_t piece);

/* Can the regions of two neighbours become one? The faces must lie in one plane, as far as both are planar, have the
 * same colour, and belong to one body or to bodies drawn as one. */
bool region_can_join(const hide_job *job, uint32_t f, uint32_t g);

/* ---- directions ---- */

/* What points up in the model: +z, or the axis along which the camera's `up` lies. A camera that looks along z has any
 * such `up`, so there it is +z. */
roberts_vec3 slope_upright(const roberts_camera *camera);

/* Fills the normal, steep, level and foot of a region of scene face `face`. upright: a unit vector. Faces in one plane
 * that are seen from the same side get the same values, except for rounding. */
void slope_find(const seen *s, uint32_t face, roberts_vec3 upright, roberts_region *region);

/* ---- where the near plane cuts ---- */

/* Finds the lines along which the near plane cuts faces, as lines that are no edges. They are not drawn, but the
 * visible part of a face ends there. */

/* Sets the further lines of what is seen; call cut_lines_free() in any case. False: no memory. */
bool cut_lines_find(const hide_fronts *fronts, seen_further *lines);
void cut_lines_free(seen_further *lines);

#endif
