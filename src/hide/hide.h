/* hide.h - one scene seen by one camera, from its fronts to its segments. */
#ifndef ROBERTS_HIDE_HIDE_H
#define ROBERTS_HIDE_HIDE_H

#include "hide/crossings.h"
#include "hide/schedule.h"

/* Everything that determines the segments. */
typedef struct hide_job {
    const roberts_hide_options *options;
    const roberts_receiver *to;   /* receives the segments; NULL: the drawing keeps them */
    roberts_region_list *regions; /* NULL: not wanted */
    bool merge_bodies;            /* regions of several bodies may be merged */
    roberts_vec3 upright;         /* of regions: what points up in the model */
    seen seen;
    hide_fronts fronts;
    objet grid;
    picture_order order; /* what was found before its turn, if anything */
    crossings crossings; /* lines that are no edges */
} hide_job;

/* Hides a scene. Without options (NULL) the defaults hold. */
roberts_status hide_scene(hide_job *job, const roberts_scene *scene, const roberts_camera *camera,
                          roberts_drawing *drawing, roberts_error *error);

#endif
