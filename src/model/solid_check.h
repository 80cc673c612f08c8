/* solid_check.h - whether a closed component is a convex solid, within the tolerance. */
#ifndef ROBERTS_MODEL_SOLID_CHECK_H
#define ROBERTS_MODEL_SOLID_CHECK_H

#include "model/face_plane.h"
#include "model/scene.h"

/* One solid in a frame of its own: relative to its first vertex, and where it is very large or very small, scaled by a
 * power of two, so that nothing overflows or vanishes. */
typedef struct solid_frame {
    uint32_t solid;            /* its number */
    scene_solid first, end;    /* its vertices, faces, edges in the scene */
    const roberts_vec3 *point; /* [end.vertex - first.vertex] in this frame */
    const fitted_plane *face;  /* [end.face - first.face] in this frame, n inward */
    double unit;               /* model units per unit of this frame */
    double size;               /* diagonal of the box */
    double allowed;            /* the tolerance as a length */
    roberts_vec3 barycentre;
} solid_frame;

/* Returns ROBERTS_OK, _NOT_PLANAR, _NOT_CONVEX or _FLAT; `error` then says which solid, face or vertex and how much. */
roberts_status solid_check(const roberts_scene *scene, const solid_frame *frame, roberts_error *error);

#endif
