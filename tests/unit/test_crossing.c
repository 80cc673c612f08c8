/* test_crossing.c - where two faces cross: hand-made pairs of every kind, in all orders and orientations; random
 * triangles with integer corners, compared with whole numbers to the last bit. */
#include "model/crossing.h"
#include "scenes.h"

enum { MOST_LINES = 3 };

typedef struct pair_case {
    const char *name, *off; /* two faces, or more: the first two are tested */
    size_t count;
    double line[MOST_LINES][6];
} pair_case;

#define SQUARE_VERTICES "0 0 0\n4 0 0\n4 4 0\n0 4 0\n"
#define STAR "0 -10 0\n6 8 0\n-9 -3 0\n9 -3 0\n-6 8 0\n"

static const pair_case cases[] = {
    {"one through the other",
     "8 2 0\n" SQUARE_VERTICES "1 2 -1\n3 2 -1\n3 2 1\n1 2 1\n4 0 1 2 3\n4 4 5 6 7\n",
     1,
     {{1, 2, 0, 3, 2, 0}}},
    {"partly beyond it",
     "8 2 0\n" SQUARE_VERTICES "3 2 -1\n7 2 -1\n7 2 1\n3 2 1\n4 0 1 2 3\n4 4 5 6 7\n",
     1,
     {{3, 2, 0, 4, 2, 0}}},
    {"apart", "8 2 0\n" SQUARE_VERTICES "5 2 -1\n7 2 -1\n7 2 1\n5 2 1\n4 0 1 2 3\n4 4 5 6 7\n", 0, {{0}}},
    {"stands on it", "8 2 0\n" SQUARE_VERTICES "1 2 0\n3 2 0\n3 2 1\n1 2 1\n4 0 1 2 3\n4 4 5 6 7\n", 0, {{0}}},
    {"touches it with a corner", "7 2 0\n" SQUARE_VERTICES "2 2 0\n3 2 1\n1 2 1\n4 0 1 2 3\n3 4 5 6\n", 0, {{0}}},
    {"pokes through by less than what touches",
     "8 2 0\n" SQUARE_VERTICES "1 2 -1e-12\n3 2 -1e-12\n3 2 1\n1 2 1\n4 0 1 2 3\n4 4 5 6 7\n",
     0,
     {{0}}},
    {"... by more",
     "8 2 0\n" SQUARE_VERTICES "1 2 -1e-9\n3 2 -1e-9\n3 2 1\n1 2 1\n4 0 1 2 3\n4 4 5 6 7\n",
     1,
     {{1, 2, 0, 3, 2, 0}}},
    {"their borders only meet", "7 2 0\n" SQUARE_VERTICES "4 1 -1\n4 3 -1\n6 2 2\n4 0 1 2 3\n3 4 5 6\n", 0, {{0}}},
    {"in one plane", "8 2 0\n" SQUARE_VERTICES "1 1 0\n5 1 0\n5 5 0\n1 5 0\n4 0 1 2 3\n4 4 5 6 7\n", 0, {{0}}},
    {"parallel", "8 2 0\n" SQUARE_VERTICES "1 1 1\n5 1 1\n5 5 1\n1 5 1\n4 0 1 2 3\n4 4 5 6 7\n", 0, {{0}}},
    {"share a side", "6 2 0\n" SQUARE_VERTICES "4 0 3\n0 0 3\n4 0 1 2 3\n4 0 1 4 5\n", 0, {{0}}},
    {"share a corner and cross from there on",
     "5 2 0\n0 0 0\n4 -4 0\n4 4 0\n4 0 -2\n4 0 2\n3 0 1 2\n3 0 3 4\n",
     1,
     {{0, 0, 0, 4, 0, 0}}},
    {"share a corner and nothing else", "5 2 0\n0 0 0\n4 -4 0\n4 4 0\n-4 0 -2\n-4 0 2\n3 0 1 2\n3 0 3 4\n", 0, {{0}}},
    {"share two corners, a diagonal of both",
     "6 2 0\n" SQUARE_VERTICES "0 0 4\n4 4 -4\n4 0 1 2 3\n4 0 4 2 5\n",
     1,
     {{0, 0, 0, 4, 4, 0}}},
    {"a side runs through a corner",
     "6 2 0\n0 0 0\n4 0 0\n0 4 0\n0 0 -1\n0 0 1\n4 4 0\n3 0 1 2\n3 3 4 5\n",
     1,
     {{0, 0, 0, 2, 2, 0}}},
    {"a corner ends on a side",
     "7 2 0\n" SQUARE_VERTICES "2 0 -1\n2 4 0\n2 0 1\n4 0 1 2 3\n3 4 5 6\n",
     1,
     {{2, 0, 0, 2, 4, 0}}},
    {"a comb",
     "12 2 0\n-1 -1 0\n9 -1 0\n9 1 0\n-1 1 0\n0 0 2\n0 0 -2\n2 0 -2\n2 0 1\n4 0 1\n4 0 -2\n6 0 -2\n6 0 2\n4 0 1 2 3\n"
     "8 4 5 6 7 8 9 10 11\n",
     2,
     {{0, 0, 0, 2, 0, 0}, {4, 0, 0, 6, 0, 0}}},
    {"a tooth that ends in the plane parts nothing",
     "11 2 0\n-1 -1 0\n9 -1 0\n9 1 0\n-1 1 0\n0 0 2\n0 0 -2\n6 0 -2\n6 0 2\n4 0 2\n3 0 0\n2 0 2\n4 0 1 2 3\n"
     "7 4 5 6 7 8 9 10\n",
     1,
     {{0, 0, 0, 6, 0, 0}}},
    {"a side in the plane parts the line",
     "12 2 0\n-1 -1 0\n9 -1 0\n9 1 0\n-1 1 0\n0 0 2\n0 0 -2\n6 0 -2\n6 0 2\n4 0 2\n4 0 0\n2 0 0\n2 0 2\n4 0 1 2 3\n"
     "8 4 5 6 7 8 9 10 11\n",
     2,
     {{0, 0, 0, 2, 0, 0}, {4, 0, 0, 6, 0, 0}}},
    {"along the slit to a hole",
     "14 2 0\n0 0 0\n8 0 0\n8 8 0\n0 8 0\n2 2 0\n2 6 0\n6 6 0\n6 2 0\n-1 -1 -1\n9 9 -1\n9 9 1\n-1 -1 1\n1 1 0\n"
     "3 3 0\n10 0 1 2 3 0 4 5 6 7 4\n4 8 9 10 11\n",
     2,
     {{0, 0, 0, 2, 2, 0}, {6, 6, 0, 8, 8, 0}}},
    {"across the slit to a hole",
     "12 2 0\n0 0 0\n8 0 0\n8 8 0\n0 8 0\n2 2 0\n2 6 0\n6 6 0\n6 2 0\n-1 1 -1\n9 1 -1\n9 1 1\n-1 1 1\n"
     "10 0 1 2 3 0 4 5 6 7 4\n4 8 9 10 11\n",
     1,
     {{0, 1, 0, 8, 1, 0}}},
    {"through a star",
     "9 2 0\n" STAR "-20 0 -1\n20 0 -1\n20 0 1\n-20 0 1\n5 0 1 2 3 4\n4 5 6 7 8\n",
     1,
     {{-54.0 / 11, 0, 0, 54.0 / 11, 0, 0}}},
    {"along a side of a star, which is an edge",
     "9 2 0\n" STAR "-20 -3 -1\n20 -3 -1\n20 -3 1\n-20 -3 1\n5 0 1 2 3 4\n4 5 6 7 8\n",
     0,
     {{0}}},
    {"far from the origin",
     "8 2 0\n1000000 0 0\n1000004 0 0\n1000004 4 0\n1000000 4 0\n1000001 2 -1\n1000003 2 -1\n1000003 2 1\n1000001 2 1\n"
     "4 0 1 2 3\n4 4 5 6 7\n",
     1,
     {{1000001, 2, 0, 1000003, 2, 0}}},
};

/* A way to turn a scene that rounds nothing: axes and signs. */
static roberts_vec3 turned(roberts_vec3 p, int way)
{
    const double c[3] = {p.x, p.y, p.z};
    static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    const int *axis = order[way % 6];
    int signs = way / 6;
    return (roberts_vec3){signs & 1 ? -c[axis[0]] : c[axis[0]], signs & 2 ? -c[axis[1]] : c[axis[1]],
                          signs & 4 ? -c[axis[2]] : c[axis[2]]};
}

enum { WAYS = 48 };

/* Reads a scene of loose faces, turned, with the corners of each face rotated or reversed. */
static roberts_scene *scene_of(const char *off, int way, uint32_t begin, bool back)
{
    char text[1024] = "OFF\n";
    strcat(text, off);
    roberts_mesh mesh = mesh_of_text(text);
    for (size_t v = 0; v < mesh.vertex_count; v++)
        mesh.vertex[v] = turned(mesh.vertex[v], way);
    for (size_t f = 0; f < mesh.face_count; f++) {
        uint32_t *corner = mesh.corner + mesh.face_start[f], n = mesh.face_start[f + 1] - mesh.face_start[f], was[16];
        memcpy(was, corner, n * sizeof *was);
        for (uint32_t k = 0; k < n; k++)
            corner[k] = was[back ? (2 * n - k - begin % n) % n : (k + begin) % n];
    }
    return build_scene(&mesh);
}

/* The face of the scene that is a face of the file. */
static bool is_beside(const crossing_rules *rules, const crossing_face *f, crossing_face *g)
{
    crossing_lie lie = crossing_lie_of(rules, f, g);
    return !(lie.over && lie.under);
}

static crossing_face face_of(const crossing_rules *rules, uint32_t number)
{
    for (uint32_t s = 0; s < rules->scene->solid_count; s++)
        for (uint32_t f = rules->scene->solid[s].face; f < rules->scene->solid[s + 1].face; f++)
            if (scene_face_number(rules->scene, f) == number)
                return crossing_face_of(rules, s, f);
    fail_msg("there is no face %u", number);
    return (crossing_face){0};
}

static bool is_near(roberts_vec3 p, roberts_vec3 q, double size)
{
    return fabs(p.x - q.x) <= size && fabs(p.y - q.y) <= size && fabs(p.z - q.z) <= size;
}

/* Is the segment among the expected ones? */
static bool is_expected(const pair_case *c, const crossing_segment *s, int way)
{
    for (size_t k = 0; k < c->count; k++) {
        const double *l = c->line[k];
        roberts_vec3 a = turned((roberts_vec3){l[0], l[1], l[2]}, way);
        roberts_vec3 b = turned((roberts_vec3){l[3], l[4], l[5]}, way);
        if (vec3_compare(a, b) > 0) {
            roberts_vec3 first = a;
            a = b;
            b = first;
        }
        if (is_near(s->end[0].point, a, 1e-8) && is_near(s->end[1].point, b, 1e-8))
            return true;
    }
    return false;
}

static void pairs_cross_where_they_should(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int way = 0; way < WAYS; way++)
            for (uint32_t k = 0; k < 16; k++) {
                roberts_scene *scene = scene_of(cases[i].off, way, k / 4, k & 1);
                crossing_rules rules = {.scene = scene, .touching = 1e-10};
                crossing_face f = face_of(&rules, 0), g = face_of(&rules, 1);
                crossing_list found = {0};
                assert_true(crossing_find(&rules, k & 2 ? &g : &f, k & 2 ? &f : &g, &found));
                if (found.count != cases[i].count)
                    fail_msg("%s: %zu segments, not %zu (turned %d, %u)", cases[i].name, found.count, cases[i].count,
                             way, k);
                for (size_t n = 0; n < found.count; n++) {
                    if (!is_expected(&cases[i], &found.item[n], way))
                        fail_msg("%s: segment %zu is elsewhere (turned %d, %u)", cases[i].name, n, way, k);
                    assert_true(n == 0 || vec3_compare(found.item[n - 1].end[0].point, found.item[n].end[0].point) < 0);
                }
                crossing_list_free(&found);
                roberts_scene_free(scene);
            }
}

/* ---- triangles against whole numbers ---------------------------------------------------------------------------- */

typedef struct whole3 {
    int64_t x[3];
} whole3;

/* Six times the volume of abcd: > 0 where d is on the side to which abc turns left. */
static int64_t volume(const whole3 *a, const whole3 *b, const whole3 *c, const whole3 *d)
{
    int64_t u[3], v[3], w[3];
    for (int k = 0; k < 3; k++) {
        u[k] = b->x[k] - a->x[k];
        v[k] = c->x[k] - a->x[k];
        w[k] = d->x[k] - a->x[k];
    }
    return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] + (u[0] * v[1] - u[1] * v[0]) * w[2];
}

/* A point whose coordinates are fractions over one positive denominator. */
typedef struct fraction3 {
    int64_t over[3], under;
} fraction3;

static int compare_fractions(const fraction3 *p, const fraction3 *q)
{
    for (int k = 0; k < 3; k++) {
        int64_t d = p->over[k] * q->under - q->over[k] * p->under;
        if (d != 0)
            return d < 0 ? -1 : 1;
    }
    return 0;
}

/* The part of the other's plane in triangle t, from end to end. False: the triangle does not lie on both sides of it.
 */
static bool whole_span(const whole3 t[3], const whole3 other[3], fraction3 end[2])
{
    int64_t h[3];
    int cuts = 0, over = 0, under = 0;
    for (int i = 0; i < 3; i++) {
        h[i] = volume(&other[0], &other[1], &other[2], &t[i]);
        over += h[i] > 0;
        under += h[i] < 0;
    }
    if (over == 0 || under == 0)
        return false;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        fraction3 at = {{t[i].x[0], t[i].x[1], t[i].x[2]}, 1};
        if (h[i] != 0) {
            if ((h[i] > 0) == (h[j] > 0) || h[j] == 0)
                continue;
            int64_t side = h[i] > 0 ? 1 : -1;
            at.under = side * (h[i] - h[j]);
            for (int k = 0; k < 3; k++)
                at.over[k] = t[i].x[k] * at.under + side * h[i] * (t[j].x[k] - t[i].x[k]);
        }
        end[cuts++] = at;
    }
    assert_int_equal(cuts, 2);
    if (compare_fractions(&end[0], &end[1]) > 0) {
        fraction3 first = end[0];
        end[0] = end[1];
        end[1] = first;
    }
    return true;
}

/* Do two triangles cross, and where? */
static bool whole_crossing(const whole3 f[3], const whole3 g[3], fraction3 end[2])
{
    fraction3 a[2], b[2];
    if (!whole_span(f, g, a) || !whole_span(g, f, b))
        return false;
    end[0] = compare_fractions(&a[0], &b[0]) >= 0 ? a[0] : b[0];
    end[1] = compare_fractions(&a[1], &b[1]) <= 0 ? a[1] : b[1];
    return compare_fractions(&end[0], &end[1]) < 0;
}

/* The nearest double: both numbers are below 2^53. */
static bool is_nearest(double x, int64_t over, int64_t under)
{
    return x == (double)over / (double)under;
}

static void triangles_cross_as_whole_numbers_say(void **state)
{
    (void)state;
    rng r = {20261122};
    size_t crossing = 0, sharing = 0, touching = 0;
    for (int round = 0; round < 20000; round++) {
        int room = rng_int(&r, 2, 12), shared = rng_int(&r, 0, 5) - 3;
        whole3 t[6];
        uint32_t corner[6] = {0, 1, 2, 3, 4, 5};
        for (int i = 0; i < 6; i++)
            for (int k = 0; k < 3; k++)
                t[i].x[k] = rng_int(&r, -room, room);
        for (int i = 0; i < shared; i++) {
            t[3 + i] = t[i];
            corner[3 + i] = (uint32_t)i;
        }
        roberts_mesh mesh = {0};
        for (int i = 0; i < 6; i++)
            mesh_vertex(&mesh, (roberts_vec3){(double)t[i].x[0], (double)t[i].x[1], (double)t[i].x[2]});
        mesh_face(&mesh, corner, 3);
        mesh_face(&mesh, corner + 3, 3);
        roberts_scene *scene = NULL;
        fraction3 end[2];
        bool cross = whole_crossing(t, t + 3, end);
        if (roberts_scene_build(&mesh, NULL, &scene, NULL) == ROBERTS_OK && scene->face_count == 2) {
            crossing_rules rules = {.scene = scene, .touching = 1e-10};
            crossing_face f = face_of(&rules, 0), g = face_of(&rules, 1);
            crossing_list found = {0};
            assert_true(crossing_find(&rules, &f, &g, &found));
            if (found.count != (size_t)cross)
                fail_msg("round %d: %zu segments, not %d", round, found.count, cross);
            for (int i = 0; cross && i < 2; i++) {
                roberts_vec3 p = found.item[0].end[i].point;
                assert_true(is_nearest(p.x, end[i].over[0], end[i].under));
                assert_true(is_nearest(p.y, end[i].over[1], end[i].under));
                assert_true(is_nearest(p.z, end[i].over[2], end[i].under));
            }
            crossing += cross;
            sharing += cross && shared > 0;
            touching += !cross && (is_beside(&rules, &f, &g) != is_beside(&rules, &g, &f));
            crossing_list_free(&found);
        }
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
    assert_true(crossing > 2000 && sharing > 500 && touching > 500);
}

/* Two triangles that share a side are pierced at one point, bit for bit, whatever their numbers and directions. */
static void ends_agree_on_both_sides_of_a_side(void **state)
{
    (void)state;
    rng r = {7};
    for (int round = 0; round < 2000; round++) {
        roberts_mesh mesh = {0};
        roberts_vec3 p[7] = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}, {2, 0, 0}, {-2, 0, 0}};
        mat3 turn = mat3_turn(&r);
        uint32_t face[3][3] = {{0, 1, 2}, {3, 4, 5}, {4, 3, 6}}, order[7];
        rng_permutation(&r, order, 7);
        roberts_vec3 moved[7];
        for (int i = 0; i < 7; i++) {
            p[i].x += rng_between(&r, -0.1, 0.1);
            p[i].y += rng_between(&r, -0.1, 0.1);
            p[i].z += rng_between(&r, -0.1, 0.1);
            moved[order[i]] = mat3_map(turn, p[i]);
        }
        for (int i = 0; i < 7; i++)
            mesh_vertex(&mesh, moved[i]);
        for (int f = 0; f < 3; f++) {
            uint32_t corner[3];
            int start = rng_int(&r, 0, 2);
            for (int k = 0; k < 3; k++)
                corner[k] = order[face[f][(start + k) % 3]];
            mesh_face(&mesh, corner, 3);
        }
        roberts_scene *scene = build_scene(&mesh);
        crossing_rules rules = {.scene = scene, .touching = 1e-10};
        crossing_face f = face_of(&rules, 0), g = face_of(&rules, 1), h = face_of(&rules, 2);
        crossing_list found = {0};
        assert_true(crossing_find(&rules, &f, &g, &found) && crossing_find(&rules, &h, &f, &found));
        assert_int_equal(found.count, 2);
        int same = 0;
        for (int i = 0; i < 2; i++)
            for (int k = 0; k < 2; k++)
                same += memcmp(&found.item[0].end[i], &found.item[1].end[k], 2 * sizeof(roberts_vec3)) == 0;
        assert_int_equal(same, 1);
        crossing_list_free(&found);
        roberts_scene_free(scene);
    }
}

/* ---- drawings --------------------------------------------------------------------------------------------------- */

/* Loose triangles, a fine sheet that lies over itself among them, or convex solids. */
static roberts_scene *crossing_scene(int kind)
{
    rng r = {(uint64_t)kind + 1};
    roberts_mesh mesh = {0};
    if (kind == 2) {
        model m = {0};
        model_lattice(&m, 4, 1.2, 3);
        roberts_scene *scene = model_build(&m);
        model_free(&m);
        return scene;
    }
    for (uint32_t i = 0; i < 41 * 41 && kind == 1; i++) { /* a roll that goes through itself */
        double u = 0.25 * (i / 41), v = 0.1 * (i % 41);
        roberts_vec3 p = {(2 + cos(u) + 0.3 * u) * cos(u), v + 0.2 * sin(3 * u), (2 + 0.2 * cos(v)) * sin(2 * u)};
        mesh_vertex(&mesh, p);
    }
    for (uint32_t i = 0; i < 40 * 40 && kind == 1; i++) {
        uint32_t a = i / 40 * 41 + i % 40, corner[2][3] = {{a, a + 41, a + 42}, {a, a + 42, a + 1}};
        for (int k = 0; k < 2; k++)
            mesh_face(&mesh, corner[k], 3);
    }
    for (uint32_t i = 0; i < 300 && kind == 0; i++) {
        roberts_vec3 at = rng_vec3(&r, 2);
        for (int k = 0; k < 3; k++)
            mesh_vertex(&mesh, vec3_add(at, rng_vec3(&r, 1)));
        mesh_face(&mesh, (uint32_t[]){3 * i, 3 * i + 1, 3 * i + 2}, 3);
    }
    return build_scene(&mesh);
}

/* How many pairs of triangles cross, testing each pair. */
static size_t pairs_that_cross(const roberts_scene *scene, double touching)
{
    crossing_rules rules = {.scene = scene, .touching = touching};
    crossing_list found = {0};
    for (uint32_t f = 0; f < scene->face_count; f++)
        for (uint32_t g = f + 1; g < scene->face_count; g++) {
            uint32_t body[2] = {0, 0};
            for (uint32_t s = 0; s < scene->solid_count; s++) {
                body[0] = f >= scene->solid[s].face ? s : body[0];
                body[1] = g >= scene->solid[s].face ? s : body[1];
            }
            crossing_face F = crossing_face_of(&rules, body[0], f), G = crossing_face_of(&rules, body[1], g);
            assert_true(crossing_find(&rules, &F, &G, &found));
        }
    size_t count = found.count;
    crossing_list_free(&found);
    return count;
}

/* Each pair is found, once, by any grid and any number of threads, and the bytes are the same. */
static void lines_do_not_depend_on_grid_and_threads(void **state)
{
    const roberts_camera camera = {.dir = {0.31, -0.47, 0.83}};
    static const uint32_t grids[] = {0, 1, 7, 90}, threads[] = {1, 1, 2, 3};
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        roberts_scene *scene = crossing_scene(kind);
        roberts_drawing first = {0};
        for (int i = 0; i < 4; i++) {
            roberts_hide_options options = roberts_hide_options_default();
            options.grid = grids[i];
            options.threads = threads[i];
            options.keep_hidden = true; /* otherwise lines wholly behind a cell's layers need not be found */
            roberts_drawing drawing = drawing_of(scene, &camera, &options);
            if (drawing.crossing_count <= 20)
                fail_msg("kind %d, grid %u: %zu lines", kind, grids[i], drawing.crossing_count);
            if (i == 0) {
                if (kind < 2)
                    assert_int_equal(drawing.crossing_count, pairs_that_cross(scene, drawing.epsilon));
                first = drawing;
                continue;
            }
            assert_int_equal(drawing.crossing_count, first.crossing_count);
            assert_memory_equal(drawing.crossing, first.crossing, first.crossing_count * sizeof *first.crossing);
            assert_int_equal(drawing.count, first.count);
            for (size_t k = 0; k < first.count; k++)
                assert_true(drawing.segment[k].t0 == first.segment[k].t0 &&
                            drawing.segment[k].t1 == first.segment[k].t1 &&
                            drawing.segment[k].edge == first.segment[k].edge &&
                            drawing.segment[k].line == first.segment[k].line);
            roberts_drawing_free(&drawing);
        }
        roberts_drawing_free(&first);
        roberts_scene_free(scene);
    }
}

/* Two triangles cross in the upper right of the picture. With two columns and two rows their boxes touch the lower left
 * cell, their edges do not. */
static void a_cell_without_edges_loses_no_line(void **state)
{
    (void)state;
    const char *off = "12 4 0\n10 3 0\n10 10 0\n3 10 0\n10 3 2\n10 10 -2\n3 10 2\n0 9 0\n1 9 0\n0 10 0\n"
                      "9 0 0\n10 0 0\n9 1 0\n3 0 1 2\n3 3 4 5\n3 6 7 8\n3 9 10 11\n";
    const roberts_camera camera = {.dir = {0, 0, 1}};
    for (uint32_t grid = 1; grid < 6; grid++) {
        roberts_scene *scene = scene_of(off, 0, 0, false);
        roberts_hide_options options = roberts_hide_options_default();
        options.grid = grid;
        roberts_drawing drawing = drawing_of(scene, &camera, &options);
        assert_int_equal(drawing.crossing_count, 1);
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
}

/* A face ends where the near plane cuts it, and so at the cap there. That is no line. */
static void nothing_crosses_a_cap(void **state)
{
    roberts_error error;
    size_t lines = 0;
    (void)state;
    for (int i = 0; i < 60; i++) {
        roberts_mesh mesh = {0};
        if (roberts_mesh_read_file(&mesh, "models/star/great-dodecahemidodecahedron.off", NULL, &error) != ROBERTS_OK)
            fail_msg("%s", error.message);
        roberts_scene *scene = scene_of_mesh(&mesh, NULL);
        const roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE,
                                       .eye = {sin(i), 0.02 * i - 0.6, 1.3 * cos(i)},
                                       .near_distance = i % 2 ? 0.6 : 0.0};
        roberts_hide_options options = roberts_hide_options_default();
        options.keep_hidden = i % 3 == 0;
        roberts_drawing drawing = drawing_of(scene, &camera, &options);
        lines += drawing.crossing_count;
        for (size_t k = 0; k < drawing.crossing_count; k++)
            assert_true(drawing.crossing[k].face[0] != ROBERTS_NONE && drawing.crossing[k].face[1] != ROBERTS_NONE);
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
    assert_true(lines > 1000);
}

/* Of a comb of many teeth, only the pieces near the other face are looked at. That changes no line. */
static void pieces_far_away_change_nothing(void **state)
{
    enum { TEETH = 40, OTHERS = 400 };
    roberts_mesh mesh = {0};
    uint32_t corner[2 * TEETH + 2] = {0};
    size_t lines = 0, touches = 0, left = 0, all = 0;
    (void)state;
    for (int k = 0; k < 2 * TEETH; k++)
        corner[k] = mesh_vertex(&mesh, (roberts_vec3){k, k % 2 ? 3 + k % 7 : 0, 0});
    corner[2 * TEETH] = mesh_vertex(&mesh, (roberts_vec3){2 * TEETH, -2, 0});
    corner[2 * TEETH + 1] = mesh_vertex(&mesh, (roberts_vec3){-1, -2, 0});
    mesh_face(&mesh, corner, 2 * TEETH + 2);
    for (int k = 0; k < OTHERS; k++) { /* some stand on the comb, some lie on its slopes, most go through it */
        const double x = k % 80, y = k % 11 - 3, low = k % 3 ? -1 : 0, wide = 1 + k % 5, turn = k % 4 - 1;
        const roberts_vec3 P[4] = {
            {x, y, low}, {x + wide, y + turn * wide, low}, {x + wide, y + turn * wide, 1}, {x, y, 1}};
        uint32_t quad[4];
        for (int i = 0; i < 4; i++)
            quad[i] = mesh_vertex(&mesh, P[i]);
        mesh_face(&mesh, quad, 4);
    }
    roberts_scene *scene = scene_of_mesh(&mesh, NULL);
    const crossing_rules rules = {.scene = scene, .touching = 1e-9};
    const crossing_face first = face_of(&rules, 0);
    crossing_kept kept = {0};
    for (uint32_t k = 1; k <= OTHERS; k++) {
        crossing_face other = face_of(&rules, k), *comb = crossing_keep(&kept, &rules, first.body, first.first);
        crossing_list wanted = {0}, found = {0};
        assert_true(crossing_find(&rules, comb, &other, &wanted));
        assert_true(crossing_limit(&kept, &rules, &other) && comb->near);
        assert_true(crossing_find(&rules, comb, &other, &found));
        assert_int_equal(found.count, wanted.count);
        for (size_t i = 0; i < found.count; i++)
            for (int end = 0; end < 2; end++) {
                const crossing_point *p = &found.item[i].end[end], *q = &wanted.item[i].end[end];
                assert_true(vec3_same(p->point, q->point) && vec3_same(p->low, q->low) && p->vertex == q->vertex);
            }
        lines += found.count;
        touches += found.touch_count;
        left += comb->near_count;
        all += comb->end - comb->first;
        crossing_list_free(&wanted);
        crossing_list_free(&found);
    }
    assert_true(lines > 200 && touches > 40 && 4 * left < all);
    crossing_kept_free(&kept);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pairs_cross_where_they_should),      cmocka_unit_test(triangles_cross_as_whole_numbers_say),
        cmocka_unit_test(ends_agree_on_both_sides_of_a_side), cmocka_unit_test(lines_do_not_depend_on_grid_and_threads),
        cmocka_unit_test(a_cell_without_edges_loses_no_line), cmocka_unit_test(nothing_crosses_a_cap),
        cmocka_unit_test(pieces_far_away_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
