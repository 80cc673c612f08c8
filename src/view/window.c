/* window.c - the part of the picture plane that a drawing covers. */
#include "view/clip.h"
#include "view/view.h"

/* Degrees: the field of view for a scene that the near plane cuts. */
#define FOV_OF_CLIPPED 60.0

bool view_frame(const view *v, const roberts_camera *camera, bool clipped, double *half)
{
    double fov = camera->fov_degrees;
    if (fov == 0.0 && clipped)
        fov = FOV_OF_CLIPPED;
    if (!v->perspective || fov == 0.0)
        return false;
    *half = v->unit / v->inverse_distance * tan(fov * 3.14159265358979323846 / 360.0);
    return true;
}

roberts_status roberts_window(const roberts_scene *scene, const roberts_camera *camera, roberts_vec2 *min,
                              roberts_vec2 *max, bool *framed, roberts_error *error)
{
    view v;
    view_clip clip;
    double half;
    roberts_status status = view_clip_scene(&clip, scene, camera, error);
    if (status != ROBERTS_OK)
        return status;
    const roberts_scene *seen = clip.clipped ? &clip.scene : scene;
    if ((status = view_prepare(&v, seen, camera, 0.0, error)) != ROBERTS_OK)
        goto done;
    *min = (roberts_vec2){INFINITY, INFINITY};
    *max = (roberts_vec2){-INFINITY, -INFINITY};
    for (uint32_t i = 0; i < seen->vertex_count; i++) {
        roberts_vec3 p = vec3_scale(v.unit, view_point(&v, seen->point[i]));
        *min = (roberts_vec2){lesser(min->x, p.x), lesser(min->y, p.y)};
        *max = (roberts_vec2){greater(max->x, p.x), greater(max->y, p.y)};
    }
    bool field = view_frame(&v, camera, clip.clipped, &half);
    if (framed)
        *framed = field;
    if (field) {
        *min = (roberts_vec2){-half, -half};
        *max = (roberts_vec2){half, half};
    }
done:
    view_clip_free(&clip);
    return status;
}
