/* test_repeated_solids.c - solids that repeat one another in a file are built like each of them alone; components that
 * follow one another agree with the definition. */
#include "base/box.h"
#include "model/components.h"
#include "model/scene.h"
#include "scenes.h"

#include "same_scene.h"

/* ---- each solid as if it were alone ---------------------------------------------------------------------------- */

typedef enum winding { OUTWARD, INWARD, EITHER, MIXED } winding;

static void turn_over(roberts_mesh *mesh, uint32_t f)
{
    uint32_t *corner = mesh->corner + mesh->face_start[f], n = mesh->face_start[f + 1] - mesh->face_start[f];
    for (uint32_t i = 0; i < n / 2; i++) {
        uint32_t swapped = corner[i];
        corner[i] = corner[n - 1 - i];
        corner[n - 1 - i] = swapped;
    }
}

/* `count` solids of `kinds` shapes, each turned and moved at random. */
static void fill(model *m, rng *r, uint32_t count, int kinds, winding wound)
{
    *m = (model){0};
    for (uint32_t i = 0; i < count; i++) {
        uint32_t first = (uint32_t)m->mesh.face_count;
        int over = rng_int(r, 0, 1);
        model_add(m, &shapes[rng_int(r, 0, kinds - 1)], mat3_turn(r), (roberts_vec3){5.0 * i, 0, 0});
        for (uint32_t f = first; f < m->mesh.face_count; f++)
            if (wound == INWARD || (wound == EITHER && over) || (wound == MIXED && rng_int(r, 0, 1)))
                turn_over(&m->mesh, f);
    }
}

/* Solid s of the model as a scene of its own. */
static roberts_scene *build_alone(const model *m, uint32_t s)
{
    model alone = {0};
    model_reorder(&alone,
                  &(model){.mesh = m->mesh,
                           .solids = 1,
                           .first_vertex = {m->first_vertex[s], m->first_vertex[s + 1]},
                           .first_face = {m->first_face[s], m->first_face[s + 1]}},
                  (uint32_t[]){0});
    roberts_scene *scene = scene_of_mesh(&alone.mesh, NULL);
    model_free(&alone);
    return scene;
}

static void expect_as_alone(const model *m, const roberts_scene *scene, uint32_t s)
{
    roberts_scene *alone = build_alone(m, s);
    const scene_solid *first = scene->solid + s;
    assert_int_equal(first->vertex, m->first_vertex[s]);
    assert_int_equal(first->face, m->first_face[s]);
    assert_int_equal(first[1].edge - first->edge, alone->edge_count);
    for (uint32_t e = 0; e < alone->edge_count; e++) {
        scene_edge p = scene_edge_at(scene, s, first->edge + e), q = scene_edge_at(alone, 0, e);
        for (int i = 0; i < 2; i++) {
            assert_int_equal(p.v[i] - first->vertex, q.v[i]);
            assert_int_equal(p.f[i] - first->face, q.f[i]);
        }
    }
    for (uint32_t i = 0; i < alone->corner_count; i++)
        assert_int_equal(scene->corner[scene->face_start[first->face] + i] - first->vertex, alone->corner[i]);
    for (uint32_t f = 0; f < alone->face_count; f++) {
        plane F = scene_plane(scene, first->face + f), G = scene_plane(alone, f);
        assert_true(F.a == G.a && F.b == G.b && F.c == G.c);
        assert_true(scene_width(scene, first->face + f) == scene_width(alone, f));
    }
    roberts_scene_free(alone);
}

static void solids_are_as_if_alone(void **state)
{
    rng r = {21};
    (void)state;
    for (int round = 0; round < 60; round++) {
        model m;
        fill(&m, &r, (uint32_t)rng_int(&r, 1, 30), rng_int(&r, 1, SHAPES), (winding)(round % 4));
        roberts_scene *scene = scene_of_mesh(&m.mesh, NULL);
        assert_int_equal(scene->solid_count, m.solids);
        for (uint32_t s = 0; s < m.solids; s++)
            expect_as_alone(&m, scene, s);
        roberts_scene_free(scene);
        model_free(&m);
    }
}

/* A hundred equal cubes store the edges of one. If some cubes are wound inward, the edges of two are stored, since
 * their corners are in another order. Cubes whose own faces disagree store their own edges each. */
static void edges_are_stored_once(void **state)
{
    static const struct {
        winding wound;
        uint32_t shared;
        bool first[4]; /* whether some solid has its edges at 0, 12, 24, 36 */
    } cases[] = {
        {OUTWARD, 24, {true, false, false, false}},
        {INWARD, 24, {false, true, false, false}},
        {EITHER, 48, {true, false, false, true}}, /* the first solid is wound outward */
    };
    rng r = {22};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        model m = {0};
        bool first[4] = {false, false, false, false};
        do {
            model_free(&m);
            fill(&m, &r, 100, 1, cases[i].wound);
        } while (cases[i].wound == EITHER && m.mesh.corner[0] != 0);
        roberts_scene *scene = scene_of_mesh(&m.mesh, NULL);
        assert_int_equal(scene->shared, cases[i].shared);
        for (uint32_t s = 0; s < 100; s++) {
            assert_true(scene->solid[s].stored % 12 == 0 && scene->solid[s].stored < cases[i].shared);
            first[scene->solid[s].stored / 12] = true;
        }
        assert_memory_equal(first, cases[i].first, sizeof first);
        roberts_scene_free(scene);
        model_free(&m);
    }
}

static void disagreeing_solids_share_nothing(void **state)
{
    rng r = {26};
    model m;
    (void)state;
    fill(&m, &r, 50, 1, OUTWARD);
    for (uint32_t f = 0; f < m.mesh.face_count; f += 6)
        turn_over(&m.mesh, f);
    roberts_scene *scene = scene_of_mesh(&m.mesh, NULL);
    assert_int_equal(scene->shared, 0);
    for (uint32_t s = 0; s < 50; s++) {
        assert_int_equal(scene->solid[s].stored, 12 * s);
        expect_as_alone(&m, scene, s);
    }
    roberts_scene_free(scene);
    model_free(&m);
}

/* ---- a mesh that is taken over and refused --------------------------------------------------------------------- */

/* Cubes wound inward, the last one of them wrong. */
typedef enum fault { SOUND, FLAT, OPEN, DENTED } fault;

static void inward_cubes(model *m, fault wrong)
{
    rng r = {23};
    fill(m, &r, 10, 1, INWARD);
    roberts_vec3 *last = m->mesh.vertex + 72;
    uint32_t face[4];
    memcpy(face, m->mesh.corner + m->mesh.corner_count - 4, sizeof face);
    for (int i = 0; i < 4 && wrong == FLAT; i++)
        last[4 + i] = last[i];
    if (wrong == DENTED)
        last[7] = vec3_scale(0.5, vec3_add(last[7], last[0]));
    if (wrong == OPEN)
        m->mesh.face_start[--m->mesh.face_count] = (uint32_t)(m->mesh.corner_count -= 4);
}

static void a_mesh_refused_is_wound_as_it_was(void **state)
{
    static const roberts_status status[] = {ROBERTS_OK, ROBERTS_FLAT, ROBERTS_NOT_CLOSED, ROBERTS_NOT_PLANAR};
    (void)state;
    for (fault wrong = SOUND; wrong <= DENTED; wrong++)
        for (int hull = 0; hull < 2; hull++) {
            model m, copy;
            roberts_scene *taken, *built;
            const roberts_scene_options options = {.hull = hull, .solids = !hull};
            inward_cubes(&m, wrong);
            inward_cubes(&copy, wrong);
            roberts_status found = roberts_scene_take(&m.mesh, &options, &taken, NULL);
            assert_int_equal(found, roberts_scene_build(&copy.mesh, &options, &built, NULL));
            assert_int_equal(found, hull ? ROBERTS_OK : status[wrong]);
            if (found != ROBERTS_OK) {
                assert_int_equal(m.mesh.corner_count, copy.mesh.corner_count);
                assert_memory_equal(m.mesh.corner, copy.mesh.corner, copy.mesh.corner_count * sizeof(uint32_t));
            } else {
                expect_same_scene(taken, built);
                assert_null(m.mesh.corner);
            }
            roberts_scene_free(taken);
            roberts_scene_free(built);
            model_free(&m);
            model_free(&copy);
        }
}

/* An open solid beside whole ones that are wound inward: in the mesh that is welded, they must not be turned. */
static void welding_starts_from_the_mesh(void **state)
{
    (void)state;
    for (int loose = 0; loose < 2; loose++) {
        model m;
        roberts_scene *taken, *built;
        inward_cubes(&m, SOUND);
        if (loose) /* the last face gets vertices of its own */
            for (size_t i = m.mesh.corner_count - 4; i < m.mesh.corner_count; i++) {
                model_vertex(&m, m.mesh.vertex[m.mesh.corner[i]]);
                m.mesh.corner[i] = (uint32_t)m.mesh.vertex_count - 1;
            }
        assert_int_equal(roberts_scene_build(&m.mesh, NULL, &built, NULL), ROBERTS_OK);
        assert_int_equal(roberts_scene_take(&m.mesh, NULL, &taken, NULL), ROBERTS_OK);
        assert_int_equal(built->solid_count, 10);
        expect_same_scene(taken, built);
        roberts_scene_free(taken);
        roberts_scene_free(built);
        model_free(&m);
    }
}

/* ---- blocks ---------------------------------------------------------------------------------------------------- */

static bool find(const roberts_mesh *mesh, roberts_scene *scene, repeated_solids *list)
{
    polygons faces;
    bool found;
    *scene = (roberts_scene){0};
    *list = (repeated_solids){0};
    assert_int_equal(polygons_of_mesh(&faces, mesh, NULL), ROBERTS_OK);
    assert_true(components_in_a_row(scene, &faces, list, &found));
    return found;
}

/* The component of each vertex, named by its smallest vertex, by the definition: two vertices of a face belong
 * together. */
static void name_components(const roberts_mesh *mesh, uint32_t *name)
{
    bool changed = true;
    for (uint32_t v = 0; v < mesh->vertex_count; v++)
        name[v] = v;
    while (changed) {
        changed = false;
        for (size_t f = 0; f < mesh->face_count; f++) {
            uint32_t least = ROBERTS_NONE;
            for (uint32_t i = mesh->face_start[f]; i < mesh->face_start[f + 1]; i++)
                least = name[mesh->corner[i]] < least ? name[mesh->corner[i]] : least;
            for (uint32_t i = mesh->face_start[f]; i < mesh->face_start[f + 1]; i++) {
                changed |= name[mesh->corner[i]] != least;
                name[mesh->corner[i]] = least;
            }
        }
    }
}

/* Changes one thing about a mesh, or nothing. */
static void disturb(roberts_mesh *mesh, rng *r)
{
    uint32_t *corner = mesh->corner, n = (uint32_t)mesh->corner_count;
    uint32_t i = (uint32_t)rng_int(r, 0, (int)n - 1), k = (uint32_t)rng_int(r, 0, (int)n - 1), swapped = corner[i];
    switch (rng_int(r, 0, 4)) {
    case 0: /* two corners change places */
        corner[i] = corner[k];
        corner[k] = swapped;
        break;
    case 1: /* solids share a vertex, and one is out of use, or a face has one twice */
        corner[i] = corner[k];
        break;
    case 2: /* two vertices change their numbers */
        for (uint32_t j = 0; j < n; j++)
            corner[j] = corner[j] == swapped ? corner[k] : corner[j] == corner[k] ? swapped : corner[j];
        break;
    case 3: /* a vertex that no face uses */
        mesh_vertex(mesh, (roberts_vec3){0, 0, 0});
        break;
    default:
        break;
    }
}

static void expect_components(const roberts_mesh *mesh, const roberts_scene *scene)
{
    uint32_t *name = malloc(mesh->vertex_count * sizeof *name);
    name_components(mesh, name);
    assert_int_equal(scene->vertex_count, mesh->vertex_count);
    assert_int_equal(scene->face_count, mesh->face_count);
    assert_int_equal(scene->solid[scene->solid_count].vertex, mesh->vertex_count);
    assert_int_equal(scene->solid[scene->solid_count].face, mesh->face_count);
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        const scene_solid *first = scene->solid + s;
        for (uint32_t v = first->vertex; v < first[1].vertex; v++)
            assert_int_equal(name[v], first->vertex);
        for (uint32_t f = first->face; f < first[1].face; f++)
            assert_int_equal(name[mesh->corner[mesh->face_start[f]]], first->vertex);
    }
    free(name);
}

static void blocks_are_components(void **state)
{
    rng r = {24};
    int found = 0;
    (void)state;
    for (int round = 0; round < 3000; round++) {
        model m;
        roberts_scene scene;
        repeated_solids list;
        fill(&m, &r, (uint32_t)rng_int(&r, 1, 8), rng_int(&r, 1, SHAPES), (winding)(round % 4));
        disturb(&m.mesh, &r);
        if (find(&m.mesh, &scene, &list)) {
            expect_components(&m.mesh, &scene);
            found++;
        }
        free(scene.solid);
        repeated_free(&list);
        model_free(&m);
    }
    assert_in_range(found, 700, 2500);
}

static void faces_of(roberts_mesh *mesh, uint32_t vertices, const char *corners)
{
    *mesh = (roberts_mesh){0};
    for (uint32_t v = 0; v < vertices; v++)
        mesh_vertex(mesh, (roberts_vec3){v, 0, 0});
    for (const char *c = corners; *c; c += *c == ' ') {
        uint32_t face[16], n = 0;
        for (; *c && *c != ' '; c++)
            face[n++] = (uint32_t)(*c - 'a');
        mesh_face(mesh, face, n);
    }
}

static void some_are_no_blocks(void **state)
{
    static const struct {
        const char *what, *faces;  /* vertices by letters */
        uint32_t vertices, solids; /* 0: not found */
    } cases[] = {
        {"a tetrahedron", "abc adb bdc cda", 4, 1},
        {"two", "abc adb bdc cda efg ehf fhg ghe", 8, 2},
        {"two triangles back to back", "abc acb", 3, 1},
        {"opposite faces first", "abcd efgh aefb bfgc cghd dhea", 8, 1},
        {"nothing", "", 0, 0},
        {"vertices alone", "", 4, 0},
        {"one vertex", "aaa", 1, 0},
        {"a vertex too many", "abc adb bdc cda", 5, 0},
        {"a vertex left out between", "abc adb bdc cda fgh fig gih hif", 9, 0},
        {"the second begins first", "efg ehf fhg ghe abc adb bdc cda", 8, 0},
        {"faces take turns", "abc efg adb ehf bdc fhg cda ghe", 8, 0},
        {"the last face joins them", "abc adb bdc cda efg ehf fhg ghe aeb", 8, 0},
        {"a vertex in common", "abc adb bdc cda dfg dhf fhg ghd", 8, 0},
        {"open", "abc adb bdc", 4, 0},
        {"two corners", "abc adb bdc cda ab", 4, 0},
        {"a corner twice", "abc adb bdc cdac", 4, 0},
        {"no corner", "abc adb bdc cda  efg ehf fhg ghe", 8, 0},
        {"the same again, but for a face less", "abc adb bdc cda efg ehf fhg", 8, 0},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        roberts_mesh mesh;
        roberts_scene scene;
        repeated_solids list;
        faces_of(&mesh, cases[i].vertices, cases[i].faces);
        bool found = find(&mesh, &scene, &list);
        if (found != (cases[i].solids > 0) || scene.solid_count != cases[i].solids)
            fail_msg("%s: %s, %u solids", cases[i].what, found ? "found" : "not found", scene.solid_count);
        free(scene.solid);
        repeated_free(&list);
        roberts_mesh_free(&mesh);
    }
}

/* ---- boxes ----------------------------------------------------------------------------------------------------- */

static void a_box_by_lanes_is_the_same(void **state)
{
    static const double odd[] = {0.0, -0.0, INFINITY, -INFINITY, NAN, 1e300, -5e-324, 1.0};
    rng r = {25};
    (void)state;
    for (int round = 0; round < 10000; round++) {
        roberts_vec3 p[6], lo, hi, corner[2];
        uint32_t count = (uint32_t)rng_int(&r, 1, 6);
        for (uint32_t i = 0; i < count; i++)
            p[i] = (roberts_vec3){odd[rng_int(&r, 0, 7)], odd[rng_int(&r, 0, 7)], odd[rng_int(&r, 0, 7)]};
        lo = hi = corner[0] = corner[1] = p[0];
        for (uint32_t i = 1; i < count; i++)
            box_add(&lo, &hi, p[i]);
        box_add_all(&corner[0], &corner[1], p + 1, count - 1);
        assert_memory_equal(&corner[0], &lo, sizeof lo);
        assert_memory_equal(&corner[1], &hi, sizeof hi);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(solids_are_as_if_alone),
        cmocka_unit_test(edges_are_stored_once),
        cmocka_unit_test(disagreeing_solids_share_nothing),
        cmocka_unit_test(a_mesh_refused_is_wound_as_it_was),
        cmocka_unit_test(welding_starts_from_the_mesh),
        cmocka_unit_test(blocks_are_components),
        cmocka_unit_test(some_are_no_blocks),
        cmocka_unit_test(a_box_by_lanes_is_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
