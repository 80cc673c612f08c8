/* Signs and crossings in twice the precision, against exact integers. All coordinates are integers below 2^18, or along
 * one axis alone up to 2^20, so that determinants fit into 63 bits; each test chooses which of them are zero or nearly
 * zero. */
#include "hide/tests.h"

#include "hide/tolerance.h"
#include "scenes.h"
#include "whole.h"

/* Half a unit of the last place of a parameter in space, and a few more on its way to the picture. */
#define T_BOUND 1e-15

/* A tetrahedron with any four corners, the points of the tests; others, for the box round the scene, stand by. */
typedef struct fixture {
    roberts_scene *scene;
    view view;
    roberts_vec3 P[64];
    hide_space space;
} fixture;

static roberts_vec3 real(whole a)
{
    return (roberts_vec3){(double)a.x, (double)a.y, (double)a.z};
}

static whole random_whole(rng *r, int size)
{
    return (whole){rng_int(r, -size, size), rng_int(r, -size, size), rng_int(r, -size, size)};
}

/* Solid 0 is a tetrahedron of vertices 0..3, solid 1 one of 4..7. */
static void add_tetrahedron(model *m, const whole p[4])
{
    model_tetrahedron(m, (roberts_vec3[]){real(p[0]), real(p[1]), real(p[2]), real(p[3])});
}

static int64_t volume(const whole p[4])
{
    return whole_dot(whole_cross(whole_sub(p[1], p[0]), whole_sub(p[2], p[0])), whole_sub(p[3], p[0]));
}

static void set_up(fixture *f, const model *m, const roberts_camera *camera)
{
    roberts_error error = {0};
    f->scene = model_build(m);
    if (view_prepare(&f->view, f->scene, camera, 0, &error) != ROBERTS_OK)
        fail_msg("refused: %s", error.message);
    for (uint32_t i = 0; i < f->scene->vertex_count; i++)
        f->P[i] = view_point(&f->view, f->scene->point[i]);
    f->space = (hide_space){
        .P = f->P, .epsilon = f->view.epsilon, .rounding = f->view.rounding, .scene = f->scene, .view = &f->view};
}

static hide_edge edge_between(const fixture *f, uint32_t a, uint32_t b)
{
    return (hide_edge){.A = f->P[a], .B = f->P[b], .a = a, .b = b, .length3 = vec3_length(vec3_sub(f->P[b], f->P[a]))};
}

/* The same edge, its second end not a vertex but the sum of two points. Left alone, `place->point` would be as far from
 * it as `off` says. */
static hide_edge with_computed_end(hide_edge e, const fixture *f, seen_point place[2], double off)
{
    roberts_vec3 b = f->scene->point[e.b];
    place[1] = (seen_point){{b.x - off, b.y, b.z + off}, {off, 0.0, -off}};
    e.b = ROBERTS_NONE;
    e.end = place;
    return e;
}

/* The viewpoint V: a direction, or an eye well off all points, which lie within +-2^10; the scene looks at it. */
static roberts_camera camera_from(whole V, bool perspective)
{
    if (perspective)
        return (roberts_camera){ROBERTS_PERSPECTIVE, .eye = real(V)};
    return (roberts_camera){.dir = real(V)};
}

static whole random_viewpoint(rng *r, bool perspective)
{
    whole V = random_whole(r, 1000);
    V.z = perspective ? rng_int(r, 20000, 200000) : rng_int(r, 1, 1000);
    return V;
}

/* > 0 where x is left of p -> q seen from V. */
static int64_t side(whole p, whole q, whole x, whole V, bool perspective)
{
    if (perspective)
        return -whole_dot(whole_cross(whole_sub(p, V), whole_sub(q, V)), whole_sub(x, V));
    return whole_dot(whole_cross(whole_sub(q, p), whole_sub(x, p)), V);
}

/* Two tetrahedra of random corners. In every second pair, vertex 4 lies in or nearly in the sight plane through 0 and
 * 1. */
static void random_scene(rng *r, fixture *f, whole p[8], whole *V, bool perspective, bool close)
{
    model m = {0};
    for (;;) {
        for (int i = 0; i < 8; i++)
            p[i] = random_whole(r, 1000);
        *V = random_viewpoint(r, perspective);
        if (close) {
            int k = rng_int(r, -3, 3), away = perspective ? 0 : rng_int(r, 0, 2);
            p[4] = (whole){p[0].x + k * (p[1].x - p[0].x) + away * V->x, p[0].y + k * (p[1].y - p[0].y) + away * V->y,
                           p[0].z + k * (p[1].z - p[0].z) + away * V->z};
            p[4].x += rng_int(r, -1, 1);
        }
        double size = 1e-3 * 2000.0 * 2000.0 * 2000.0; /* well beyond what counts as flat */
        if (fabs((double)volume(p)) > size && fabs((double)volume(p + 4)) > size)
            break;
    }
    add_tetrahedron(&m, p);
    add_tetrahedron(&m, p + 4);
    roberts_camera camera = camera_from(*V, perspective);
    set_up(f, &m, &camera);
    model_free(&m);
}

/* The sign is that of the determinant, zero exactly where that is; the size is the distance in the picture. */
static void sides_against_integers(void **state)
{
    rng r = {61};
    size_t zeros = 0, small = 0;
    (void)state;
    for (int i = 0; i < 4000; i++) {
        fixture f;
        whole p[8], V;
        bool perspective = i % 2;
        random_scene(&r, &f, p, &V, perspective, i % 4 > 1);
        int64_t exact = side(p[0], p[1], p[4], V, perspective);
        double distance = refine_side(&f.space, 0, 1, refine_vertex(&f.space, 4)),
               back = refine_side(&f.space, 1, 0, refine_vertex(&f.space, 4));
        seen_point place[2];
        hide_edge computed = with_computed_end(edge_between(&f, 5, 4), &f, place, 0.25);
        assert_true(fabs(refine_side(&f.space, 0, 1, refine_end(&computed)) - distance) <= 1e-14 * fabs(distance));
        assert_true((exact > 0) == (distance > 0) && (exact < 0) == (distance < 0));
        assert_true(fabs(distance + back) <= 1e-15 * fabs(distance));
        refine_near near = refine_side_nearly(&f.space, 0, 1, refine_vertex(&f.space, 4));
        assert_true(fabs(near.value - distance) <= near.error && near.error <= 1e-13 * f.view.extent);
        near = refine_side_nearly(&f.space, 0, 1, refine_end(&computed));
        assert_true(fabs(near.value - distance) <= near.error && near.error <= 1e-13 * f.view.extent);
        zeros += exact == 0;
        small += exact != 0 && fabs(distance) < 1e-3;
        double dx = f.P[1].x - f.P[0].x, dy = f.P[1].y - f.P[0].y, length = hypot(dx, dy);
        double rough = (dx * (f.P[4].y - f.P[0].y) - dy * (f.P[4].x - f.P[0].x)) / length;
        double reach = hypot(f.P[4].x - f.P[0].x, f.P[4].y - f.P[0].y);
        assert_true(fabs(rough - distance) <= 4 * f.view.across_rounding * (1 + reach / length));
        roberts_scene_free(f.scene);
    }
    assert_true(zeros > 100 && small > 100);
}

/* On vertices 4 and 5 the sight plane through 0 and 1 takes the values a and b: it is crossed at a / (a - b)
 * in space. */
static void crossings_against_fractions(void **state)
{
    rng r = {62};
    size_t tried = 0, left = 0;
    (void)state;
    for (int i = 0; i < 4000; i++) {
        fixture f;
        whole p[8], V;
        bool perspective = i % 2;
        random_scene(&r, &f, p, &V, perspective, i % 4 > 1);
        int64_t a = side(p[0], p[1], p[4], V, perspective), b = side(p[0], p[1], p[5], V, perspective);
        if ((a < 0) != (b < 0) && a != b) {
            hide_edge e = edge_between(&f, 4, 5), turned = edge_between(&f, 5, 4);
            seen_point place[2];
            hide_edge computed = with_computed_end(e, &f, place, 0.25);
            double exact = (double)((long double)a / (long double)(a - b));
            double t = view_to_space(&f.view, e.A.z, e.B.z, refine_crossing(&f.space, 0, 1, &e));
            double back = view_to_space(&f.view, e.B.z, e.A.z, refine_crossing(&f.space, 0, 1, &turned)), near;
            if (refine_crossing_nearly(&f.space, 0, 1, i % 8 < 4 ? &e : &computed, &near))
                assert_true(fabs(near - refine_crossing(&f.space, 0, 1, &e)) <= HIDE_T_ACCURACY);
            else
                left++;
            assert_true(fabs(t - exact) <= T_BOUND);
            assert_true(fabs(back - (1 - exact)) <= T_BOUND);
            assert_true(fabs(refine_crossing(&f.space, 0, 1, &computed) - refine_crossing(&f.space, 0, 1, &e)) <=
                        T_BOUND);
            assert_true(fabs(refine_crossing(&f.space, 1, 0, &e) - refine_crossing(&f.space, 0, 1, &e)) <= T_BOUND);
            tried++;
        }
        roberts_scene_free(f.scene);
    }
    assert_true(tried > 1000);
    assert_true(left < tried / 100); /* nearly all crossings are accurate in doubles */
}

/* The plane through 0, 1 and 2, likewise; the face's corner list may begin anywhere. */
static void piercings_against_fractions(void **state)
{
    rng r = {63};
    size_t tried = 0;
    (void)state;
    for (int i = 0; i < 4000; i++) {
        fixture f;
        whole p[8], V;
        random_scene(&r, &f, p, &V, i % 2, false);
        whole n = whole_cross(whole_sub(p[1], p[0]), whole_sub(p[2], p[0]));
        int64_t a = whole_dot(n, whole_sub(p[4], p[0])), b = whole_dot(n, whole_sub(p[5], p[0]));
        if ((a < 0) != (b < 0)) {
            static const uint32_t corner[3][3] = {{0, 1, 2}, {1, 2, 0}, {2, 1, 0}};
            hide_face F = {.corner = corner[i % 3], .count = 3};
            hide_edge e = edge_between(&f, 4, 5);
            double t = view_to_space(&f.view, e.A.z, e.B.z, refine_pierce(&f.space, &F, &e));
            assert_true(fabs(t - (double)((long double)a / (long double)(a - b))) <= T_BOUND);
            seen_point place[2];
            e = with_computed_end(e, &f, place, 0.25);
            assert_true(fabs(view_to_space(&f.view, e.A.z, e.B.z, refine_pierce(&f.space, &F, &e)) - t) <= T_BOUND);
            tried++;
        }
        roberts_scene_free(f.scene);
    }
    assert_true(tried > 1000);
}

/* An edge that passes a plane at an angle of 1e-6 or less: from view coordinates the crossing is known to 1e-10, here
 * to the last place. The plate's corners have integer coordinates up to 1000, its plane is 0.001 x - 0.002 y + z
 * = 0. */
static void grazing_pierce(void **state)
{
    static const roberts_vec3 eye = {300, -200, 90000};
    (void)state;
    for (int k = 1; k < 40; k++)
        for (int perspective = 0; perspective < 2; perspective++) {
            fixture f;
            model m = {0};
            roberts_camera camera = {.dir = {0.3, 0.2, 1}};
            if (perspective)
                camera = (roberts_camera){ROBERTS_PERSPECTIVE, .eye = eye};
            /* plate: images of (+-1000, +-1000, 0) and their copies 100 below */
            model_add(&m, &shapes[SHAPE_CUBE], (mat3){{1000, 0, -1}, {0, 1000, 2}, {0, 0, 50}},
                      (roberts_vec3){0, 0, -50});
            /* rod from 3 units of 2^-20 above the plane to k below, or rather its wedge's edge 0-1 (vertices 8, 9) */
            roberts_vec3 A = {-700, 100, 0.7 + 0.2 + 3 * 0x1p-20}, B = {500, -300, -0.5 - 0.6 - k * 0x1p-20};
            model_add(&m, &shapes[SHAPE_WEDGE], (mat3){vec3_scale(0.5, vec3_sub(B, A)), {0, 50, 0}, {0, 0, 50}},
                      vec3_add(vec3_scale(0.5, vec3_add(A, B)), (roberts_vec3){0, 50, 50}));
            set_up(&f, &m, &camera);
            uint32_t plate[4] = {4, 5, 7, 6};
            hide_face F = {.corner = plate, .count = 4};
            hide_edge e = edge_between(&f, 8, 9);
            roberts_vec3 a = f.scene->point[8], b = f.scene->point[9];
            long double fa = 0.001L * a.x - 0.002L * a.y + a.z, fb = 0.001L * b.x - 0.002L * b.y + b.z;
            double exact = (double)(fa / (fa - fb));
            double t = view_to_space(&f.view, e.A.z, e.B.z, refine_pierce(&f.space, &F, &e));
            assert_true(fa > 0 && fb < 0);
            if (fabs(t - exact) > 1e-12) /* 2^-64 of 1, the sums' error, over fa - fb */
                fail_msg("%d: %.17g, expected %.17g", k, t, exact);
            roberts_scene_free(f.scene);
            model_free(&m);
        }
}

/* z along the axis given, x and y along the others. */
static whole along(int axis, int x, int y, int z)
{
    return axis == 0 ? (whole){z, x, y} : axis == 1 ? (whole){x, z, y} : (whole){x, y, z};
}

/* A corner of a scene 2^21 deep and 40 wide, seen along the axis given. */
static whole deep_corner(rng *r, int axis)
{
    int x = rng_int(r, -20, 20), y = rng_int(r, -20, 20), z = rng_int(r, -(1 << 20), 1 << 20);
    return along(axis, x, y, z);
}

/* In a deep view x and y are bounded, with their errors, by what they are made of, and by how far depth leaks into them
 * where the sight line is not quite along the axis; from an eye as well, far away or near. Distances in the picture are
 * off by no more than the tests allow for: 2 bounds (1 + reach / length). */
static void deep_views(void **state)
{
    rng r = {64};
    size_t sharp[2] = {0, 0};
    (void)state;
    for (int i = 0; i < 3000; i++) {
        fixture f;
        model m = {0};
        whole p[8];
        int axis = i % 3, aslant = i % 2, from_eye = i % 4 > 1;
        do
            for (int k = 0; k < 8; k++)
                p[k] = deep_corner(&r, axis);
        while (llabs(volume(p)) < 100000000 || llabs(volume(p + 4)) < 100000000);
        int x = aslant * rng_int(&r, -3, 3), y = aslant * rng_int(&r, -3, 3), z = aslant ? 1 << 20 : 3;
        roberts_camera camera = {.dir = real(along(axis, x, y, z)), .up = real(random_whole(&r, 9))};
        if (from_eye) { /* before them, or so near that most is taken from the eye itself; it looks anywhere
                         * along them */
            camera.projection = ROBERTS_PERSPECTIVE;
            camera.eye =
                real(along(axis, rng_int(&r, -9, 9), rng_int(&r, -9, 9), (i % 8 > 3 ? 3 << 19 : 20 << 19) + i));
            camera.has_look_at = i % 16 > 3;
            camera.look_at = real(along(axis, x, y, rng_int(&r, -(1 << 20), 1 << 20)));
        }
        add_tetrahedron(&m, p);
        add_tetrahedron(&m, p + 4);
        set_up(&f, &m, &camera);
        assert_true(f.view.across_rounding <= f.view.rounding && f.view.across <= f.view.extent);
        sharp[from_eye] += f.view.across_rounding < 1e-2 * f.view.rounding && f.view.across < 1e-2 * f.view.extent;
        for (uint32_t k = 0; k < f.scene->vertex_count; k++)
            assert_true(fabs(f.P[k].x) <= f.view.across && fabs(f.P[k].y) <= f.view.across);
        for (uint32_t x4 = 4; x4 < 8; x4++) {
            roberts_vec3 d = vec3_sub(f.P[1], f.P[0]), e = vec3_sub(f.P[x4], f.P[0]);
            double length = hypot(d.x, d.y), reach = fabs(e.x) + fabs(e.y);
            double error =
                fabs((d.x * e.y - d.y * e.x) / length - refine_side(&f.space, 0, 1, refine_vertex(&f.space, x4)));
            assert_true(length == 0.0 || error <= 2 * f.view.across_rounding * (1 + reach / length));
        }
        roberts_scene_free(f.scene);
        model_free(&m);
    }
    assert_true(sharp[0] > 1000 && sharp[1] > 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sides_against_integers),
        cmocka_unit_test(deep_views),
        cmocka_unit_test(crossings_against_fractions),
        cmocka_unit_test(piercings_against_fractions),
        cmocka_unit_test(grazing_pierce),
    };
    return cmocka_run_group_tests_name("refine", tests, NULL, NULL);
}
