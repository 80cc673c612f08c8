/* test_plain_bodies.c - bodies built in place are the same as bodies that are cut, joined and laid out again.
 *
 * Each mesh is built twice: as it is, and with a reversed copy of its first face. A face that repeats an earlier one
 * has no effect, but its body is not plain. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/convex.h"
#include "model/scene.h"
#include "read/mesh.h"
#include "build_scene.h"
#include "same_scene.h"
#include "testing.h"

static void add_face(roberts_mesh *mesh, size_t count, const uint32_t *corner)
{
    for (size_t i = 0; i < count; i++)
        assert_true(mesh_add_corner(mesh, corner[i]));
    assert_true(mesh_end_face(mesh));
}

/* A ring of triangles, `along` times `across`; around: also a torus the other way, and no border. */
static void add_ring(roberts_mesh *mesh, uint32_t along, uint32_t across, bool around, roberts_vec3 at)
{
    const double turn = 6.283185307179586;
    uint32_t first = (uint32_t)mesh->vertex_count, columns = around ? across : across + 1;
    for (uint32_t i = 0; i < along; i++)
        for (uint32_t k = 0; k < columns; k++) {
            double a = turn * i / along, b = turn * k / across * (around ? 1.0 : 0.4);
            double r = 3.0 + (1.0 + 0.1 * sin(5.0 * a + 3.0 * b)) * cos(b);
            assert_true(mesh_add_vertex(mesh, (roberts_vec3){at.x + r * cos(a), at.y + r * sin(a), at.z + sin(b)}));
        }
    for (uint32_t i = 0; i < along; i++)
        for (uint32_t k = 0; k < across; k++) {
            uint32_t j = (i + 1) % along, l = (k + 1) % columns;
            uint32_t a = first + i * columns + k, b = first + j * columns + k, c = first + j * columns + l,
                     d = first + i * columns + l;
            add_face(mesh, 3, (uint32_t[]){b, c, a});
            add_face(mesh, 3, i % 2 ? (uint32_t[]){a, c, d} : (uint32_t[]){c, d, a});
        }
}

static void add_box(roberts_mesh *mesh, roberts_vec3 at)
{
    static const uint32_t face[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                        {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    uint32_t first = (uint32_t)mesh->vertex_count;
    for (int v = 0; v < 8; v++)
        assert_true(mesh_add_vertex(mesh, (roberts_vec3){at.x + (v >> 2), at.y + (v >> 1 & 1), at.z + (v & 1)}));
    for (int f = 0; f < 6; f++) {
        uint32_t corner[4];
        for (int i = 0; i < 4; i++)
            corner[i] = first + face[f][i];
        add_face(mesh, 4, corner);
    }
}

/* A box with a notch: planar faces of four and six corners, one of them concave in `concave`. */
static void add_step(roberts_mesh *mesh, roberts_vec3 at, bool concave)
{
    static const double outline[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    uint32_t first = (uint32_t)mesh->vertex_count;
    for (int z = 0; z < 2; z++)
        for (int v = 0; v < 6; v++)
            assert_true(mesh_add_vertex(mesh, (roberts_vec3){at.x + outline[v][0], at.y + outline[v][1], at.z + z}));
    for (uint32_t i = 0; i < 6; i++) {
        uint32_t k = (i + 1) % 6;
        add_face(mesh, 4, (uint32_t[]){first + i, first + k, first + 6 + k, first + 6 + i});
    }
    for (uint32_t z = 0; z < 2; z++) {
        uint32_t v = first + 6 * z;
        if (concave) {
            add_face(mesh, 6, (uint32_t[]){v, v + 1, v + 2, v + 3, v + 4, v + 5});
        } else {
            uint32_t lower[2][4] = {{v + 3, v + 2, v + 1, v}, {v + 5, v + 4, v + 3, v}};
            for (int k = 0; k < 2; k++)
                for (int i = 0; z == 1 && i < 2; i++) {
                    uint32_t other = lower[k][i];
                    lower[k][i] = lower[k][3 - i];
                    lower[k][3 - i] = other;
                }
            add_face(mesh, 4, lower[0]);
            add_face(mesh, 4, lower[1]);
        }
    }
}

/* Turns every third face from `first` on. */
static void turn_some(roberts_mesh *mesh, size_t first)
{
    for (size_t f = first; f < mesh->face_count; f += 3) {
        uint32_t *corner = mesh->corner + mesh->face_start[f], swapped = corner[0];
        corner[0] = corner[1];
        corner[1] = swapped;
    }
}

/* Adds two faces at the last edge of the last face. */
static void add_fins(roberts_mesh *mesh)
{
    uint32_t a = mesh->corner[mesh->corner_count - 2], b = mesh->corner[mesh->corner_count - 1];
    for (int k = 0; k < 2; k++) {
        roberts_vec3 p = mesh->vertex[a];
        assert_true(mesh_add_vertex(mesh, (roberts_vec3){p.x + k, p.y - 0.5, p.z + 2.0}));
        add_face(mesh, 3, (uint32_t[]){k ? a : b, (uint32_t)mesh->vertex_count - 1, k ? b : a});
    }
}

static void fill(roberts_mesh *mesh, const char *what)
{
    for (size_t i = 0; what[i]; i++) {
        double x = 10.0 * (double)i;
        roberts_vec3 at = {x, 0.25 * x, 0.125 * x};
        size_t first = mesh->face_count;
        if (what[i] == 't' || what[i] == 'T' || what[i] == 'm' || what[i] == 'f')
            add_ring(mesh, what[i] == 'T' ? 60 : 12, what[i] == 'T' ? 30 : 8, true, at);
        else if (what[i] == 's' || what[i] == 'S' || what[i] == 'n')
            add_ring(mesh, what[i] == 'S' ? 60 : 12, what[i] == 'S' ? 30 : 8, false, at);
        else if (what[i] == 'b')
            add_box(mesh, at);
        else
            add_step(mesh, at, what[i] == 'c');
        if (what[i] == 'm' || what[i] == 'n')
            turn_some(mesh, first);
        if (what[i] == 'f')
            add_fins(mesh);
    }
}

static roberts_scene *scene_of(const char *what, bool repeat, bool take)
{
    roberts_mesh mesh = {0};
    roberts_scene *scene = NULL;
    roberts_error error = {0};
    fill(&mesh, what);
    if (repeat) {
        uint32_t corner[8], count = mesh.face_start[1];
        for (uint32_t i = 0; i < count; i++)
            corner[i] = mesh.corner[count - 1 - i];
        add_face(&mesh, count, corner);
    }
    roberts_status status =
        take ? roberts_scene_take(&mesh, NULL, &scene, &error) : roberts_scene_build(&mesh, NULL, &scene, &error);
    if (status != ROBERTS_OK)
        fail_msg("%s: %s", what, error.message);
    roberts_mesh_free(&mesh);
    return scene;
}

/* The faces of an edge, the smaller first, and on which side each is. */
static void faces_of(const roberts_scene *scene, uint32_t s, uint32_t e, uint32_t face[2], bool turned[2])
{
    const scene_edge *edge = scene_edge_stored(scene, s, e);
    uint8_t is = scene->surface->edge_is[e];
    int first = edge->f[1] < edge->f[0];
    for (int k = 0; k < 2; k++) {
        face[k] = edge->f[k ^ first];
        turned[k] = (is & (k ^ first ? EDGE_TURNED_1 : EDGE_TURNED_0)) != 0;
    }
}

/* If planes are not stored, the bend of each edge with two faces is. */
static void check_bends(const roberts_scene *scene)
{
    assert_true(!scene->face_plane == !!scene->surface->bend);
    for (uint32_t s = 0; scene->surface->bend && s < scene->solid_count; s++)
        for (uint32_t e = scene->solid[s].edge; e < scene->solid[s + 1].edge; e++) {
            const scene_edge edge = scene_edge_at(scene, s, e);
            uint8_t is = scene->surface->edge_is[e];
            if (scene_edge_stored(scene, s, e)->f[1] == ROBERTS_NONE || is & EDGE_MANY)
                continue;
            plane F = scene_plane(scene, edge.f[0]), G = scene_plane(scene, edge.f[1]);
            double way = !(is & EDGE_TURNED_0) == !(is & EDGE_TURNED_1) ? -1.0 : 1.0;
            double a = F.a - way * G.a, b = F.b - way * G.b, c = F.c - way * G.c;
            assert_int_equal(scene->surface->bend[e], scene_bend_code(a * a + b * b + c * c));
        }
}

/* The code of a bend ascends with it, and has digits enough from 4, a face folded back, to 2^-61. */
static void bend_codes_ascend(void **state)
{
    (void)state;
    assert_int_equal(scene_bend_code(0.0), 0);
    assert_true(scene_bend_code(4.0) > scene_bend_code(3.9999));
    double bend = 0x1p-60;
    while (bend < 4.0) {
        assert_true(scene_bend_code(bend) <= scene_bend_code(1.19 * bend));
        assert_true(scene_bend_code(bend) < scene_bend_code(1.51 * bend));
        bend *= 1.19;
    }
}

static void check_same(const char *what, const roberts_scene *a, const roberts_scene *b)
{
    if (a->solid_count != b->solid_count || a->vertex_count != b->vertex_count || a->face_count != b->face_count ||
        a->edge_count != b->edge_count)
        fail_msg("%s: other counts", what);
    for (uint32_t s = 0; s < a->solid_count; s++) {
        assert_int_equal(a->solid[s].vertex, b->solid[s].vertex);
        assert_int_equal(a->solid[s].face, b->solid[s].face);
        assert_int_equal(a->solid[s].edge, b->solid[s].edge);
        assert_int_equal(a->surface->kind[s], b->surface->kind[s]);
        assert_int_equal(a->surface->smooth[s], b->surface->smooth[s]);
        for (uint32_t e = a->solid[s].edge; e < a->solid[s + 1].edge; e++) {
            const scene_edge *p = scene_edge_stored(a, s, e), *q = scene_edge_stored(b, s, e);
            uint32_t face[2][2];
            bool turned[2][2];
            if (p->v[0] != q->v[0] || p->v[1] != q->v[1])
                fail_msg("%s: edge %u has other ends", what, e);
            faces_of(a, s, e, face[0], turned[0]);
            faces_of(b, s, e, face[1], turned[1]);
            if (memcmp(face[0], face[1], sizeof face[0]) != 0 || memcmp(turned[0], turned[1], sizeof turned[0]) != 0)
                fail_msg("%s: edge %u has other faces", what, e);
        }
    }
    assert_int_equal(a->surface->many_count, b->surface->many_count);
    for (uint32_t i = 0; i < a->surface->many_count; i++) {
        const scene_many *p = &a->surface->many[i], *q = &b->surface->many[i];
        assert_int_equal(p->edge, q->edge);
        assert_int_equal(p->end - p->first, q->end - q->first);
        assert_memory_equal(a->surface->many_face + p->first, b->surface->many_face + q->first,
                            (p->end - p->first) * sizeof *a->surface->many_face);
    }
    expect_same_faces(a, b);
    check_bends(a);
}

/* One letter for each body: torus, sheet, box, step of whole faces, torus (m) and sheet (n) of mixed winding, torus
 * with fins; capitals are large. The first is not convex: its face is repeated. */
static void plain_bodies_are_the_same(void **state)
{
    static const char *const meshes[] = {"t",       "T", "s", "S",     "tt", "ss",    "tb",     "sb", "p",
                                         "pbbtsbp", "m", "n", "tmbnt", "f",  "tfbfs", "TsbtST", "TTT"};
    (void)state;
    for (size_t i = 0; i < sizeof meshes / sizeof meshes[0]; i++)
        for (int take = 0; take < 2; take++) {
            roberts_scene *plain = scene_of(meshes[i], false, take), *other = scene_of(meshes[i], true, take);
            if (plain->face_number || !other->face_number)
                fail_msg("%s: the one is not plain, or the other is", meshes[i]);
            check_same(meshes[i], plain, other);
            roberts_scene_free(plain);
            roberts_scene_free(other);
        }
}

static void a_concave_face_is_cut(void **state)
{
    (void)state;
    roberts_scene *scene = scene_of("tc", false, true);
    assert_non_null(scene->face_number);
    roberts_scene_free(scene);
}

/* Loose triangles are plain unless two corners lie at one place. Here these are far apart in the file, or both ends of
 * one side. */
static void loose_faces_are_apart(void **state)
{
    enum { APART, SAME_CORNER, NO_SIDE, KINDS, FACES = 2000 };
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        roberts_mesh mesh = {0};
        roberts_scene *scene = NULL;
        roberts_error error = {0};
        for (uint32_t f = 0; f < FACES; f++) {
            bool last = f == FACES - 1;
            double x = kind == SAME_CORNER && last ? 0.0 : 2.0 * f;
            uint32_t v = 4 * f;
            assert_true(mesh_add_vertex(&mesh, (roberts_vec3){x, 0, 0}));
            assert_true(mesh_add_vertex(&mesh, (roberts_vec3){x + 1, x / 9, 1}));
            assert_true(mesh_add_vertex(&mesh, (roberts_vec3){x, 1, 3 + f}));
            assert_true(mesh_add_vertex(&mesh, (roberts_vec3){x, 1, 3 + f}));
            add_face(&mesh, kind == NO_SIDE && last ? 4 : 3, (uint32_t[]){v, v + 1, v + 2, v + 3});
        }
        if (roberts_scene_build(&mesh, NULL, &scene, &error) != ROBERTS_OK)
            fail_msg("kind %d: %s", kind, error.message);
        if ((scene->face_number == NULL) != (kind == APART))
            fail_msg("kind %d is plain, or APART is not", kind);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

/* A loose triangle is plain unless a vertex of another one touches a side of it. The first triangle is as small as the
 * cells in which neighbours are sought, or large and oblique, so that its sides are sought one by one. It lies among
 * others, which are far from it. */
static void loose_triangles_are_clear(void **state)
{
    static const struct {
        const char *name;
        roberts_vec3 corner[3]; /* of the second triangle; the first one is (0, 0, 0), (1, 0, 0), (0, 1, 0) */
        bool plain;
    } cases[] = {
        {"a corner on a side", {{0.5, 0.5, 0}, {1, 1, 1}, {1, 1, 2}}, false},
        {"a corner on the first side", {{0.25, 0, 0}, {0.5, -1, 1}, {0.25, -1, 2}}, false},
        {"a corner a little off that side", {{0.25, -1e-7, 0}, {0.5, -1, 1}, {0.25, -1, 2}}, true},
        {"a corner at a corner", {{1, 1, 2}, {1, 1, 1}, {1, 0, 0}}, false},
        {"a corner in the face", {{0.25, 0.25, 0}, {1, 1, 1}, {1, 1, 2}}, true},
        {"a corner of the first one on a side", {{-1, 0, -1}, {1, 0, 1}, {-1, -1, 1}}, false},
        {"triangles that cross", {{0.25, 0.25, -1}, {0.25, 0.25, 1}, {1, 1, 2}}, true},
        {"a side through the line of another", {{2, 0, -1}, {2, 0, 1}, {3, 0, 0}}, true},
        {"a triangle without area", {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, false},
    };
    enum { CASES = sizeof cases / sizeof cases[0], OTHERS = 12 };
    (void)state;
    for (int i = 0; i < 2 * CASES; i++) {
        const double size = i < CASES ? 1.0 : 60.0;
        roberts_mesh mesh = {0};
        roberts_scene *scene = NULL;
        roberts_error error = {0};
        for (int v = 0; v < 6; v++) {
            roberts_vec3 p = v < 3 ? (roberts_vec3){v == 1, v == 2, 0} : cases[i % CASES].corner[v - 3];
            p.z += i < CASES ? 0.0 : p.x + p.y;
            assert_true(mesh_add_vertex(&mesh, vec3_scale(size, p)));
        }
        for (int k = 0; k < OTHERS * OTHERS * OTHERS; k++) {
            const double x = k % OTHERS, y = k / OTHERS % OTHERS, z = k / (OTHERS * OTHERS);
            const roberts_vec3 at = {60.0 + 2.0 * x, 60.0 + 2.0 * y, 2.0 * z - 20.0};
            for (int v = 0; v < 3; v++)
                assert_true(mesh_add_vertex(&mesh, (roberts_vec3){at.x + (v == 1), at.y + (v == 2), at.z + (v == 2)}));
        }
        for (uint32_t v = 0; v < mesh.vertex_count; v += 3)
            add_face(&mesh, 3, (uint32_t[]){v, v + 1, v + 2});
        if (roberts_scene_build(&mesh, NULL, &scene, &error) != ROBERTS_OK)
            fail_msg("%s: %s", cases[i % CASES].name, error.message);
        if ((scene->face_number == NULL) != cases[i % CASES].plain)
            fail_msg("%s, size %g: plain, or not", cases[i % CASES].name, size);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

/* Bodies with the same pattern share their edges, unless these have more than two faces. */
static void edges_of_a_pattern_are_stored_once(void **state)
{
    static const struct {
        const char *what;
        bool shared;
    } cases[] = {{"ss", true}, {"nnn", true}, {"sf", false}, {"ff", false}, {"sts", true}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_scene *scene = scene_of(cases[i].what, false, true);
        const scene_solid *last = &scene->solid[scene->solid_count - 1];
        assert_int_equal(scene->solid[0].stored == last->stored, cases[i].shared);
        roberts_scene_free(scene);
    }
}

/* Triangles that are given twice, with one winding or both: each counts once, also where several are alike. */
static void faces_given_twice_count_once(void **state)
{
    (void)state;
    for (int reversed = 0; reversed < 2; reversed++)
        for (uint32_t pairs = 1; pairs <= 3; pairs++) {
            char text[600];
            size_t used = (size_t)sprintf(text, "OFF\n%u %u 0\n", 3 * pairs, 2 * pairs);
            for (uint32_t k = 0; k < pairs; k++)
                used += (size_t)sprintf(text + used, "%u 0 0\n%u.5 0 0\n%u 1 2\n", k, k, k);
            for (uint32_t k = 0; k < 2 * pairs; k++) {
                const uint32_t a = k % pairs * 3, turned = k >= pairs && reversed;
                used += (size_t)sprintf(text + used, "3 %u %u %u\n", a, a + 1 + turned, a + 2 - turned);
            }
            roberts_scene *scene = scene_of_text(text);
            assert_int_equal(roberts_scene_solid_count(scene), pairs);
            for (uint32_t s = 0; s < pairs; s++)
                assert_int_equal(roberts_scene_body_kind(scene, s), ROBERTS_OPEN);
            roberts_scene_free(scene);
        }
}

/* Only a shape far from convex is recognised at a glance. */
static void a_glance_tells_only_what_is_certain(void **state)
{
    static const struct {
        double dent;
        bool told;
    } cases[] = {{0.0, false}, {1e-7, false}, {0.3, true}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        enum { ROWS = 24, COLUMNS = 48, VERTICES = 2 + (ROWS - 1) * COLUMNS, FACES = 2 * COLUMNS * (ROWS - 1) };
        static roberts_vec3 point[VERTICES];
        static uint32_t corner[3 * FACES], start[FACES + 1];
        uint32_t count = 0, last = VERTICES - 1;
        point[0] = (roberts_vec3){0, 0, 1};
        point[last] = (roberts_vec3){0, 0, -1};
        for (uint32_t k = 0; k < (ROWS - 1) * COLUMNS; k++) {
            double a = 3.141592653589793 * (k / COLUMNS + 1) / ROWS, b = 6.283185307179586 * (k % COLUMNS) / COLUMNS;
            double r = 1.0 - cases[i].dent * (0.5 + 0.5 * sin(6.0 * a) * sin(5.0 * b));
            point[1 + k] = (roberts_vec3){r * sin(a) * cos(b), r * sin(a) * sin(b), r * cos(a)};
        }
        for (uint32_t k = 0; k < ROWS * COLUMNS; k++) {
            uint32_t row = k / COLUMNS, column = k % COLUMNS, next = (column + 1) % COLUMNS;
            uint32_t above = 1 + (row - 1) * COLUMNS, below = 1 + row * COLUMNS;
            if (row > 0) {
                start[count / 3] = count;
                corner[count++] = above + column;
                corner[count++] = row + 1 < ROWS ? below + column : last;
                corner[count++] = above + next;
            }
            if (row + 1 < ROWS) {
                start[count / 3] = count;
                corner[count++] = below + column;
                corner[count++] = below + next;
                corner[count++] = row > 0 ? above + next : 0;
            }
        }
        start[count / 3] = count;
        assert_int_equal(count, 3 * FACES);
        roberts_scene scene = {.solid_count = 1,
                               .point = point,
                               .corner = corner,
                               .face_start = start,
                               .solid = (scene_solid[]){{0, 0, 0, 0}, {VERTICES, FACES, 0, 0}}};
        if (solid_surely_not_convex(&scene, 0, SCENE_TOLERANCE) != cases[i].told)
            fail_msg("a sphere with dents of %g", cases[i].dent);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bend_codes_ascend),
        cmocka_unit_test(plain_bodies_are_the_same),
        cmocka_unit_test(a_concave_face_is_cut),
        cmocka_unit_test(loose_faces_are_apart),
        cmocka_unit_test(loose_triangles_are_clear),
        cmocka_unit_test(edges_of_a_pattern_are_stored_once),
        cmocka_unit_test(faces_given_twice_count_once),
        cmocka_unit_test(a_glance_tells_only_what_is_certain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
