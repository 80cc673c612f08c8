/* The map to view space: frames, presets, both projections, facings, what is refused, and the touching distance. */
#include <float.h>

#include "scenes.h"
#include "view/view.h"

/* The largest rounding error of a coordinate of view space, in view units; a scene is about one across. */
#define ROUNDING 1e-14

static double distance3(roberts_vec3 a, roberts_vec3 b)
{
    return vec3_length(vec3_sub(a, b));
}

static roberts_scene *cube_scene(roberts_vec3 low, double size)
{
    model m = {0};
    model_box(&m, low, vec3_add(low, (roberts_vec3){size, size, size}));
    roberts_scene *scene = model_build(&m);
    model_free(&m);
    return scene;
}

static view prepare(const roberts_scene *scene, const roberts_camera *camera)
{
    view v;
    roberts_error error = {0};
    if (view_prepare(&v, scene, camera, 0.0, &error) != ROBERTS_OK)
        fail_msg("refused: %s", error.message);
    return v;
}

/* ---- frames ---------------------------------------------------------------------------------------------------- */

static void expect_frame(const char *name, const view *v, roberts_vec3 right, roberts_vec3 up)
{
    if (distance3(v->right, right) > ROUNDING || distance3(v->up, up) > ROUNDING ||
        distance3(vec3_cross(v->right, v->up), v->dir) > ROUNDING || fabs(vec3_length(v->dir) - 1) > ROUNDING)
        fail_msg("%s: right %g %g %g, up %g %g %g", name, v->right.x, v->right.y, v->right.z, v->up.x, v->up.y,
                 v->up.z);
}

/* Directions as in the list of options; right and up of the picture follow from them. */
static void presets_by_table(void **state)
{
    double s2 = sqrt(0.5), s6 = sqrt(1.0 / 6);
    const struct {
        const char *name;
        roberts_vec3 dir, right, up;
    } table[] = {
        {"iso", {1, -1, 1}, {s2, s2, 0}, {-s6, s6, 2 * s6}},
        {"dimetric",
         {1, -sqrt(7), 1},
         {sqrt(7.0 / 8), sqrt(1.0 / 8), 0},
         {-sqrt(1.0 / 72), sqrt(7.0 / 72), sqrt(8.0 / 9)}},
        {"trimetric",
         {3, -6, 4},
         {6 / sqrt(45), 3 / sqrt(45), 0},
         {-12 / sqrt(45 * 61), 24 / sqrt(45 * 61), 45 / sqrt(45 * 61)}},
        {"front", {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
        {"back", {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
        {"right", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        {"left", {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
        {"top", {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
        {"bottom", {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
        {"cavalier", {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
        {"cabinet", {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
    };
    roberts_scene *scene = cube_scene((roberts_vec3){0, 0, 0}, 1);
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE};
        if (!roberts_camera_preset(table[i].name, &camera))
            fail_msg("no preset %s", table[i].name);
        assert_int_equal(camera.projection, ROBERTS_ORTHOGRAPHIC);
        assert_true(distance3(camera.dir, table[i].dir) == 0.0);
        view v = prepare(scene, &camera);
        expect_frame(table[i].name, &v, table[i].right, table[i].up);
    }
    roberts_scene_free(scene);
}

static void presets_that_are_none(void **state)
{
    static const char *const names[] = {"", "Iso", "iso ", "is", "topp", "perspective"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        roberts_camera camera = {.dir = {7, 8, 9}};
        assert_false(roberts_camera_preset(names[i], &camera));
        assert_true(camera.dir.x == 7 && camera.dir.y == 8 && camera.dir.z == 9);
    }
}

/* Dimetric: x and z at one scale, y at half of it. Isometric: all three at the same. */
static void presets_foreshorten(void **state)
{
    static const struct {
        const char *name;
        double y, z; /* scale of the axis, as a part of x's */
    } table[] = {{"iso", 1, 1}, {"dimetric", 0.5, 1}};
    roberts_scene *scene = cube_scene((roberts_vec3){-1, -1, -1}, 2);
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_camera camera = preset_camera(table[i].name);
        view v = prepare(scene, &camera);
        roberts_vec3 x = view_point(&v, (roberts_vec3){1, 0, 0}), y = view_point(&v, (roberts_vec3){0, 1, 0}),
                     z = view_point(&v, (roberts_vec3){0, 0, 1});
        assert_true(fabs(hypot(y.x, y.y) / hypot(x.x, x.y) - table[i].y) < ROUNDING);
        assert_true(fabs(hypot(z.x, z.y) / hypot(x.x, x.y) - table[i].z) < ROUNDING);
    }
    roberts_scene_free(scene);
}

/* Trimetric: three scales, each the projected length of a unit of its axis. */
static void trimetric_has_three_scales(void **state)
{
    roberts_scene *scene = cube_scene((roberts_vec3){-1, -1, -1}, 2);
    (void)state;
    roberts_camera camera = preset_camera("trimetric");
    view v = prepare(scene, &camera);
    const double c[3] = {camera.dir.x, camera.dir.y, camera.dir.z}, square = vec3_dot(camera.dir, camera.dir);
    const roberts_vec3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double scale[3];
    for (int i = 0; i < 3; i++) {
        roberts_vec3 p = view_point(&v, axis[i]);
        scale[i] = hypot(p.x, p.y) * v.unit;
        assert_true(fabs(scale[i] - sqrt(1 - c[i] * c[i] / square)) < ROUNDING);
    }
    assert_true(fabs(scale[0] - scale[1]) > 0.1 && fabs(scale[1] - scale[2]) > 0.1 && fabs(scale[2] - scale[0]) > 0.01);
    roberts_scene_free(scene);
}

/* Directions are exact at multiples of 90 degrees and a rounding away elsewhere; up is where the elevation grows. */
static void angles_by_table(void **state)
{
    const double h = 0.5, q = sqrt(0.75), s = sqrt(0.5);
    const struct {
        double azimuth, elevation;
        bool exact;
        roberts_vec3 dir, up;
    } table[] = {
        {0, 0, true, {0, -1, 0}, {0, 0, 1}},
        {90, 0, true, {1, 0, 0}, {0, 0, 1}},
        {180, 0, true, {0, 1, 0}, {0, 0, 1}},
        {270, 0, true, {-1, 0, 0}, {0, 0, 1}},
        {-90, 0, true, {-1, 0, 0}, {0, 0, 1}},
        {-360, 0, true, {0, -1, 0}, {0, 0, 1}},
        {3690, 0, true, {1, 0, 0}, {0, 0, 1}},
        {0, 90, true, {0, 0, 1}, {0, 1, 0}},
        {90, 90, true, {0, 0, 1}, {-1, 0, 0}},
        {0, -90, true, {0, 0, -1}, {0, -1, 0}},
        {30, 0, true, {h, -q, 0}, {0, 0, 1}},
        {45, 0, true, {s, -s, 0}, {0, 0, 1}},
        {120, 0, true, {q, h, 0}, {0, 0, 1}},
        {-150, 0, true, {-h, q, 0}, {0, 0, 1}},
        {0, 30, true, {0, -q, h}, {0, h, q}},
        {45, 30, false, {s * q, -s * q, h}, {-s * h, s * h, q}},
        {10, 0, false, {sin(10 * atan(1) / 45), -cos(10 * atan(1) / 45), 0}, {0, 0, 1}},
        {200, 0, false, {-sin(20 * atan(1) / 45), cos(20 * atan(1) / 45), 0}, {0, 0, 1}},
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_camera camera;
        print_message("azimuth %g, elevation %g\n", table[i].azimuth, table[i].elevation);
        assert_true(roberts_camera_angles(table[i].azimuth, table[i].elevation, 0, &camera));
        double tolerance = table[i].exact ? 0.0 : 4 * DBL_EPSILON;
        assert_true(distance3(camera.dir, table[i].dir) <= tolerance);
        assert_true(distance3(camera.up, table[i].up) <= tolerance);
        assert_true(fabs(vec3_length(camera.dir) - 1) < ROUNDING && fabs(vec3_dot(camera.dir, camera.up)) < ROUNDING);
    }
    roberts_camera same = {.dir = {7, 8, 9}};
    assert_false(roberts_camera_angles(0, 90.001, 0, &same));
    assert_false(roberts_camera_angles(0, NAN, 0, &same));
    assert_false(roberts_camera_angles(INFINITY, 0, 0, &same));
    assert_false(roberts_camera_angles(0, 0, NAN, &same));
    assert_true(same.dir.x == 7);
}

/* Isometric by angles: all axes at one scale. */
static void angles_foreshorten(void **state)
{
    roberts_scene *scene = cube_scene((roberts_vec3){-1, -1, -1}, 2);
    roberts_camera camera;
    (void)state;
    assert_true(roberts_camera_angles(45, asin(sqrt(1.0 / 3)) * 45 / atan(1), 0, &camera));
    view v = prepare(scene, &camera);
    roberts_vec3 x = view_point(&v, (roberts_vec3){1, 0, 0}), y = view_point(&v, (roberts_vec3){0, 1, 0}),
                 z = view_point(&v, (roberts_vec3){0, 0, 1});
    assert_true(fabs(hypot(x.x, x.y) * v.unit - sqrt(2.0 / 3)) < ROUNDING);
    assert_true(fabs(hypot(x.x, x.y) - hypot(y.x, y.y)) < ROUNDING);
    assert_true(fabs(hypot(x.x, x.y) - hypot(z.x, z.y)) < ROUNDING);
    roberts_scene_free(scene);
}

enum { ORTHOGRAPHIC, PERSPECTIVE, OBLIQUE, PROJECTIONS };

static roberts_camera random_camera(rng *r, int projection)
{
    mat3 a = mat3_turn(r);
    roberts_vec2 oblique = {rng_between(r, -1, 1), rng_between(r, -1, 1)};
    if (projection != PERSPECTIVE)
        return (roberts_camera){
            .dir = a.x, .up = a.y, .oblique = projection == OBLIQUE ? oblique : (roberts_vec2){0, 0}};
    return (roberts_camera){ROBERTS_PERSPECTIVE, .eye = vec3_scale(rng_between(r, 9, 40), a.x),
                            .look_at = {rng_between(r, -1, 1), rng_between(r, -1, 1), rng_between(r, -1, 1)},
                            .has_look_at = true, .up = a.y};
}

/* Rolled pictures are the picture turned; depth stays. In all projections. */
static void roll_turns_the_drawing(void **state)
{
    rng r = {22};
    roberts_scene *scene = cube_scene((roberts_vec3){-1, -1, -1}, 2);
    (void)state;
    for (int i = 0; i < 300; i++) {
        double roll = i % 3 == 0 ? 90.0 * rng_int(&r, -4, 4) : rng_between(&r, -360, 360);
        roberts_camera camera = random_camera(&r, i % PROJECTIONS), rolled = camera;
        rolled.roll_degrees = roll;
        view v = prepare(scene, &camera), w = prepare(scene, &rolled);
        double c = cos(roll * atan(1) / 45), s = sin(roll * atan(1) / 45);
        for (int k = 0; k < 8; k++) {
            roberts_vec3 P = {k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1}, p = view_point(&v, P),
                         q = view_point(&w, P);
            assert_true(distance3(q, (roberts_vec3){c * p.x - s * p.y, s * p.x + c * p.y, p.z}) < 10 * ROUNDING);
        }
    }
    roberts_scene_free(scene);
}

/* Camera and scene turned together give the same picture. The box is upright, so that it keeps its centre. */
static void turning_goes_about_the_centre(void **state)
{
    rng r = {23};
    const roberts_vec3 low = {3, 5, -2}, centre = {4, 6, -1};
    roberts_scene *scene = cube_scene(low, 2);
    (void)state;
    for (int i = 0; i < 300; i++) {
        roberts_camera camera = random_camera(&r, i % PROJECTIONS), turned;
        if (i % 5 == 0) /* from above, where no direction is up */
            camera = (roberts_camera){.dir = {0, 0, 1}};
        double degrees = i % 3 == 0 ? 90.0 * rng_int(&r, -4, 4) : rng_between(&r, -360, 360);
        camera.eye = vec3_add(camera.eye, centre);
        camera.look_at = vec3_add(camera.look_at, centre);
        camera.section = vec3_add(centre, rng_vec3(&r, 1.0));
        turned = camera;
        roberts_camera_turn(scene, degrees, &turned);
        view v = prepare(scene, &camera), w = prepare(scene, &turned);
        double c = cos(degrees * atan(1) / 45), s = sin(degrees * atan(1) / 45);
        assert_true(distance3(view_point(&v, camera.section), view_point(&w, turned.section)) < 10 * ROUNDING);
        for (int k = 0; k < 8; k++) {
            roberts_vec3 d = {k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1};
            roberts_vec3 t = {c * d.x - s * d.y, s * d.x + c * d.y, d.z};
            assert_true(distance3(view_point(&v, vec3_add(centre, d)), view_point(&w, vec3_add(centre, t))) <
                        10 * ROUNDING);
        }
    }
    roberts_scene_free(scene);
}

/* Oblique: width and height are true, depth goes up to the right at 45 degrees, in full or in half. */
static void oblique_presets(void **state)
{
    static const struct {
        const char *name;
        double depth;
    } table[] = {{"cavalier", 1}, {"cabinet", 0.5}};
    roberts_scene *scene = cube_scene((roberts_vec3){-1, -1, -1}, 2);
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_camera camera = preset_camera(table[i].name);
        view v = prepare(scene, &camera);
        double d = table[i].depth * sqrt(0.5) / v.unit, one = 1 / v.unit;
        assert_true(distance3(view_point(&v, (roberts_vec3){1, 0, 0}), (roberts_vec3){one, 0, 0}) < ROUNDING);
        assert_true(distance3(view_point(&v, (roberts_vec3){0, 0, 1}), (roberts_vec3){0, one, 0}) < ROUNDING);
        assert_true(distance3(view_point(&v, (roberts_vec3){0, 1, 0}), (roberts_vec3){d, d, -one}) < ROUNDING);
    }
    roberts_scene_free(scene);
}

static void expect_window(const roberts_scene *scene, const roberts_camera *camera, bool framed)
{
    roberts_error error = {0};
    roberts_drawing drawing;
    roberts_vec2 min, max;
    bool told = !framed;
    if (roberts_hide(scene, camera, NULL, &drawing, &error) != ROBERTS_OK)
        fail_msg("refused: %s", error.message);
    assert_int_equal(drawing.framed, framed);
    assert_int_equal(roberts_window(scene, camera, &min, &max, &told, &error), ROBERTS_OK);
    assert_int_equal(told, framed);
    assert_true(min.x == drawing.window_min.x && min.y == drawing.window_min.y);
    assert_true(max.x == drawing.window_max.x && max.y == drawing.window_max.y);
    roberts_drawing_free(&drawing);
}

/* The same as with the drawing: the whole scene, a field of view, a scene that the near plane cuts; or no view. */
static void windows(void **state)
{
    rng r = {24};
    roberts_scene *scene = cube_scene((roberts_vec3){-1, -1, -1}, 2);
    roberts_vec2 min, max;
    (void)state;
    for (int i = 0; i < 100; i++) {
        roberts_camera camera = random_camera(&r, i % PROJECTIONS);
        expect_window(scene, &camera, false);
        if (camera.projection == ROBERTS_PERSPECTIVE) {
            camera.fov_degrees = 40;
            expect_window(scene, &camera, true);
        }
    }
    roberts_camera beside = {.projection = ROBERTS_PERSPECTIVE, .eye = {1.5, 0.5, 0}, .look_at = {1.5, 9, 0}};
    beside.has_look_at = true;
    expect_window(scene, &beside, true);
    const roberts_camera far_off = {.projection = ROBERTS_PERSPECTIVE, .eye = {1, -40, 0}, .near_distance = 40};
    expect_window(scene, &far_off, false); /* what is left is narrow */
    roberts_camera inside = {.projection = ROBERTS_PERSPECTIVE, .eye = {0.5, 0, 0}}, nowhere = {0};
    assert_int_equal(roberts_window(scene, &inside, &min, &max, NULL, NULL), ROBERTS_BAD_VIEW);
    assert_int_equal(roberts_window(scene, &nowhere, &min, &max, NULL, NULL), ROBERTS_BAD_VIEW);
    roberts_scene_free(scene);
}

static void expect_at(roberts_vec3 found, roberts_vec2 p, double z)
{
    assert_true(distance3(found, (roberts_vec3){p.x, p.y, z}) <= 16 * ROUNDING * fmax(1, vec3_length(found)));
}

/* Projects the vertices of each segment, and what roberts_pick() finds at its middle. Returns how many ends it has that
 * are vertices. */
static int expect_projected(const roberts_scene *scene, const roberts_camera *camera)
{
    const roberts_hide_options options = {.keep_hidden = true};
    int ends = 0;
    roberts_drawing drawing;
    assert_int_equal(roberts_hide(scene, camera, &options, &drawing, NULL), ROBERTS_OK);
    for (size_t i = 0; i < drawing.count; i++) {
        const roberts_segment *s = &drawing.segment[i];
        roberts_vec3 at[2];
        assert_true(roberts_scene_vertex(scene, s->v0, &at[0]) && roberts_scene_vertex(scene, s->v1, &at[1]));
        assert_int_equal(roberts_project(scene, camera, at, 2, at, NULL), ROBERTS_OK);
        if (s->state == ROBERTS_CLIPPED) {
            assert_true(s->t0 > 0 || isnan(at[0].x + at[0].y + at[0].z));
            assert_true(s->t1 < 1 || isnan(at[1].x + at[1].y + at[1].z));
            continue;
        }
        ends += (s->t0 == 0) + (s->t1 == 1);
        if (s->t0 == 0)
            expect_at(at[0], s->p0, s->z0);
        if (s->t1 == 1)
            expect_at(at[1], s->p1, s->z1);
        const roberts_vec2 middle = {(s->p0.x + s->p1.x) / 2, (s->p0.y + s->p1.y) / 2};
        roberts_picked picked;
        assert_int_equal(roberts_pick(scene, camera, middle.x, middle.y, &picked, NULL), ROBERTS_OK);
        if (picked.count) {
            assert_int_equal(roberts_project(scene, camera, &picked.hit[0].point, 1, at, NULL), ROBERTS_OK);
            expect_at(at[0], middle, at[0].z);
        }
        roberts_picked_free(&picked);
    }
    roberts_drawing_free(&drawing);
    return ends;
}

/* As in the drawing and for a ray, in all projections, and where the near plane cuts the scene. */
static void projected_points(void **state)
{
    rng r = {25};
    roberts_scene *scene = cube_scene((roberts_vec3){-1, -1, -1}, 2);
    (void)state;
    for (int i = 0; i < 100; i++) {
        const roberts_camera camera = random_camera(&r, i % PROJECTIONS);
        assert_int_equal(expect_projected(scene, &camera), 24);
    }
    const roberts_camera beside = {
        .projection = ROBERTS_PERSPECTIVE, .eye = {1.5, 0.5, 0}, .look_at = {1.5, 9, 0}, .has_look_at = true};
    assert_int_equal(expect_projected(scene, &beside), 12);
    const roberts_camera nowhere = {0};
    roberts_vec3 point = {1, 2, 3};
    assert_int_equal(roberts_project(scene, &nowhere, &point, 1, &point, NULL), ROBERTS_BAD_VIEW);
    assert_false(roberts_scene_vertex(scene, 8, &point));
    assert_true(point.x == 1 && point.y == 2 && point.z == 3);
    roberts_scene_free(scene);
}

static void up_by_table(void **state)
{
    static const struct {
        const char *name;
        roberts_vec3 dir, up, right, picture_up;
    } table[] = {
        {"none: +z", {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        {"none, from above: +y", {0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
        {"none, from below: +y", {0, 0, -3}, {0, 0, 0}, {-1, 0, 0}, {0, 1, 0}},
        {"given", {0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {1, 0, 0}},
        {"given and askew", {0, 0, 1}, {0, 2, 5}, {1, 0, 0}, {0, 1, 0}},
        {"given downward", {0, -1, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 0, -1}},
        {"parallel: +z", {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        {"against the view: +z", {1, 0, 0}, {-2, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        {"parallel and vertical: +y", {0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
        {"against the view and vertical: +y", {0, 0, 1}, {0, 0, -4}, {1, 0, 0}, {0, 1, 0}},
        {"nearly parallel", {1, 0, 0}, {1, 1e-6, 0}, {0, 0, -1}, {0, 1, 0}},
        {"so nearly that it counts: +z", {1, 0, 0}, {1, 1e-11, 0}, {0, 1, 0}, {0, 0, 1}},
        {"very long", {0, 0, 1e300}, {1e300, 0, 0}, {0, -1, 0}, {1, 0, 0}},
        {"very short", {0, 0, 1e-300}, {1e-300, 0, 0}, {0, -1, 0}, {1, 0, 0}},
        {"denormal", {0, 0, 5e-324}, {5e-324, 0, 0}, {0, -1, 0}, {1, 0, 0}},
    };
    roberts_scene *scene = cube_scene((roberts_vec3){0, 0, 0}, 1);
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_camera camera = {.dir = table[i].dir, .up = table[i].up};
        view v = prepare(scene, &camera);
        expect_frame(table[i].name, &v, table[i].right, table[i].picture_up);
        roberts_vec3 eye = vec3_scale(30 / vec3_length(v.dir), v.dir); /* the same rules in perspective */
        camera = (roberts_camera){ROBERTS_PERSPECTIVE, .eye = eye, .has_look_at = true, .up = table[i].up};
        v = prepare(scene, &camera);
        expect_frame(table[i].name, &v, table[i].right, table[i].picture_up);
    }
    roberts_scene_free(scene);
}

/* Any direction and up, of any length: orthonormal, right-handed, up on the up side and level to the right. */
static void frames_at_random(void **state)
{
    rng r = {21};
    roberts_scene *scene = cube_scene((roberts_vec3){0, 0, 0}, 1);
    (void)state;
    for (int i = 0; i < 1000; i++) {
        mat3 a = mat3_turn(&r);
        roberts_vec3 dir = a.x, up = vec3_add(a.x, vec3_scale(rng_between(&r, 0.1, 9), a.y));
        roberts_camera camera = {.dir = vec3_scale(ldexp(1, rng_int(&r, -900, 900)), dir),
                                 .up = vec3_scale(ldexp(1, rng_int(&r, -900, 900)), up)};
        view v = prepare(scene, &camera);
        expect_frame("random", &v, vec3_scale(-1, a.z), a.y);
        assert_true(distance3(v.dir, dir) < ROUNDING);
    }
    roberts_scene_free(scene);
}

/* Up as near to the line of sight as possible: depth does not leak into the picture. */
static void up_nearly_parallel(void **state)
{
    rng r = {211};
    roberts_scene *scene = cube_scene((roberts_vec3){0, 0, 0}, 1);
    (void)state;
    for (int i = 0; i < 2000; i++) {
        mat3 a = mat3_turn(&r);
        roberts_vec3 dir = vec3_scale(rng_between(&r, 1, 9), a.x);
        roberts_vec3 up = vec3_add(a.x, vec3_scale(pow(10, rng_between(&r, -8.9, 0)), a.y));
        roberts_camera camera = {i % 2 ? ROBERTS_PERSPECTIVE : ROBERTS_ORTHOGRAPHIC, .dir = dir, .up = up};
        camera.eye = vec3_scale(9, dir);
        camera.has_look_at = true;
        view v = prepare(scene, &camera);
        if (!(fabs(vec3_dot(v.right, a.x)) < ROUNDING && fabs(vec3_dot(v.up, a.x)) < ROUNDING &&
              fabs(vec3_dot(v.right, v.up)) < ROUNDING && fabs(vec3_length(v.right) - 1) < ROUNDING &&
              fabs(vec3_length(v.up) - 1) < ROUNDING))
            fail_msg("%d: right and up are off by %g and %g", i, vec3_dot(v.right, a.x), vec3_dot(v.up, a.x));
    }
    roberts_scene_free(scene);
}

/* ---- the two projections --------------------------------------------------------------------------------------- */

static roberts_vec3 random_point(rng *r)
{
    return (roberts_vec3){rng_between(r, -4, 4), rng_between(r, -4, 4), rng_between(r, -4, 4)};
}

static void orthographic_is_a_rigid_motion(void **state)
{
    rng r = {22};
    roberts_scene *scene = cube_scene((roberts_vec3){-4, -4, -4}, 8);
    (void)state;
    for (int i = 0; i < 300; i++) {
        roberts_camera camera = random_camera(&r, ORTHOGRAPHIC);
        view v = prepare(scene, &camera);
        roberts_vec3 P = random_point(&r), p = view_point(&v, P);
        assert_true(fabs(p.x * v.unit - vec3_dot(P, v.right)) < 1e-13);
        assert_true(fabs(p.y * v.unit - vec3_dot(P, v.up)) < 1e-13);
        assert_true(fabs(p.z * v.unit - vec3_dot(P, camera.dir)) < 1e-13);
    }
    roberts_scene_free(scene);
}

/* Points mapped together are the same as points mapped one by one, bit for bit. Faces are turned like their planes. */
static void together_as_one_by_one(void **state)
{
    rng r = {25};
    roberts_scene *scene = cube_scene((roberts_vec3){-4, -4, -4}, 8);
    (void)state;
    for (int i = 0; i < 3000; i++) {
        roberts_camera camera = random_camera(&r, i % PROJECTIONS);
        roberts_vec3 out[8], one[8];
        if (i % 2)
            camera.oblique = (roberts_vec2){0.0, 0.0};
        if (i % 5 == 0)
            camera.dir = (roberts_vec3){rng_int(&r, -1, 1), rng_int(&r, -1, 1), 1};
        view v = prepare(scene, &camera);
        view_points(&v, scene->point, scene->vertex_count, out);
        for (uint32_t k = 0; k < scene->vertex_count; k++)
            one[k] = view_point(&v, scene->point[k]);
        assert_memory_equal(out, one, sizeof one);
        for (uint32_t face = 0; face < scene->face_count; face++) {
            double stretch, expected_stretch;
            plane F, expected = view_plane(&v, scene, face, &expected_stretch);
            int facing = view_face(&v, scene, face, out, &F, &stretch);
            assert_int_equal(facing, view_facing(&v, scene, face, expected, out));
            if (facing == VIEW_FRONT)
                assert_true(memcmp(&F, &expected, sizeof F) == 0 && stretch == expected_stretch);
        }
    }
    roberts_scene_free(scene);
}

/* Points of a sight line have one picture, the nearer one the greater depth; in the plane through the look-at point all
 * lengths are true; the picture of any point is where its sight line meets that plane. */
static void perspective_pictures(void **state)
{
    rng r = {23};
    roberts_scene *scene = cube_scene((roberts_vec3){-4, -4, -4}, 8);
    (void)state;
    for (int i = 0; i < 300; i++) {
        roberts_camera camera = random_camera(&r, PERSPECTIVE);
        view v = prepare(scene, &camera);
        roberts_vec3 P = random_point(&r), p = view_point(&v, P);
        roberts_vec3 to_look = vec3_sub(camera.look_at, camera.eye), to_P = vec3_sub(P, camera.eye);
        double k = vec3_dot(to_look, v.dir) / vec3_dot(to_P, v.dir); /* eye + k (P - eye) is in that plane */
        roberts_vec3 hit = vec3_sub(vec3_add(camera.eye, vec3_scale(k, to_P)), camera.look_at);
        assert_true(fabs(p.x * v.unit - vec3_dot(hit, v.right)) < 1e-12);
        assert_true(fabs(p.y * v.unit - vec3_dot(hit, v.up)) < 1e-12);
        roberts_vec3 nearer = view_point(&v, vec3_add(P, vec3_scale(-0.1, to_P)));
        assert_true(hypot(nearer.x - p.x, nearer.y - p.y) < 1e-12 && nearer.z > p.z);
    }
    roberts_scene_free(scene);
}

/* From (6, 12, 12), looking at the origin from D = 18: at h before the eye and s aside of the axis, a point has its
 * picture at a distance of s D / h from the middle and a depth of (D - h) D / h; both right to the last places, and
 * within the bound of rounding, down to some millionths of the scene's size. All numbers here are exact. */
static void close_to_the_eye(void **state)
{
    const roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE, .eye = {6, 12, 12}, .has_look_at = true};
    const double D = 18;
    (void)state;
    for (int k = 2; k <= 16; k++) {
        const double h = 3 * ldexp(1, -k), s = 0.5 * h, part = h / 3;
        /* the axis is (1, 2, 2) / 3, and (2, -1, 0), (2, 4, -5) are square to it */
        const roberts_vec3 aside[] = {{0, 0, 0}, {2, -1, 0}, {2, 4, -5}};
        model m = {0};
        roberts_vec3 before = {6 - part, 12 - 2 * part, 12 - 2 * part}; /* a small tetrahedron's corner */
        const roberts_vec3 tetrahedron[] = {before, {5, 8, 9}, {4, 8, 9}, {5, 9, 8}};
        static const uint32_t face[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 2, 3}};
        for (int i = 0; i < 4; i++)
            model_vertex(&m, tetrahedron[i]);
        for (int i = 0; i < 4; i++)
            model_face(&m, face[i], 3);
        model_close_solid(&m);
        model_box(&m, (roberts_vec3){-6, -6, -6}, (roberts_vec3){2, 2, 2});
        roberts_scene *scene = model_build(&m);
        model_free(&m);
        view v = prepare(scene, &camera);
        for (size_t i = 0; i < sizeof aside / sizeof aside[0]; i++) {
            double length = vec3_length(aside[i]);
            roberts_vec3 p = vec3_scale(v.unit, view_point(&v, vec3_add(before, vec3_scale(s, aside[i]))));
            double far = s * length * D / h, depth = (D - h) * D / h;
            assert_true(fabs(hypot(p.x, p.y) - far) <= 8 * DBL_EPSILON * fmax(far, D));
            assert_true(fabs(p.z - depth) <= 8 * DBL_EPSILON * depth);
            assert_true(fabs(p.z - depth) <= v.rounding * v.unit);
        }
        roberts_scene_free(scene);
    }
}

/* Lines stay lines, and the parameters along them are those of view_to_space() and view_from_space(). */
static void parameters_along_lines(void **state)
{
    rng r = {24};
    roberts_scene *scene = cube_scene((roberts_vec3){-4, -4, -4}, 8);
    (void)state;
    for (int i = 0; i < 2000; i++) {
        roberts_camera camera = random_camera(&r, i % PROJECTIONS);
        view v = prepare(scene, &camera);
        roberts_vec3 A = random_point(&r), B = random_point(&r), a = view_point(&v, A), b = view_point(&v, B);
        double t = rng_between(&r, 0, 1), s = view_from_space(&v, a.z, b.z, t);
        roberts_vec3 P = vec3_add(A, vec3_scale(t, vec3_sub(B, A))), p = view_point(&v, P);
        assert_true(distance3(p, vec3_add(a, vec3_scale(s, vec3_sub(b, a)))) < ROUNDING);
        assert_true(fabs(view_to_space(&v, a.z, b.z, s) - t) < 1e-14);
        assert_true(camera.projection == ROBERTS_PERSPECTIVE || s == t);
        assert_true(view_to_space(&v, a.z, b.z, 0) == 0 && view_to_space(&v, a.z, b.z, 1) == 1);
        assert_true(view_from_space(&v, a.z, b.z, 0) == 0 && view_from_space(&v, a.z, b.z, 1) == 1);
        double later = view_from_space(&v, a.z, b.z, t + 0.5 * (1 - t));
        assert_true(later > s);
    }
    roberts_scene_free(scene);
}

/* The direction toward the viewer, which moves a point neither right nor up in the picture. */
static roberts_vec3 sight_line(const view *v)
{
    return vec3_add(v->dir, vec3_add(vec3_scale(v->oblique.x, v->right), vec3_scale(v->oblique.y, v->up)));
}

static void oblique_sight_lines(void **state)
{
    rng r = {27};
    roberts_scene *scene = cube_scene((roberts_vec3){-4, -4, -4}, 8);
    (void)state;
    for (int i = 0; i < 300; i++) {
        roberts_camera camera = random_camera(&r, OBLIQUE);
        view v = prepare(scene, &camera);
        roberts_vec3 P = random_point(&r), p = view_point(&v, P), q = view_point(&v, vec3_add(P, sight_line(&v)));
        assert_true(hypot(p.x - q.x, p.y - q.y) < ROUNDING && fabs((q.z - p.z) * v.unit - 1) < 1e-13);
        q = view_point(&v, vec3_sub(P, v.dir)); /* one unit farther away */
        assert_true(fabs((q.x - p.x) * v.unit - camera.oblique.x) < 1e-13);
        assert_true(fabs((q.y - p.y) * v.unit - camera.oblique.y) < 1e-13);
    }
    roberts_scene_free(scene);
}

/* Planes stay planes: the mapped corners lie on the mapped plane, whose normal has length 1 and looks away from the
 * viewer exactly where the viewer is outside the face. Distances from the plane grow by `stretch`. */
static void planes_stay_planes(void **state)
{
    rng r = {25};
    model m = {0};
    (void)state;
    model_lattice(&m, 3, 0.9, 26);
    model_map(&m, mat3_scale(1, 1, 1), (roberts_vec3){-1, -1, -1});
    roberts_scene *scene = model_build(&m);
    for (int i = 0; i < 20; i++) {
        roberts_camera camera = random_camera(&r, i % PROJECTIONS);
        view v = prepare(scene, &camera);
        for (uint32_t f = 0; f < scene->face_count; f++) {
            plane F = scene_plane(scene, f), G;
            double stretch, outside;
            G = view_plane(&v, scene, f, &stretch);
            assert_true(fabs(G.a * G.a + G.b * G.b + G.c * G.c - 1) < ROUNDING);
            for (uint32_t k = scene->face_start[f]; k < scene->face_start[f + 1]; k++)
                assert_true(fabs(plane_at(G, view_point(&v, scene->point[scene->corner[k]]))) < ROUNDING);
            outside = camera.projection == ROBERTS_PERSPECTIVE
                          ? plane_at(F, vec3_sub(camera.eye, scene->centre))
                          : vec3_dot((roberts_vec3){F.a, F.b, F.c}, sight_line(&v));
            assert_true(fabs(outside) < 1e-9 || (G.c < 0) == (outside < 0));
            roberts_vec3 P = random_point(&r), p = view_point(&v, P);
            double flat = plane_at(F, vec3_sub(P, scene->centre)) / v.unit * stretch *
                          (v.perspective ? 1 + p.z * v.inverse_distance : 1);
            assert_true(fabs(flat - plane_at(G, p)) < 1e-12);
        }
    }
    roberts_scene_free(scene);
    model_free(&m);
}

/* ---- front, back, edge-on -------------------------------------------------------------------------------------- */

/* Facing of the face of a scene whose inward normal is (a, b, c). */
static int facing_of(const roberts_scene *scene, const view *v, roberts_vec3 n)
{
    roberts_vec3 P[64];
    uint32_t face = 0;
    assert_true(scene->vertex_count <= 64);
    for (uint32_t i = 0; i < scene->vertex_count; i++)
        P[i] = view_point(v, scene->point[i]);
    while (fabs(scene_plane(scene, face).a - n.x) + fabs(scene_plane(scene, face).b - n.y) +
               fabs(scene_plane(scene, face).c - n.z) >
           1e-9)
        face++;
    return view_facing(v, scene, face, view_plane(v, scene, face, NULL), P);
}

/* The upper face (of greatest z) of the unit cube, epsilon being 1e-6. */
static void facing_by_table(void **state)
{
    static const struct {
        const char *name;
        bool perspective;
        roberts_vec3 from; /* direction, or eye */
        int facing;
    } table[] = {
        {"from above", false, {0, 0, 1}, VIEW_FRONT},
        {"from above, askew", false, {3, -4, 1}, VIEW_FRONT},
        {"from below", false, {0, 0, -1}, VIEW_BACK},
        {"from the side", false, {1, 0, 0}, VIEW_EDGE_ON},
        {"from the side, askew", false, {3, -5, 0}, VIEW_EDGE_ON},
        {"picture a little narrower than epsilon", false, {1, 0, 0.999e-6}, VIEW_EDGE_ON},
        {"picture a little wider than epsilon", false, {1, 0, 1.001e-6}, VIEW_FRONT},
        {"narrower, from below", false, {1, 0, -0.999e-6}, VIEW_EDGE_ON},
        {"wider, from below", false, {1, 0, -1.001e-6}, VIEW_BACK},
        {"along the diagonal, narrower", false, {1, 1, 0.999e-6}, VIEW_EDGE_ON}, /* sqrt 2 deep, slope 1 / sqrt 2 */
        {"along the diagonal, wider", false, {1, 1, 1.001e-6}, VIEW_FRONT},
        {"eye above", true, {0, 0, 9}, VIEW_FRONT},
        {"eye above, aside", true, {7, 8, 3}, VIEW_FRONT},
        {"eye below", true, {0, 0, -9}, VIEW_BACK},
        {"eye below its plane, above the cube's middle", true, {9, 0, 0.4}, VIEW_BACK},
        {"eye above its plane", true, {9, 0, 0.6}, VIEW_FRONT},
        {"eye in its plane", true, {9, 0, 0.5}, VIEW_EDGE_ON},
        /* the picture's height is h (9 / 8.5 - 9 / 9.5), h above the plane */
        {"eye near its plane, narrower", true, {9, 0, 0.5 + 0.99e-6 / 0.111455108359133}, VIEW_EDGE_ON},
        {"eye near its plane, wider", true, {9, 0, 0.5 + 1.01e-6 / 0.111455108359133}, VIEW_FRONT},
        {"eye near its plane, below, wider", true, {9, 0, 0.5 - 1.01e-6 / 0.111455108359133}, VIEW_BACK},
    };
    roberts_scene *scene = cube_scene((roberts_vec3){-0.5, -0.5, -0.5}, 1);
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_camera camera = {.dir = table[i].from};
        view v;
        if (table[i].perspective)
            camera = (roberts_camera){ROBERTS_PERSPECTIVE, .eye = table[i].from};
        assert_int_equal(view_prepare(&v, scene, &camera, 1e-6, NULL), ROBERTS_OK);
        int facing = facing_of(scene, &v, (roberts_vec3){0, 0, -1});
        if (facing != table[i].facing)
            fail_msg("%s: facing %d, expected %d", table[i].name, facing, table[i].facing);
    }
    roberts_scene_free(scene);
}

/* A box 1 x 2^-21 x 1/2, its upper face 1 x 2^-21 = 4.8e-7: from wherever it is seen, and however the needle lies, its
 * picture is at most that narrow. */
static void facing_of_needles(void **state)
{
    static const roberts_vec3 dirs[] = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {3, 4, 5}, {0, 0, -1}};
    (void)state;
    for (int turned = 0; turned < 2; turned++) {
        roberts_vec3 high = {turned ? 0x1p-21 : 1, turned ? 1 : 0x1p-21, 0.5};
        model m = {0};
        model_box(&m, (roberts_vec3){0, 0, 0}, high);
        roberts_scene *scene = model_build(&m);
        for (size_t i = 0; i < sizeof dirs / sizeof dirs[0]; i++) {
            roberts_camera camera = {.dir = dirs[i]};
            view v;
            assert_int_equal(view_prepare(&v, scene, &camera, 5e-7, NULL), ROBERTS_OK);
            assert_int_equal(facing_of(scene, &v, (roberts_vec3){0, 0, -1}), VIEW_EDGE_ON);
            assert_int_equal(view_prepare(&v, scene, &camera, 1e-7, NULL), ROBERTS_OK);
            assert_int_equal(facing_of(scene, &v, (roberts_vec3){0, 0, -1}), dirs[i].z > 0 ? VIEW_FRONT : VIEW_BACK);
        }
        roberts_scene_free(scene);
        model_free(&m);
    }
}

/* ---- what is refused ------------------------------------------------------------------------------------------- */

static void refused_by_table(void **state)
{
    static const struct {
        const char *name;
        roberts_camera camera;
        double epsilon;
        roberts_status status;
        const char *message; /* part of it */
    } table[] = {
        {"good", {.dir = {0, 0, 1}}, 0, ROBERTS_OK, ""},
        {"no direction", {.dir = {0, 0, 0}}, 0, ROBERTS_BAD_VIEW, "direction"},
        {"minus zero", {.dir = {-0.0, 0, -0.0}}, 0, ROBERTS_BAD_VIEW, "direction"},
        {"direction no number", {.dir = {0, NAN, 1}}, 0, ROBERTS_BAD_VIEW, "direction"},
        {"direction infinite", {.dir = {0, 0, INFINITY}}, 0, ROBERTS_BAD_VIEW, "direction"},
        {"up no number", {.dir = {0, 0, 1}, .up = {NAN, 0, 0}}, 0, ROBERTS_BAD_VIEW, "up"},
        {"up infinite", {.dir = {0, 0, 1}, .up = {0, -INFINITY, 0}}, 0, ROBERTS_BAD_VIEW, "up"},
        {"oblique", {.dir = {0, 0, 1}, .oblique = {-3, 2}}, 0, ROBERTS_OK, ""},
        {"oblique, no number", {.dir = {0, 0, 1}, .oblique = {NAN, 0}}, 0, ROBERTS_BAD_VIEW, "oblique"},
        {"oblique, infinite", {.dir = {0, 0, 1}, .oblique = {0, -INFINITY}}, 0, ROBERTS_BAD_VIEW, "oblique"},
        {"oblique, too steep", {.dir = {0, 0, 1}, .oblique = {0, -1e6}}, 0, ROBERTS_BAD_VIEW, "oblique"},
        {"section no number",
         {.dir = {0, 0, 1}, .section = {0, NAN, 0}, .has_section = true},
         0,
         ROBERTS_BAD_VIEW,
         "section"},
        {"section not used", {.dir = {0, 0, 1}, .section = {0, NAN, 0}}, 0, ROBERTS_OK, ""},
        {"good eye", {ROBERTS_PERSPECTIVE, .eye = {0, 0, 9}}, 0, ROBERTS_OK, ""},
        {"eye no number", {ROBERTS_PERSPECTIVE, .eye = {0, 0, NAN}}, 0, ROBERTS_BAD_VIEW, "eye"},
        {"eye infinite", {ROBERTS_PERSPECTIVE, .eye = {-INFINITY, 0, 0}}, 0, ROBERTS_BAD_VIEW, "eye"},
        {"look-at infinite",
         {ROBERTS_PERSPECTIVE, .eye = {0, 0, 9}, .look_at = {INFINITY, 0, 0}, .has_look_at = true},
         0,
         ROBERTS_BAD_VIEW,
         "look-at"},
        {"look-at not used", {ROBERTS_PERSPECTIVE, .eye = {0, 0, 9}, .look_at = {INFINITY, 0, 0}}, 0, ROBERTS_OK, ""},
        {"eye at the centre", {ROBERTS_PERSPECTIVE, .eye = {0, 0, 0}}, 0, ROBERTS_BAD_VIEW, "eye"},
        {"eye at the look-at point",
         {ROBERTS_PERSPECTIVE, .eye = {0, 0, 9}, .look_at = {0, 0, 9}, .has_look_at = true},
         0,
         ROBERTS_BAD_VIEW,
         "eye"},
        {"eye inside", {ROBERTS_PERSPECTIVE, .eye = {0, 0.1, 0.2}}, 0, ROBERTS_BAD_VIEW, "in front of the eye"},
        {"eye on a face", {ROBERTS_PERSPECTIVE, .eye = {0, 0, 1}}, 0, ROBERTS_BAD_VIEW, "in front of the eye"},
        {"eye just off a face", {ROBERTS_PERSPECTIVE, .eye = {0, 0, 1 + 1e-7}}, 0, ROBERTS_BAD_VIEW, "in front of"},
        {"eye off a face", {ROBERTS_PERSPECTIVE, .eye = {0, 0, 1.01}}, 0, ROBERTS_OK, ""},
        {"scene behind",
         {ROBERTS_PERSPECTIVE, .eye = {0, 0, 9}, .look_at = {0, 0, 10}, .has_look_at = true},
         0,
         ROBERTS_BAD_VIEW,
         "behind"},
        {"scene beside",
         {ROBERTS_PERSPECTIVE, .eye = {0, 0, 9}, .look_at = {9, 0, 9}, .has_look_at = true},
         0,
         ROBERTS_BAD_VIEW,
         "in front of the eye"},
        {"epsilon below 0", {.dir = {0, 0, 1}}, -1, ROBERTS_BAD_ARGUMENT, "epsilon"},
        {"epsilon no number", {.dir = {0, 0, 1}}, NAN, ROBERTS_BAD_ARGUMENT, "epsilon"},
        {"epsilon infinite", {.dir = {0, 0, 1}}, INFINITY, ROBERTS_BAD_ARGUMENT, "epsilon"},
    };
    roberts_scene *scene = cube_scene((roberts_vec3){-1, -1, -1}, 2);
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        view v;
        roberts_error error = {0};
        roberts_status status = view_prepare(&v, scene, &table[i].camera, table[i].epsilon, &error);
        if (status != table[i].status || !strstr(error.message, table[i].message) ||
            (status != ROBERTS_OK && (error.status != status || error.message[0] == '\0')))
            fail_msg("%s: status %d, message \"%s\"", table[i].name, status, error.message);
        assert_int_equal(view_prepare(&v, scene, &table[i].camera, table[i].epsilon, NULL), status);
    }
    roberts_scene_free(scene);
}

/* ---- the touching distance ------------------------------------------------------------------------------------- */

static void epsilon_by_table(void **state)
{
    double ulp = DBL_EPSILON, diameter = 2 * sqrt(3);
    const struct {
        const char *name;
        roberts_vec3 low; /* of a cube of size 2 */
        roberts_camera camera;
        double given, expected;
        mesh_steps steps;
    } table[] = {
        {"by the diameter", {-1, -1, -1}, {.dir = {1, 2, 3}}, 0, 1e-11 * diameter, {0, 0}},
        {"by the diameter, off the origin", {1000, 0, 0}, {.dir = {1, 2, 3}}, 0, 1e-11 * diameter, {0, 0}},
        {"by the largest coordinate", {1e9, 0, 0}, {.dir = {1, 2, 3}}, 0, 16 * ulp * (1e9 + 2), {0, 0}},
        {"the same, negative", {0, -1e9, 0}, {.dir = {1, 2, 3}}, 0, 16 * ulp * 1e9, {0, 0}},
        {"by the eye", {-1, -1, -1}, {ROBERTS_PERSPECTIVE, .eye = {0, 1e9, 0}}, 0, 16 * ulp * 1e9, {0, 0}},
        {"eye not that far", {-1, -1, -1}, {ROBERTS_PERSPECTIVE, .eye = {0, 30, 0}}, 0, 1e-11 * diameter, {0, 0}},
        {"by 32-bit floats", {-1, -1, -1}, {.dir = {1, 2, 3}}, 0, 0x1p-22, {0x1p-22, 0}},
        {"by 32-bit floats, from an eye",
         {5, 5, 5},
         {ROBERTS_PERSPECTIVE, .eye = {0, 30, 0}},
         0,
         0x1p-20,
         {0x1p-20, 0}},
        {"floats that do not count", {1e9, 0, 0}, {.dir = {1, 2, 3}}, 0, 16 * ulp * (1e9 + 2), {0x1p-22, 0}},
        {"given, in spite of floats", {-1, -1, -1}, {.dir = {1, 2, 3}}, 1e-9, 1e-9, {0x1p-22, 0}},
        {"by decimals", {-1, -1, -1}, {.dir = {1, 2, 3}}, 0, 2e-6, {0x1p-22, 2e-6}},
        {"decimals finer than floats", {-1, -1, -1}, {.dir = {1, 2, 3}}, 0, 0x1p-22, {0x1p-22, 2e-9}},
        {"given, in spite of decimals", {-1, -1, -1}, {.dir = {1, 2, 3}}, 1e-9, 1e-9, {0, 2e-6}},
        {"given", {-1, -1, -1}, {.dir = {1, 2, 3}}, 1e-5, 1e-5, {0, 0}},
        {"given, below rounding", {1e9, 0, 0}, {.dir = {1, 2, 3}}, 1e-20, 1e-20, {0, 0}},
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        roberts_scene *scene = cube_scene(table[i].low, 2);
        view v;
        scene->steps = table[i].steps;
        assert_int_equal(view_prepare(&v, scene, &table[i].camera, table[i].given, NULL), ROBERTS_OK);
        double epsilon = v.epsilon * v.unit;
        if (fabs(epsilon - table[i].expected) > 1e-9 * table[i].expected)
            fail_msg("%s: %.17g, expected %.17g", table[i].name, epsilon, table[i].expected);
        assert_true(fabs(v.diameter * v.unit - diameter) < 1e-6);
        roberts_scene_free(scene);
    }
}

/* ---- sizes beyond squaring ------------------------------------------------------------------------------------- */

static void huge_and_tiny(void **state)
{
    static const double sizes[] = {1e150, 1e100, 1, 1e-100, 1e-150, 1e-290};
    static const roberts_vec3 unit_low = {-1, -0.5, -1};
    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        for (int perspective = 0; perspective < 2; perspective++) {
            roberts_scene *scene = cube_scene(vec3_scale(0.5 * sizes[i], unit_low), sizes[i]);
            roberts_camera camera = {.dir = {1, -1, 1}};
            if (perspective)
                camera = (roberts_camera){ROBERTS_PERSPECTIVE, .eye = vec3_scale(sizes[i], (roberts_vec3){3, -3, 3})};
            view v = prepare(scene, &camera);
            int exponent;
            assert_true(frexp(v.unit, &exponent) == 0.5);
            assert_true(fabs(v.diameter * (v.unit / sizes[i]) - sqrt(3)) < 1e-12);
            assert_true(v.epsilon > 0 && v.epsilon < 1e-9 && v.extent < 10 && v.rounding > 0 && v.rounding < v.epsilon);
            for (uint32_t k = 0; k < scene->vertex_count; k++) {
                roberts_vec3 p = view_point(&v, scene->point[k]);
                assert_true(vec3_length(p) > 1e-3 || fabs(p.x) + fabs(p.y) < 1e-12);
                assert_true(vec3_length(p) < 10);
            }
            assert_int_equal(facing_of(scene, &v, (roberts_vec3){-1, 0, 0}), VIEW_FRONT);
            assert_int_equal(facing_of(scene, &v, (roberts_vec3){1, 0, 0}), VIEW_BACK);
            roberts_scene_free(scene);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(presets_by_table),
        cmocka_unit_test(presets_that_are_none),
        cmocka_unit_test(presets_foreshorten),
        cmocka_unit_test(trimetric_has_three_scales),
        cmocka_unit_test(angles_by_table),
        cmocka_unit_test(angles_foreshorten),
        cmocka_unit_test(roll_turns_the_drawing),
        cmocka_unit_test(turning_goes_about_the_centre),
        cmocka_unit_test(windows),
        cmocka_unit_test(projected_points),
        cmocka_unit_test(oblique_presets),
        cmocka_unit_test(up_by_table),
        cmocka_unit_test(frames_at_random),
        cmocka_unit_test(up_nearly_parallel),
        cmocka_unit_test(orthographic_is_a_rigid_motion),
        cmocka_unit_test(together_as_one_by_one),
        cmocka_unit_test(perspective_pictures),
        cmocka_unit_test(close_to_the_eye),
        cmocka_unit_test(parameters_along_lines),
        cmocka_unit_test(oblique_sight_lines),
        cmocka_unit_test(planes_stay_planes),
        cmocka_unit_test(facing_by_table),
        cmocka_unit_test(facing_of_needles),
        cmocka_unit_test(refused_by_table),
        cmocka_unit_test(epsilon_by_table),
        cmocka_unit_test(huge_and_tiny),
    };
    return cmocka_run_group_tests_name("view", tests, NULL, NULL);
}
