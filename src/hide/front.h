/* front.h - the scene in view space: points, facings, and the front faces ready for the tests. */
#ifndef ROBERTS_HIDE_FRONT_H
#define ROBERTS_HIDE_FRONT_H

#include "hide/space.h"

typedef struct hide_front {
    view view;
    hide_space space;
    roberts_vec3 *P;       /* [vertex_count] view points */
    unsigned char *facing; /* [face_count] VIEW_FRONT, _BACK or _EDGE_ON */
    hide_face *face;       /* [count] front faces, by solid and face */
    uint32_t *order;       /* [count] them again, nearest corner first */
    uint32_t count, most_corners;
    size_t back, edge_on;
    roberts_vec2 low, high; /* box of the picture */
} hide_front;

/* Returns ROBERTS_OK, _NO_MEMORY, _BAD_VIEW or _BAD_ARGUMENT; after a failure `front` is empty. */
roberts_status hide_front_build(hide_front *front, const roberts_scene *scene, const roberts_camera *camera,
                                double epsilon, roberts_error *error);
void hide_front_free(hide_front *front);

#endif
