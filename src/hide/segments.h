/* segments.h - the edges of one solid: which of them are drawn, and the segments that are left of those. */
#ifndef ROBERTS_HIDE_SEGMENTS_H
#define ROBERTS_HIDE_SEGMENTS_H

#include "hide/schedule.h"
#include "view/clip.h"

/* One scene seen by one camera, all that its segments follow from. */
typedef struct hide_job {
    const roberts_scene *scene;  /* as it is mapped: clipped, where that was needed */
    const roberts_scene *source; /* as given */
    view_clip clip;
    roberts_segment_fn *each; /* takes the segments; NULL: the drawing keeps them */
    void *context;
    const roberts_hide_options *options;
    hide_fronts fronts;
    objet grid;
    picture_order order; /* what was found before its turn, if anything */
    double crease_chord; /* distance of two unit normals that meet at the crease angle, squared */
    double smooth_chord; /* the same for bodies that are taken for curved */
} hide_job;

/* Takes up the edges of a solid that are drawn and not covered, and finds what is hidden of them, with the solids seen
 * there where hidden segments are kept. False: no memory. */
bool segments_hide(const hide_job *job, hide_worker *w, uint32_t solid);

/* Adds the segments of the solids first .. end - 1; what was found before their turn is not asked again. False: no
 * memory. */
bool segments_find(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t first, uint32_t end);

/* Visible segments of a line between its hidden parts, and those too where they are wanted. The pattern's t0..t1 is
 * what the line has of the edge that it names. False: no memory. */
bool segments_add_parts(const hide_job *job, hide_chunk *out, const roberts_segment *pattern, const hide_line *line);

/* The solid of each hidden part becomes the one that is seen there, in its middle. */
void segments_name_hiders(const hide_job *job, hide_worker *w);

/* Is the edge, as it is stored with its solid, behind covers? Those are kept only where hidden lines are not wanted. */
bool segments_covered(const hide_job *job, uint32_t solid, const scene_edge *edge);

#endif
