/* test_bare_faces.c - triangles that are seen whole. Their regions are known before lines are hidden, which may not
 * change a bit of any region. So regions are found with one cell, in which no triangle is bare since the border of the
 * scene lies in it, and with many. */
#include <stdio.h>
#include <stdlib.h>

#include "hide/bare_faces.h"
#include "hide/tolerance.h"
#include "patches.h"
#include "roberts.h"

/* Squares of the sheet in each direction; their side is 1. */
enum { SIDE = 24 };

static const roberts_camera cameras[] = {
    {.dir = {0, 0, 1}, .up = {0, 1, 0}},
    {.dir = {0.21, -0.33, 1}, .up = {0, 1, 0}},
    {.dir = {0.4, 0.3, -1}, .up = {0, 1, 0}},
    {.projection = ROBERTS_PERSPECTIVE, .eye = {5, 3, 60}, .up = {0, 1, 0}},
    {.projection = ROBERTS_PERSPECTIVE,
     .eye = {5, 3, 20},
     .look_at = {12, 12, 0},
     .has_look_at = true,
     .up = {0, 1, 0},
     .near_distance = 20.1}, /* cuts the sheet */
};

enum { CAMERAS = sizeof cameras / sizeof cameras[0], CUT = CAMERAS - 1 };

/* ---- what lies on the sheet or near it ------------------------------------------------------------------------- */

static void add_nothing(sheet *s)
{
    (void)s;
}

static void add_tetrahedron(sheet *s, double x, double y, double z, double size)
{
    const uint32_t a = add_vertex(s, x, y, z), b = add_vertex(s, x + size, y, z), c = add_vertex(s, x, y + size, z),
                   d = add_vertex(s, x, y, z + size);
    add_face(s, a, c, b);
    add_face(s, a, b, d);
    add_face(s, b, c, d);
    add_face(s, c, a, d);
}

/* Its picture lies inside that of one triangle. */
static void add_floating(sheet *s)
{
    add_tetrahedron(s, 12.6, 12.2, 3, 0.05);
}

static void add_floating_in_grid(sheet *s)
{
    for (int k = 0; k < 6; k++)
        add_tetrahedron(s, 3.6 * k + 0.6, 3.6 * k + 0.1, 2, 0.2);
}

/* Exactly before a triangle, as seen from above. */
static void add_congruent(sheet *s)
{
    add_triangle(s, (roberts_vec3){10, 10, 4}, (roberts_vec3){11, 10, 4}, (roberts_vec3){11, 11, 4});
}

/* A second sheet, all of whose vertices have the same places. */
static void add_copy(sheet *s)
{
    rng r = {5};
    add_patch(s, &(patch){.step = 1, .rough = 0.2, .nx = SIDE, .ny = SIDE}, &r);
}

/* The same in part, in reverse, so that other faces have the same places. */
static void add_part_of_copy(sheet *s)
{
    rng r = {5};
    add_patch(s, &(patch){.step = 1, .rough = 0.2, .nx = 6, .ny = SIDE, .turned = 1}, &r);
}

static void add_upright(sheet *s)
{
    add_triangle(s, (roberts_vec3){6, 6, 1}, (roberts_vec3){9, 9, 1}, (roberts_vec3){9, 9, 5});
}

static void add_wire(sheet *s)
{
    const uint32_t corner[2] = {add_vertex(s, 1.3, 2.2, 4), add_vertex(s, 20.1, 17.7, 5)};
    mesh_face(&s->mesh, corner, 2);
}

/* Triangles in a triangle, on its sides, and beside it, within the touching distance of regions. */
static void add_slivers(sheet *s)
{
    add_triangle(s, (roberts_vec3){4.3, 4.1, 2}, (roberts_vec3){4.9, 4.2, 2}, (roberts_vec3){4.9, 4.2 + 1e-10, 2});
    add_triangle(s, (roberts_vec3){8, 8, 2}, (roberts_vec3){9, 8, 2}, (roberts_vec3){9, 8 + 1e-10, 2});
}

/* A face that stands on the sheet, in it, or nearly. */
static void add_touching(sheet *s)
{
    for (int k = 0; k < 4; k++) {
        const double z = k * 1e-12;
        add_triangle(s, (roberts_vec3){5.0 * k + 1, 3, z}, (roberts_vec3){5.0 * k + 3.5, 3.2, z},
                     (roberts_vec3){5.0 * k + 2, 6, z});
    }
}

static void add_piercing(sheet *s)
{
    for (int k = 0; k < 4; k++)
        add_triangle(s, (roberts_vec3){5.0 * k + 1, 3, -4}, (roberts_vec3){5.0 * k + 3.5, 3.2, 3},
                     (roberts_vec3){5.0 * k + 2, 6, 4});
}

/* A sheet close behind. */
static void add_lining(sheet *s)
{
    add_patch(s, &(patch){.z = -1e-7, .step = 0.75, .nx = 30, .ny = 30}, &(rng){6});
}

/* A rough sheet of squares that are not planar, beside the other one. */
static void add_squares(sheet *s)
{
    const uint32_t first = s->vertices;
    rng r = {7};
    for (int i = 0; i <= SIDE; i++)
        for (int j = 0; j <= SIDE; j++)
            add_vertex(s, SIDE + i, j, 0.2 * rng_between(&r, -1, 1));
    for (uint32_t i = 0; i < SIDE; i++)
        for (uint32_t j = 0; j < SIDE; j++) {
            const uint32_t v = first + i * (SIDE + 1) + j;
            const uint32_t corner[] = {v, v + SIDE + 1, v + SIDE + 2, v + 1};
            mesh_face(&s->mesh, corner, 4);
        }
}

/* A box, a convex solid, before the sheet, in it and behind it. */
static void add_boxes(sheet *s)
{
    for (int k = -1; k <= 1; k++)
        mesh_block(&s->mesh, (roberts_vec3){4 + 5 * k + 5, 11, 2.0 * k}, (roberts_vec3){2.2, 0.1, 0},
                   (roberts_vec3){0, 2.4, 0.1}, (roberts_vec3){0.1, 0, 1});
    s->vertices += 24;
}

static const struct {
    const char *name;
    void (*add)(sheet *s);
    bool first; /* the sheet follows */
    double rough;
    int hole[4];
    size_t bare; /* at least, seen from above */
} cases[] = {
    {"a sheet alone", add_nothing, false, 0.2, {0}, 800},
    {"a flat sheet", add_nothing, false, 0.0, {0}, 800},
    {"a rough sheet, which lies over itself", add_nothing, false, 4.0, {0}, 0},
    {"a hole", add_nothing, false, 0.2, {11, 12, 9, 14}, 700},
    {"a small body before one triangle", add_floating, false, 0.2, {0}, 700},
    {"... of smaller number", add_floating, true, 0.2, {0}, 700},
    {"... before a flat one", add_floating, false, 0.0, {0}, 700},
    {"small bodies", add_floating_in_grid, false, 0.2, {0}, 400},
    {"a triangle exactly before another", add_congruent, false, 0.2, {0}, 700},
    {"... of smaller number, flat", add_congruent, true, 0.0, {0}, 700},
    {"two sheets at one place", add_copy, false, 0.2, {0}, 0},
    {"part of another sheet at the same place", add_part_of_copy, false, 0.2, {0}, 300},
    {"... of smaller number", add_part_of_copy, true, 0.2, {0}, 300},
    {"a triangle seen edge-on", add_upright, false, 0.2, {0}, 700},
    {"a wire before the sheet", add_wire, false, 0.2, {0}, 400},
    {"slivers before the sheet", add_slivers, false, 0.2, {0}, 700},
    {"triangles that touch the sheet", add_touching, false, 0.0, {0}, 400},
    {"... of smaller number", add_touching, true, 0.0, {0}, 400},
    {"triangles through the sheet", add_piercing, false, 0.2, {0}, 400},
    {"a sheet close behind", add_lining, false, 0.0, {0}, 0},
    {"... of smaller number", add_lining, true, 0.0, {0}, 0},
    {"squares that are not planar beside the sheet", add_squares, false, 0.2, {0}, 700},
    {"... of smaller number", add_squares, true, 0.2, {0}, 700},
    {"boxes", add_boxes, false, 0.2, {0}, 400},
    {"... of smaller number", add_boxes, true, 0.2, {0}, 400},
};

static roberts_scene *scene_of_case(size_t i)
{
    sheet s = {0};
    const int *hole = cases[i].hole;
    const patch p = {
        .step = 1, .rough = cases[i].rough, .nx = SIDE, .ny = SIDE, .hole = {hole[0], hole[1], hole[2], hole[3]}};
    if (cases[i].first)
        cases[i].add(&s);
    add_patch(&s, &p, &(rng){5});
    if (!cases[i].first)
        cases[i].add(&s);
    roberts_scene *scene = scene_of_mesh(&s.mesh, NULL);
    roberts_mesh_free(&s.mesh);
    return scene;
}

/* ---- comparing --------------------------------------------------------------------------------------------------- */

static bool same_region(const roberts_region *a, const roberts_region *b)
{
    return a->solid == b->solid && a->face == b->face && a->area == b->area && a->z_min == b->z_min &&
           a->z_max == b->z_max && a->ring_count == b->ring_count && a->first_ring == b->first_ring &&
           memcmp(&a->normal, &b->normal, sizeof a->normal) == 0;
}

static void expect_same(const roberts_region_list *a, const roberts_region_list *b, const char *name)
{
    for (size_t i = 0; i < a->count && i < b->count; i++)
        if (!same_region(&a->region[i], &b->region[i]))
            fail_msg("%s: region %zu is of face %u, area %.17g, depths %.17g to %.17g; by one cell: face %u, area "
                     "%.17g, depths %.17g to %.17g",
                     name, i, b->region[i].face, b->region[i].area, b->region[i].z_min, b->region[i].z_max,
                     a->region[i].face, a->region[i].area, a->region[i].z_min, a->region[i].z_max);
    if (a->count != b->count || a->ring_count != b->ring_count || a->corner_count != b->corner_count)
        fail_msg("%s: %zu regions, %zu rings, %zu corners; by one cell: %zu, %zu, %zu", name, b->count, b->ring_count,
                 b->corner_count, a->count, a->ring_count, a->corner_count);
    assert_memory_equal(a->corner, b->corner, a->corner_count * sizeof *a->corner);
    assert_memory_equal(a->ring_start, b->ring_start, (a->ring_count + 1) * sizeof *a->ring_start);
    assert_memory_equal(a->slope, b->slope, a->count * sizeof *a->slope);
}

static roberts_region_list regions_of(const roberts_scene *scene, const roberts_camera *camera, uint32_t grid,
                                      uint32_t threads, double crease)
{
    roberts_hide_options options = roberts_hide_options_default();
    roberts_region_list list;
    roberts_drawing drawing;
    options.grid = grid;
    options.threads = threads;
    options.crease_degrees = crease;
    if (crease == 0.0) {
        assert_int_equal(roberts_regions(scene, camera, &options, &list, NULL), ROBERTS_OK);
        return list;
    }
    assert_int_equal(roberts_hide_with_regions(scene, camera, &options, &drawing, &list, NULL), ROBERTS_OK);
    roberts_drawing_free(&drawing);
    return list;
}

static void test_same_regions(void **state)
{
    static const uint32_t grids[] = {0, 9, 24, 37}, threads[] = {1, 3, 1, 2};
    static const double crease[] = {0, 5, 40, 170};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_scene *scene = scene_of_case(i);
        for (size_t c = 0; c < CAMERAS; c++) {
            roberts_region_list one = regions_of(scene, &cameras[c], 1, 1, 0);
            for (size_t g = 0; g < sizeof grids / sizeof grids[0]; g++) {
                char name[120];
                snprintf(name, sizeof name, "%s, camera %zu, grid %u", cases[i].name, c, grids[g]);
                roberts_region_list many = regions_of(scene, &cameras[c], grids[g], threads[g], crease[g]);
                expect_same(&one, &many, name);
                roberts_regions_free(&many);
            }
            roberts_regions_free(&one);
        }
        roberts_scene_free(scene);
    }
}

/* ---- which faces are bare ---------------------------------------------------------------------------------------- */

static size_t count_bare(const roberts_scene *scene, const roberts_camera *camera, uint32_t side)
{
    const roberts_hide_options options = roberts_hide_options_default();
    hide_fronts fronts;
    seen s;
    double depth;
    objet grid;
    size_t count = 0;
    assert_int_equal(seen_begin(&s, scene, camera, 0.0, NULL), ROBERTS_OK);
    seen_set_rules(&s, &options);
    assert_true(hide_fronts_build(&fronts, &s, &options, true));
    const cells_boxes boxes = {fronts.front_box, fronts.front_count, fronts.low, fronts.high,
                               hide_margin(&fronts.space)};
    assert_int_equal(objet_build(&grid, &fronts, cells_for_lists(&boxes, side, &depth), 1), ROBERTS_OK);
    assert_true(bare_faces_find(&fronts, &grid, 1e-6, 1, &s.sight));
    for (uint32_t f = 0; s.sight && f < s.scene->face_count; f++)
        count += s.sight[f] == SEEN_WHOLE;
    objet_free(&grid);
    hide_fronts_free(&fronts);
    seen_end(&s);
    return count;
}

/* Most triangles of a sheet are bare, and none is with one cell, or where the near plane cuts. */
static void test_bare(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_scene *scene = scene_of_case(i);
        const size_t bare = count_bare(scene, &cameras[0], 30);
        if (bare < cases[i].bare)
            fail_msg("%s: %zu bare faces, at least %zu expected", cases[i].name, bare, cases[i].bare);
        assert_int_equal(count_bare(scene, &cameras[0], 1), 0);
        assert_int_equal(count_bare(scene, &cameras[CUT], 30), 0);
        roberts_scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bare),
        cmocka_unit_test(test_same_regions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
