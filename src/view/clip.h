/* clip.h - the near plane. It cuts off everything behind the eye or too near to it, which the projective map cannot
 * handle, and everything in front of a section. In a parallel view, a section may have any direction but away from the
 * viewer. So nothing that remains lies in front of it.
 *
 * A solid that the near plane passes through is cut along the plane and closed by a cap. It stays a closed convex
 * solid, so later stages need no special case. The cap hides, since nobody looks into a solid. Its outline is found
 * later (hide/cuts.h). The parts of edges on the eye's side are clipped. A solid completely on that side keeps its
 * number and has no vertices. */
#ifndef ROBERTS_VIEW_CLIP_H
#define ROBERTS_VIEW_CLIP_H

#include "model/scene.h"

/* The remainder of an edge of the scene. */
typedef struct clip_edge {
    uint32_t edge; /* edge of the clipped scene; ROBERTS_NONE: nothing remains */
    double t0, t1; /* parameters along the edge of the scene */
} clip_edge;

typedef struct view_clip {
    roberts_scene scene; /* the clipped scene; freed with the clip */
    clip_edge *origin;   /* [edge_count of the scene] */
    bool *cap;           /* [edge_count of the clipped scene] is it an edge of a cap? */
    /* [sheet_count] faces of the clipped scene whose cut bounds no cap although the body is closed: see bounds_cap() in
     * clip.c. They ascend. */
    uint32_t *sheet;
    size_t sheet_count;
    /* The near plane: points in it have the depth `near` (view_clip_depth()). from: the eye, or in a parallel view the
     * scene's centre; dir: unit vector perpendicular to it, toward the viewer. Model units. */
    roberts_vec3 from, dir;
    double near;
    bool pieces;  /* faces of the scene have been cut into pieces before */
    bool clipped; /* false: nothing is cut, and there are no arrays */
    bool section; /* the plane is that of camera->section */
} view_clip;

/* How much farther than clip->from a point lies, along clip->dir. */
static inline double view_clip_depth(const view_clip *clip, roberts_vec3 P)
{
    return vec3_dot(clip->dir, vec3_sub(clip->from, P));
}

/* The near plane, relative to the scene's centre, with what is left of the scene on its inner side. */
static inline plane view_clip_plane(const view_clip *clip, roberts_vec3 centre)
{
    return (plane){-clip->dir.x, -clip->dir.y, -clip->dir.z, view_clip_depth(clip, centre) - clip->near};
}

/* Clips `scene` for a camera. epsilon: touching distance of the view, model units; 0: choose it. `clipped` becomes
 * false for a parallel view without a section, and for a scene completely beyond the near plane. Returns ROBERTS_OK,
 * _NO_MEMORY or _BAD_VIEW: the eye is inside a solid, or nothing lies beyond the plane. If the camera is
 * invalid, so is the result; view_prepare() refuses it. */
roberts_status view_clip_scene(view_clip *clip, const roberts_scene *scene, const roberts_camera *camera,
                               double epsilon, roberts_error *error);
void view_clip_free(view_clip *clip);

/* Does the near plane cut off any of these points, of a scene with this box? */
bool view_is_cut(const roberts_scene *scene, const roberts_camera *camera, const roberts_vec3 *P, size_t count);

#endif
