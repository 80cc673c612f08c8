/* test_verify_bodies.c - --verify and --pick on bodies that are not convex: faces that hide from both sides, edges in
 * parts, curved bodies. See also test_verify_spoiled.c. */
#include "roberts.h"
#include "scenes.h"
#include "build_scene.h"

static void add_vertices(roberts_mesh *mesh, const double (*p)[3], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        roberts_vec3 at = {p[i][0], p[i][1], p[i][2]};
        mesh_vertex(mesh, at);
    }
}

static void add_face(roberts_mesh *mesh, const uint32_t *corner, size_t count)
{
    mesh_face(mesh, corner, count);
}

static roberts_drawing draw(const roberts_scene *scene, const roberts_camera *camera)
{
    return drawing_of(scene, camera, NULL);
}

static roberts_verification verify(const roberts_scene *scene, const roberts_camera *camera,
                                   const roberts_drawing *drawing, const roberts_verify_options *options)
{
    roberts_verification found;
    assert_int_equal(roberts_verify(scene, camera, drawing, options, &found, NULL), ROBERTS_OK);
    return found;
}

/* An L of depth 1, wound outward or inward: faces 0 to 5 are its sides, 6 its bottom, 7 its top. */
static roberts_scene *l_block(bool inward)
{
    static const double p[12][3] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0},
                                    {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}};
    roberts_mesh mesh = {0};
    uint32_t corner[6];
    add_vertices(&mesh, p, 12);
    for (uint32_t f = 0; f < 8; f++) {
        uint32_t next = (f + 1) % 6, side[4] = {f, next, 6 + next, 6 + f};
        uint32_t count = f < 6 ? 4 : 6;
        for (uint32_t k = 0; k < count; k++)
            corner[inward ? count - 1 - k : k] = f < 6 ? side[k] : f == 6 ? 5 - k : 6 + k;
        add_face(&mesh, corner, count);
    }
    return build_scene(&mesh);
}

/* All faces on the sight line are met, whichever way they are wound. Seen from the top, the picture's origin is (1, 1),
 * at height 0.5. */
static void test_pick(void **state)
{
    const roberts_camera camera = {.dir = {0, 0, 1}, .up = {0, 1, 0}};
    (void)state;
    for (int inward = 0; inward < 2; inward++) {
        roberts_scene *scene = l_block(inward);
        roberts_picked picked;
        assert_int_equal(roberts_pick(scene, &camera, -0.5, 0.5, &picked, NULL), ROBERTS_OK);
        assert_int_equal(picked.count, 2);
        assert_int_equal(picked.hit[0].face, 7);
        assert_true(fabs(picked.hit[0].depth - 0.5) < 1e-14);
        assert_int_equal(picked.hit[1].face, 6);
        assert_true(fabs(picked.hit[1].depth + 0.5) < 1e-14);
        roberts_picked_free(&picked);
        assert_int_equal(roberts_pick(scene, &camera, 0.5, 0.5, &picked, NULL), ROBERTS_OK);
        assert_int_equal(picked.count, 0); /* where the L has its notch */
        roberts_picked_free(&picked);
        roberts_scene_free(scene);
    }
}

/* The arm of an L hides a part of the L itself: a drawing that shows it is wrong. */
static void test_own_faces_hide(void **state)
{
    const roberts_camera camera = {.dir = {-1, 3, 1}};
    (void)state;
    for (int inward = 0; inward < 2; inward++) {
        roberts_scene *scene = l_block(inward);
        roberts_drawing drawing = draw(scene, &camera);
        size_t cut = drawing.count;
        assert_int_equal(verify(scene, &camera, &drawing, NULL).contradictions, 0);
        for (size_t i = 0; i < drawing.count; i++)
            if (drawing.segment[i].t1 - drawing.segment[i].t0 < 1.0)
                cut = i;
        assert_true(cut < drawing.count);
        drawing.segment[cut].t0 = 0.0;
        drawing.segment[cut].t1 = 1.0;
        roberts_verification found = verify(scene, &camera, &drawing, NULL);
        assert_true(found.contradictions > 0);
        assert_int_equal(found.first.v0, drawing.segment[cut].v0);
        assert_int_equal(found.first.v1, drawing.segment[cut].v1);
        assert_int_equal(found.first.drawn, ROBERTS_VISIBLE);
        assert_int_equal(found.first.by, 0);
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
}

/* A wall on a part of the floor's border: the border, 0-1, comes in two parts, and rows name it by t along the whole.
 * Nothing hides anything here, so what is left out is wrong. */
static void test_parts(void **state)
{
    static const double p[][3] = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {1, 0, 0}, {1, 0, 2}, {0, 0, 2}};
    const roberts_camera camera = {.dir = {1, 3, 2}};
    roberts_mesh mesh = {0};
    (void)state;
    add_vertices(&mesh, p, 7);
    add_face(&mesh, (uint32_t[]){0, 1, 2, 3}, 4);
    add_face(&mesh, (uint32_t[]){0, 4, 5, 6}, 4);
    roberts_scene *scene = build_scene(&mesh);
    roberts_drawing drawing = draw(scene, &camera);
    size_t last = drawing.count;
    assert_int_equal(verify(scene, &camera, &drawing, NULL).contradictions, 0);
    for (size_t i = 0; i < drawing.count; i++)
        if (drawing.segment[i].v0 == 0 && drawing.segment[i].v1 == 1)
            last = i;
    assert_true(last < drawing.count && drawing.segment[last].t0 == 0.25);
    assert_true(drawing.segment[last].t1 == 1.0);
    drawing.segment[last].t1 = 0.5;
    roberts_verification found = verify(scene, &camera, &drawing, NULL);
    assert_true(found.contradictions > 0);
    assert_int_equal(found.first.v0, 0);
    assert_int_equal(found.first.v1, 1);
    assert_int_equal(found.first.drawn, ROBERTS_HIDDEN);
    assert_true(found.first.t > 0.5 && found.first.t < 1.0);
    drawing.segment[last].v1 = 5; /* no edge */
    assert_int_equal(roberts_verify(scene, &camera, &drawing, NULL, &found, NULL), ROBERTS_BAD_ARGUMENT);
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
}

/* A bowl of many faces. Its flat edges are left out. That is no fault, unless the options say that they are drawn. */
static void test_smooth(void **state)
{
    enum { SIDE = 24 };
    const roberts_camera camera = {.dir = {1, 2, 6}};
    roberts_mesh mesh = {0};
    (void)state;
    for (int i = 0; i < SIDE * SIDE; i++) {
        double x = i % SIDE - SIDE / 2, y = i / SIDE - SIDE / 2;
        roberts_vec3 at = {x, y, 0.01 * (x * x + y * y)};
        mesh_vertex(&mesh, at);
    }
    for (uint32_t i = 0; i + 1 < SIDE; i++)
        for (uint32_t k = 0; k + 1 < SIDE; k++) {
            uint32_t a = i * SIDE + k;
            add_face(&mesh, (uint32_t[]){a, a + 1, a + SIDE + 1}, 3);
            add_face(&mesh, (uint32_t[]){a, a + SIDE + 1, a + SIDE}, 3);
        }
    roberts_scene *scene = build_scene(&mesh);
    roberts_drawing drawing = draw(scene, &camera);
    roberts_verify_options options = roberts_verify_options_default();
    assert_int_equal(verify(scene, &camera, &drawing, NULL).contradictions, 0);
    options.crease_auto = false;
    assert_true(verify(scene, &camera, &drawing, &options).contradictions > 100);
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
}

/* Corners 1 and 2 coincide in the coordinate plane of both faces, so that the edge 2-3 ends at no corner of a piece.
 * The near plane takes the first face, and leaves a part of the edge. The row then belongs to one face alone. */
static void test_first_face_taken(void **state)
{
    static const double p[5][3] = {{0, 0, 0}, {0, 3, 0}, {0, 3, 2}, {4, 3, 0}, {0, 6, 3}};
    static const uint32_t face[2][4] = {{0, 1, 2, 3}, {4, 1, 2, 3}};
    const roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE,
                                   .eye = {1, 4, -1},
                                   .has_look_at = true,
                                   .look_at = {1, 4, 10},
                                   .up = {0, 1, 0},
                                   .near_distance = 1.5};
    roberts_mesh mesh = {0};
    size_t rows = 0;
    (void)state;
    add_vertices(&mesh, p, 5);
    add_face(&mesh, face[0], 4);
    add_face(&mesh, face[1], 4);
    roberts_scene *scene = build_scene(&mesh);
    roberts_drawing drawing = draw(scene, &camera);
    assert_int_equal(verify(scene, &camera, &drawing, NULL).contradictions, 0);
    for (size_t i = 0; i < drawing.count; i++) {
        const roberts_segment *s = &drawing.segment[i];
        if (s->v0 != 2 || s->v1 != 3)
            continue;
        assert_int_equal(s->line, ROBERTS_BORDER);
        assert_true(s->t0 == 0.0 && s->t1 == 0.75);
        rows++;
    }
    assert_int_equal(rows, 1);
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pick),   cmocka_unit_test(test_own_faces_hide),   cmocka_unit_test(test_parts),
        cmocka_unit_test(test_smooth), cmocka_unit_test(test_first_face_taken),
    };
    return cmocka_run_group_tests_name("verify_bodies", tests, NULL, NULL);
}
