/* camera.h - where single points of a scene lie in the picture, for rooms that do not use views. The functions on
 * cameras are in roberts.h. */
#ifndef ROBERTS_VIEW_CAMERA_H
#define ROBERTS_VIEW_CAMERA_H

#include "roberts.h"

/* Finds the vertex with this number in the input. False: no face has it; of welded vertices only the smallest number
 * counts. */
bool view_find_vertex(const roberts_scene *scene, uint32_t number, roberts_vec3 *point);

/* Maps two points of the model to the picture, in model units, z toward the viewer. Returns as view_prepare(). */
roberts_status view_map_ends(const roberts_scene *scene, const roberts_camera *camera, const roberts_vec3 end[2],
                             roberts_vec3 out[2], roberts_error *error);

#endif
