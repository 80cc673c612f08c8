/* clip.h - the near plane: it cuts off what lies behind the eye or too near to it, which the projective map cannot
 * take.
 *
 * A solid that the near plane passes through is cut along the plane and closed by a cap. It stays a closed convex
 * solid, so all later code is the same. The cap hides, since nobody looks into a solid, but its edges are not drawn.
 * The parts of edges on the eye's side are clipped. A solid wholly on that side keeps its number and has no vertices.
 */
#ifndef ROBERTS_VIEW_CLIP_H
#define ROBERTS_VIEW_CLIP_H

#include "model/scene.h"

/* What is left of an edge of the scene. */
typedef struct clip_edge {
    uint32_t edge; /* of the clipped scene; ROBERTS_NONE: nothing */
    double t0, t1; /* along the edge of the scene */
} clip_edge;

typedef struct view_clip {
    roberts_scene scene; /* what is left; frees with the clip */
    clip_edge *origin;   /* [edge_count of the scene] */
    bool *cap;           /* [edge_count of the clipped scene] an edge of a cap */
    bool clipped;        /* false: nothing is cut, and all of the above is empty */
} view_clip;

/* Cuts `scene` for a perspective camera. `clipped` becomes false for another camera, and for a scene wholly beyond the
 * near plane. Returns ROBERTS_OK, _NO_MEMORY or _BAD_VIEW: the eye is inside a solid, or nothing lies in front of it.
 * If view_prepare() refuses the camera, this function does nothing. */
roberts_status view_clip_scene(view_clip *clip, const roberts_scene *scene, const roberts_camera *camera,
                               roberts_error *error);
void view_clip_free(view_clip *clip);

#endif
