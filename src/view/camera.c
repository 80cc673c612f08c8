/* camera.c - cameras: the named views, views by angles, and turning round the scene; the part of the picture plane that
 * a drawing covers; where points of the model lie in the picture. */
#include <string.h>

#include "base/angle.h"
#include "base/vec.h"
#include "model/scene.h"
#include "view/clip.h"
#include "view/view.h"

bool roberts_camera_preset(const char *name, roberts_camera *camera)
{
    static const struct {
        const char *name;
        roberts_vec3 dir, up;
        double depth; /* how far a unit of depth moves a point to the right and up */
    } presets[] = {
        {"iso", {1, -1, 1}, {0, 0, 1}, 0},
        /* 1, -sqrt 7, 1: one axis appears half as long as the others */
        {"dimetric", {1, -2.6457513110645907, 1}, {0, 0, 1}, 0},
        {"trimetric", {3, -6, 4}, {0, 0, 1}, 0},
        {"front", {0, -1, 0}, {0, 0, 1}, 0},
        {"back", {0, 1, 0}, {0, 0, 1}, 0},
        {"right", {1, 0, 0}, {0, 0, 1}, 0},
        {"left", {-1, 0, 0}, {0, 0, 1}, 0},
        {"top", {0, 0, 1}, {0, 1, 0}, 0}, /* the view of the lecture */
        {"bottom", {0, 0, -1}, {0, 1, 0}, 0},
        {"cavalier", {0, -1, 0}, {0, 0, 1}, 0.70710678118654752},      /* cos 45, sin 45 */
        {"cabinet", {0, -1, 0}, {0, 0, 1}, 0.5 * 0.70710678118654752}, /* half of that */
    };
    for (size_t i = 0; i < sizeof presets / sizeof presets[0]; i++) {
        if (strcmp(presets[i].name, name) == 0) {
            *camera = (roberts_camera){
                .dir = presets[i].dir, .up = presets[i].up, .oblique = {presets[i].depth, presets[i].depth}};
            return true;
        }
    }
    return false;
}

/* The viewer is at (sin a cos e, -cos a cos e, sin e), with azimuth a and elevation e. `up` is the derivative with
 * respect to e, which is nonzero even at the zenith. */
bool roberts_camera_angles(double azimuth, double elevation, double roll, roberts_camera *camera)
{
    if (!isfinite(azimuth) || !isfinite(roll) || !(fabs(elevation) <= 90.0))
        return false;
    roberts_vec2 a = angle_unit(azimuth), e = angle_unit(elevation);
    *camera =
        (roberts_camera){.dir = {a.y * e.x, -a.x * e.x, e.y}, .up = {-a.y * e.y, a.x * e.y, e.x}, .roll_degrees = roll};
    return true;
}

static roberts_vec3 turned(roberts_vec3 v, roberts_vec2 by)
{
    return (roberts_vec3){by.x * v.x - by.y * v.y, by.y * v.x + by.x * v.y, v.z};
}

static roberts_vec3 turned_about(roberts_vec3 centre, roberts_vec3 P, roberts_vec2 by)
{
    return vec3_add(centre, turned(vec3_sub(P, centre), by));
}

static bool is_upright(roberts_vec3 v)
{
    return v.x == 0.0 && v.y == 0.0;
}

/* If the view is from straight above or below, up is +y by default. Unlike +z, +y changes when the camera turns, so it
 * is set before turning. */
void roberts_camera_turn(const roberts_scene *scene, double degrees, roberts_camera *camera)
{
    const roberts_vec3 centre = scene->centre;
    const roberts_vec2 by = angle_unit(degrees);
    roberts_vec3 dir = camera->dir;
    if (camera->projection == ROBERTS_PERSPECTIVE)
        dir = vec3_sub(camera->eye, camera->has_look_at ? camera->look_at : centre);
    if (is_upright(dir) && is_upright(camera->up))
        camera->up = (roberts_vec3){0.0, 1.0, 0.0};
    camera->dir = turned(camera->dir, by);
    camera->up = turned(camera->up, by);
    camera->eye = turned_about(centre, camera->eye, by);
    camera->look_at = turned_about(centre, camera->look_at, by);
    camera->section = turned_about(centre, camera->section, by);
    camera->section_normal = turned(camera->section_normal, by);
}

/* ---- the part of the picture plane that is drawn ----------------------------------------------------------------- */

/* Degrees: the widest picture of a scene that the near plane cuts, if no field of view is given. What lies near the eye
 * would make it as wide as 180. */
#define FOV_OF_CLIPPED 60.0

bool view_frame(const view *v, const roberts_camera *camera, bool clipped, roberts_vec2 *min, roberts_vec2 *max)
{
    const bool given = camera->fov_degrees != 0.0;
    if (!v->perspective || (!given && !clipped))
        return false;
    const double fov = given ? camera->fov_degrees : FOV_OF_CLIPPED;
    const double half = v->unit / v->inverse_distance * tan(fov * PI / 360.0);
    if (!given && fmax(fmax(-min->x, max->x), fmax(-min->y, max->y)) <= half)
        return false;
    *min = (roberts_vec2){-half, -half};
    *max = (roberts_vec2){half, half};
    return true;
}

roberts_status roberts_window(const roberts_scene *scene, const roberts_camera *camera, roberts_vec2 *min,
                              roberts_vec2 *max, bool *framed, roberts_error *error)
{
    view v;
    view_clip clip;
    roberts_status status = view_clip_scene(&clip, scene, camera, 0.0, error);
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
    const bool field = view_frame(&v, camera, clip.clipped && !clip.section, min, max);
    if (framed)
        *framed = field;
done:
    view_clip_free(&clip);
    return status;
}

/* ---- points of the model ----------------------------------------------------------------------------------------- */

roberts_status roberts_project(const roberts_scene *scene, const roberts_camera *camera, const roberts_vec3 *point,
                               size_t count, roberts_vec3 *out, roberts_error *error)
{
    view v;
    roberts_status status = view_begin(&v, scene, camera, 0.0, error);
    const bool some_are_cut = status == ROBERTS_OK && view_is_cut(scene, camera, point, count);
    for (size_t i = 0; i < count && status == ROBERTS_OK; i++)
        out[i] = some_are_cut && view_is_cut(scene, camera, &point[i], 1)
                     ? (roberts_vec3){NAN, NAN, NAN}
                     : vec3_scale(v.unit, view_point(&v, point[i]));
    return status;
}
