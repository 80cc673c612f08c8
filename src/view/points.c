/* points.c - where single points of a scene are in the picture. */
#include "view/points.h"

#include "view/view.h"

bool view_find_vertex(const roberts_scene *scene, uint32_t number, roberts_vec3 *point)
{
    for (uint32_t v = 0; v < scene->vertex_count; v++)
        if (scene_vertex_number(scene, v) == number) {
            *point = scene->point[v];
            return true;
        }
    return false;
}

roberts_status view_map_points(const roberts_scene *scene, const roberts_camera *camera, const roberts_vec3 *P,
                               size_t count, roberts_vec3 *out, roberts_error *error)
{
    view v;
    roberts_status status = view_prepare(&v, scene, camera, 0.0, error);
    for (size_t i = 0; i < count && status == ROBERTS_OK; i++)
        out[i] = vec3_scale(v.unit, view_point(&v, P[i]));
    return status;
}
