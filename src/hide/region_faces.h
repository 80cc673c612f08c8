/* region_faces.h - what regions take from their faces. Faces are those of job->fronts.scene; of several pieces, the
 * first. */
#ifndef ROBERTS_HIDE_REGION_FACES_H
#define ROBERTS_HIDE_REGION_FACES_H

#include "hide/segments.h"

/* The colour that the input gives a face; if none, the mean of those of its corners; none if one of them has none. */
roberts_color region_color(const hide_job *job, uint32_t piece);

/* Whether the regions of two neighbours may be one: they lie in one plane, as far as both are planar, have one colour,
 * and are of one body or of bodies that are taken as one. */
bool region_can_join(const hide_job *job, uint32_t f, uint32_t g);

#endif
