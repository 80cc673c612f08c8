/* test_scene.c - solids from polygons: which faces belong together, planes, edges, refusals and their messages.
 *
 * Meshes are given as OFF text or made by small helpers. Whatever is accepted is checked by check_scene(), which tests
 * the invariants of scene.h and computes everything in other ways than src/. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/scene.h"
#include "folders.h"
#include "scenes.h"
#include "testing.h"

/* Anything that is no convex solid is refused. */
static const roberts_scene_options only_solids = {.solids = true};

/* ---- meshes ---------------------------------------------------------------------------------------------------- */

static uint32_t add_vertex(roberts_mesh *mesh, double x, double y, double z)
{
    uint32_t v;
    assert_int_equal(roberts_mesh_add_vertex(mesh, (roberts_vec3){x, y, z}, &v, NULL), ROBERTS_OK);
    return v;
}

static void add_face(roberts_mesh *mesh, const uint32_t *corner, size_t count)
{
    mesh_face(mesh, corner, count);
}

/* Adds vertices and faces from text like OFF's, but without colours, so that lines do not matter. */
static void read_text(roberts_mesh *mesh, const char *text)
{
    char *at = (char *)(uintptr_t)text + strlen("OFF");
    uint32_t first = (uint32_t)mesh->vertex_count, corner[16];
    long vertices = strtol(at, &at, 10), faces = strtol(at, &at, 10);
    assert_int_equal(strtol(at, &at, 10), 0);
    for (long i = 0; i < vertices; i++) {
        double x = strtod(at, &at), y = strtod(at, &at);
        add_vertex(mesh, x, y, strtod(at, &at));
    }
    for (long i = 0; i < faces; i++) {
        long count = strtol(at, &at, 10);
        assert_in_range(count, 1, 16);
        for (long k = 0; k < count; k++)
            corner[k] = first + (uint32_t)strtol(at, &at, 10);
        add_face(mesh, corner, (size_t)count);
    }
    while (*at == ' ')
        at++;
    assert_string_equal(at, ""); /* the text of the test is valid */
}

/* Corner c of the unit cube, by bits. */
static roberts_vec3 cube_corner(int c)
{
    return (roberts_vec3){c & 1, c >> 1 & 1, c >> 2 & 1};
}

/* Its faces, counter-clockwise from outside. */
static const uint32_t cube_face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

enum { WHOLE, SQUARES, TRIANGLES }; /* vertices shared by the cube; of each face its own; two triangles a face */

/* One side of the cube [x, x + 1] x [y, y + 1] x [z, z + 1], with vertices of its own. */
static void add_side(roberts_mesh *mesh, int x, int y, int z, int side, int kind)
{
    static const uint32_t half[2][3] = {{0, 1, 2}, {0, 2, 3}};
    for (int t = 0; t < (kind == TRIANGLES ? 2 : 1); t++) {
        uint32_t v[4];
        size_t count = kind == TRIANGLES ? 3 : 4;
        for (size_t i = 0; i < count; i++) {
            roberts_vec3 p = cube_corner((int)cube_face[side][kind == TRIANGLES ? half[t][i] : i]);
            v[i] = add_vertex(mesh, x + p.x, y + p.y, z + p.z);
        }
        add_face(mesh, v, count);
    }
}

static void add_cube(roberts_mesh *mesh, int x, int y, int z, int kind)
{
    uint32_t first = (uint32_t)mesh->vertex_count, v[4];
    for (int side = 0; side < 6 && kind != WHOLE; side++)
        add_side(mesh, x, y, z, side, kind);
    for (int c = 0; c < 8 && kind == WHOLE; c++)
        add_vertex(mesh, x + cube_corner(c).x, y + cube_corner(c).y, z + cube_corner(c).z);
    for (int side = 0; side < 6 && kind == WHOLE; side++) {
        for (int i = 0; i < 4; i++)
            v[i] = first + cube_face[side][i];
        add_face(mesh, v, 4);
    }
}

/* The mesh with its faces in a random order, each begun anywhere and wound either way. */
static void shuffle(roberts_mesh *mesh, rng *r)
{
    roberts_mesh mixed = {0};
    uint32_t count = (uint32_t)mesh->face_count, *order = calloc(count, sizeof *order), v[64];
    rng_permutation(r, order, count);
    for (size_t i = 0; i < mesh->vertex_count; i++)
        add_vertex(&mixed, mesh->vertex[i].x, mesh->vertex[i].y, mesh->vertex[i].z);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t *corner = mesh->corner + mesh->face_start[order[i]];
        uint32_t n = mesh->face_start[order[i] + 1] - mesh->face_start[order[i]];
        uint32_t begin = (uint32_t)rng_int(r, 0, (int)n - 1), step = rng_int(r, 0, 1) ? 1 : n - 1;
        assert_true(n <= 64);
        for (uint32_t k = 0; k < n; k++)
            v[k] = corner[(begin + k * step) % n];
        add_face(&mixed, v, n);
    }
    free(order);
    roberts_mesh_free(mesh);
    *mesh = mixed;
}

/* ---- invariants ------------------------------------------------------------------------------------------------ */

static roberts_vec3 at(const roberts_scene *scene, uint32_t v)
{
    return vec3_sub(scene->point[v], scene->centre);
}

/* (a - b) / length, also where 1 / length would overflow. */
static roberts_vec3 part(roberts_vec3 a, roberts_vec3 b, double length)
{
    return (roberts_vec3){(a.x - b.x) / length, (a.y - b.y) / length, (a.z - b.z) / length};
}

/* Whether a -> b are neighbours in this order round the face. */
static bool passes(const roberts_scene *scene, uint32_t f, uint32_t a, uint32_t b)
{
    for (uint32_t i = scene->face_start[f]; i < scene->face_start[f + 1]; i++) {
        uint32_t next = i + 1 < scene->face_start[f + 1] ? i + 1 : scene->face_start[f];
        if (scene->corner[i] == a && scene->corner[next] == b)
            return true;
    }
    return false;
}

/* Face f of solid s: its plane, and its corners turning clockwise about the inward normal. `largest`,
 * `slack`: lengths. */
static void check_face(const roberts_scene *scene, uint32_t s, uint32_t f, double largest, double slack)
{
    const scene_solid *first = scene->solid + s;
    uint32_t start = scene->face_start[f], count = scene->face_start[f + 1] - start;
    plane F = scene_plane(scene, f);
    double volume = 0.0;
    assert_true(count >= 3);
    assert_true(fabs(sqrt(F.a * F.a + F.b * F.b + F.c * F.c) - 1.0) < 1e-15);
    for (uint32_t i = 0; i < count; i++) {
        roberts_vec3 a = at(scene, scene->corner[start + i]), b = at(scene, scene->corner[start + (i + 1) % count]);
        assert_in_range(scene->corner[start + i], first->vertex, first[1].vertex - 1);
        for (uint32_t k = 0; k < i; k++)
            assert_true(scene->corner[start + i] != scene->corner[start + k]);
        assert_true(fabs(plane_at(F, a)) <= scene_deviation(scene, f) * (1.0 + 1e-9) + slack);
        volume +=
            vec3_dot((roberts_vec3){F.a, F.b, F.c}, vec3_cross(part(a, at(scene, scene->corner[start]), largest),
                                                               part(b, at(scene, scene->corner[start]), largest)));
    }
    if (scene_width(scene, f) > slack)
        assert_true(volume < 0.0);
    for (uint32_t v = first->vertex; v < first[1].vertex; v++) /* convex, and the right side */
        assert_true(plane_at(F, at(scene, v)) >= -slack - scene_deviation(scene, f));
}

static void check_edges(const roberts_scene *scene, uint32_t s)
{
    const scene_solid *first = scene->solid + s;
    scene_edge before = {0};
    for (uint32_t e = first->edge; e < first[1].edge; e++) {
        const scene_edge edge = scene_edge_at(scene, s, e);
        assert_true(edge.v[0] < edge.v[1] && edge.f[0] != edge.f[1]);
        assert_in_range(edge.v[0], first->vertex, first[1].vertex - 1);
        assert_in_range(edge.v[1], first->vertex, first[1].vertex - 1);
        assert_true(e == first->edge || before.v[0] < edge.v[0] ||
                    (before.v[0] == edge.v[0] && before.v[1] < edge.v[1]));
        for (int i = 0; i < 2; i++) {
            assert_in_range(edge.f[i], first->face, first[1].face - 1);
            assert_true(passes(scene, edge.f[i], edge.v[i], edge.v[1 - i]));
        }
        before = edge;
    }
}

/* `slack`: how far a vertex may lie outside a plane or beside its own, as a part of the scene's largest coordinate. */
static void check_scene(const roberts_scene *scene, double slack)
{
    double largest = 0.0;
    uint32_t corners = scene->face_start[scene->face_count];
    for (uint32_t v = 0; v < scene->vertex_count; v++) {
        roberts_vec3 p = scene->point[v];
        largest = fmax(largest, fmax(fabs(p.x), fmax(fabs(p.y), fabs(p.z))));
    }
    assert_int_equal(scene->solid[0].vertex | scene->solid[0].face | scene->solid[0].edge, 0);
    assert_int_equal(scene->solid[scene->solid_count].vertex, scene->vertex_count);
    assert_int_equal(scene->solid[scene->solid_count].face, scene->face_count);
    assert_int_equal(scene->solid[scene->solid_count].edge, scene->edge_count);
    assert_true(corners == scene->corner_count && corners == 2 * (size_t)scene->edge_count);
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        const scene_solid *first = scene->solid + s;
        assert_int_equal((first[1].vertex - first->vertex) + (first[1].face - first->face),
                         (first[1].edge - first->edge) + 2);
        if (s > 0)
            assert_true(scene_vertex_number(scene, first[-1].vertex) <= scene_vertex_number(scene, first->vertex));
        for (uint32_t v = first->vertex + 1; v < first[1].vertex; v++)
            assert_true(scene_vertex_number(scene, v - 1) < scene_vertex_number(scene, v));
        for (uint32_t f = first->face + 1; f < first[1].face; f++)
            assert_true(scene_face_number(scene, f - 1) < scene_face_number(scene, f));
        for (uint32_t f = first->face; f < first[1].face; f++)
            check_face(scene, s, f, largest, slack * largest);
        check_edges(scene, s);
    }
}

/* Builds, expects success, checks; the caller frees. */
static roberts_scene *accept(const char *name, const roberts_mesh *mesh, double slack)
{
    roberts_scene *scene;
    roberts_error error = {0};
    if (roberts_scene_build(mesh, &only_solids, &scene, &error) != ROBERTS_OK)
        fail_msg("%s: %s: %s", name, error.file, error.message);
    check_scene(scene, slack);
    return scene;
}

static void refuse(const char *name, const roberts_mesh *mesh, roberts_status status, const char *message)
{
    roberts_scene *scene;
    roberts_error error = {0};
    roberts_status got = roberts_scene_build(mesh, &only_solids, &scene, &error);
    if (got != status || error.status != status || strcmp(error.message, message) != 0)
        fail_msg("%s: status %d (%s), expected %d (%s)", name, got, error.message, status, message);
    assert_null(scene);
}

/* ---- accepted and refused -------------------------------------------------------------------------------------- */

#define CUBE_VERTICES "0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1 "
#define CUBE_FACES "4 0 2 3 1 4 4 5 7 6 4 0 1 5 4 4 2 6 7 3 4 0 4 6 2 4 1 3 7 5 "
#define TETRA_VERTICES "0 0 0 1 0 0 0 1 0 0 0 1 "

static const struct {
    const char *name, *text;
    uint32_t solids, vertices, faces, edges;
} accepted_cases[] = {
    {"tetrahedron", "OFF 4 4 0 " TETRA_VERTICES "3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2", 1, 4, 4, 6},
    {"every second face wound the other way", "OFF 4 4 0 " TETRA_VERTICES "3 0 1 2 3 0 1 3 3 1 3 2 3 0 3 2", 1, 4, 4,
     6},
    {"cube", "OFF 8 6 0 " CUBE_VERTICES CUBE_FACES, 1, 8, 6, 12},
    {"vertices that no face uses, the first and the last",
     "OFF 10 6 0 99 99 99 " CUBE_VERTICES "-99 -99 -99 4 1 3 4 2 4 5 6 8 7 4 1 2 6 5 4 3 7 8 4 4 1 5 7 3 4 2 4 8 6", 1,
     8, 6, 12},
    {"faces with one and two corners", "OFF 8 9 0 " CUBE_VERTICES "1 0 2 0 7 " CUBE_FACES "2 3 3", 1, 8, 6, 12},
    {"a vertex that only a two-cornered face uses", "OFF 9 7 0 " CUBE_VERTICES "50 50 50 2 0 8 " CUBE_FACES, 1, 8, 6,
     12},
    {"repeated corners: next to each other, first and last, with one between",
     "OFF 8 6 0 " CUBE_VERTICES "5 0 2 2 3 1 5 4 5 7 6 4 6 0 1 5 4 1 0 4 2 6 7 3 4 0 4 6 2 4 1 3 7 5", 1, 8, 6, 12},
    {"a face that repeated corners leave with two", "OFF 8 7 0 " CUBE_VERTICES CUBE_FACES "4 0 1 0 1", 1, 8, 6, 12},
    {"a corner in the middle of an edge, in both faces",
     "OFF 9 6 0 " CUBE_VERTICES ".5 0 0 5 0 2 3 1 8 4 4 5 7 6 5 0 8 1 5 4 4 2 6 7 3 4 0 4 6 2 4 1 3 7 5", 1, 9, 6, 13},
    {"a face cut into a convex and another piece in the same plane",
     "OFF 8 7 0 " CUBE_VERTICES "3 0 2 3 3 0 3 1 4 4 5 7 6 4 0 1 5 4 4 2 6 7 3 4 0 4 6 2 4 1 3 7 5", 1, 8, 7, 13},
    /* The triangle 0 8 1 has no area and no plane of its own; without it the surface is not closed. */
    {"a corner on one face's side only, closed by a triangle without area",
     "OFF 9 7 0 " CUBE_VERTICES ".5 0 0 5 0 2 3 1 8 4 4 5 7 6 4 0 1 5 4 4 2 6 7 3 4 0 4 6 2 4 1 3 7 5 3 0 8 1", 1, 9, 7,
     14},
    {"two vertices at one place: an edge of no length",
     "OFF 9 7 0 " CUBE_VERTICES "0 0 0 5 0 8 2 3 1 4 4 5 7 6 4 0 1 5 4 4 2 6 7 3 4 8 4 6 2 4 1 3 7 5 3 0 4 8", 1, 9, 7,
     14},
    {"a bevel narrower than the rounding, which leans outward: neighbours lend it winding and plane",
     "OFF 10 7 0 0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1.000001 0 1 0 1 1 1.000001 1 1 1 0 .999999 1 1 .999999 "
     "4 0 2 3 1 4 4 5 7 6 5 0 1 8 5 4 5 2 6 7 9 3 4 0 4 6 2 4 1 3 9 8 4 5 8 9 7",
     1, 10, 7, 15},
    {"a cube round another",
     "OFF 16 12 0 " CUBE_VERTICES "-1 -1 -1 2 -1 -1 -1 2 -1 2 2 -1 -1 -1 2 2 -1 2 -1 2 2 2 2 2 " CUBE_FACES
     "4 8 10 11 9 4 12 13 15 14 4 8 9 13 12 4 10 14 15 11 4 8 12 14 10 4 9 11 15 13",
     2, 16, 12, 24},
    {"two tetrahedra, vertices and faces by turns",
     "OFF 8 8 0 0 0 0 5 0 0 1 0 0 6 0 0 0 1 0 5 1 0 0 0 1 5 0 1 "
     "3 0 4 2 3 1 5 3 3 0 2 6 3 1 3 7 3 2 4 6 3 3 5 7 3 0 6 4 3 1 7 5",
     2, 8, 8, 12},
    {"two tetrahedra with a vertex in common",
     "OFF 7 8 0 " TETRA_VERTICES "-1 0 0 0 -1 0 0 0 -1 "
     "3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2 3 0 4 5 3 0 6 4 3 4 6 5 3 0 5 6",
     2, 8, 8, 12},
    {"two tetrahedra with an edge in common",
     "OFF 6 8 0 " TETRA_VERTICES "-1 0 0 0 -1 0 "
     "3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2 3 0 4 5 3 0 3 4 3 4 3 5 3 0 5 3",
     2, 8, 8, 12},
    {"the same tetrahedron twice, with the same vertices",
     "OFF 4 8 0 " TETRA_VERTICES "3 0 2 1 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2 3 0 1 3 3 1 2 3 3 0 3 2", 2, 8, 8, 12},
    {"a tetrahedron whose triangles have their own vertices, -0 for 0",
     "OFF 12 4 0 0 0 0 0 1 0 1 0 0  -0 0 0 1 -0 0 0 0 1  1 0 0 0 1 0 0 0 1  0 0 -0 0 0 1 0 1 0 "
     "3 0 1 2 3 3 4 5 3 6 7 8 3 9 10 11",
     1, 4, 4, 6},
    {"six digits: a turned dodecahedron's pentagon on a pyramid",
     "OFF 6 6 0 0.850651 0.000001 0 0.262866 0.809017 0 -0.688191 0.5 0.000001 -0.688191 -0.5 0 0.262866 -0.809017 "
     "0 0 0 1 5 0 1 2 3 4 3 0 1 5 3 1 2 5 3 2 3 5 3 3 4 5 3 4 0 5",
     1, 6, 6, 10},
};

static void sound_solids_are_accepted(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof accepted_cases / sizeof *accepted_cases; i++) {
        roberts_mesh mesh = {0};
        read_text(&mesh, accepted_cases[i].text);
        roberts_scene *scene = accept(accepted_cases[i].name, &mesh, 3e-5);
        if (roberts_scene_solid_count(scene) != accepted_cases[i].solids ||
            roberts_scene_vertex_count(scene) != accepted_cases[i].vertices ||
            roberts_scene_face_count(scene) != accepted_cases[i].faces ||
            roberts_scene_edge_count(scene) != accepted_cases[i].edges)
            fail_msg("%s: %u solids, %u vertices, %u faces, %u edges", accepted_cases[i].name, scene->solid_count,
                     scene->vertex_count, scene->face_count, scene->edge_count);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

static const struct {
    const char *name, *text;
    roberts_status status;
    const char *message;
} refused_cases[] = {
    {"nothing", "OFF 0 0 0", ROBERTS_NOT_CLOSED, "nothing to draw: there is no face with three different corners"},
    {"lines only", "OFF 2 1 0 0 0 0 1 1 1 2 0 1", ROBERTS_NOT_CLOSED,
     "nothing to draw: there is no face with three different corners"},
    {"a box without a lid", "OFF 8 5 0 " CUBE_VERTICES "4 0 2 3 1 4 0 1 5 4 4 2 6 7 3 4 0 4 6 2 4 1 3 7 5",
     ROBERTS_NOT_CLOSED, "solid 0 is not closed: edge 4-5 belongs to 1 face instead of 2 (4 such edges in all)"},
    {"one face twice", "OFF 8 7 0 " CUBE_VERTICES CUBE_FACES "4 1 3 2 0", ROBERTS_NOT_CLOSED,
     "solid 0 is not closed: edge 0-1 belongs to 3 faces instead of 2 (4 such edges in all)"},
    {"a corner on one face's side only",
     "OFF 9 6 0 " CUBE_VERTICES ".5 0 0 5 0 2 3 1 8 4 4 5 7 6 4 0 1 5 4 4 2 6 7 3 4 0 4 6 2 4 1 3 7 5",
     ROBERTS_NOT_CLOSED, "solid 0 is not closed: edge 0-1 belongs to 1 face instead of 2 (3 such edges in all)"},
    {"the second solid is open",
     "OFF 12 10 0 " CUBE_VERTICES TETRA_VERTICES CUBE_FACES "3 8 10 9 3 8 9 11 3 9 10 11 1 0", ROBERTS_NOT_CLOSED,
     "solid 1 is not closed: edge 8-10 belongs to 1 face instead of 2 (3 such edges in all)"},
    {"a single triangle", "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2", ROBERTS_NOT_CLOSED,
     "solid 0 is not closed: edge 0-1 belongs to 1 face instead of 2 (3 such edges in all)"},
    {"a triangle from both sides", "OFF 3 2 0 0 0 0 1 0 0 0 1 0 3 0 1 2 3 0 2 1", ROBERTS_FLAT,
     "solid 0 is flat: 0 thick where it is 1.41421 across"},
    {"all in one point", "OFF 4 4 0 1 1 1 1 1 1 1 1 1 1 1 1 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2", ROBERTS_FLAT,
     "solid 0 is flat: all its vertices lie in one point"},
    {"all in one line", "OFF 4 4 0 0 0 0 1 1 1 2 2 2 3 3 3 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2", ROBERTS_FLAT,
     "solid 0 is flat: none of its faces has an area"},
    {"a corner lifted off its face", "OFF 8 6 0 0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1.001 " CUBE_FACES,
     ROBERTS_NOT_PLANAR, "face 1 of solid 0 is not planar: its corners lie up to 0.00025 beside their plane"},
    {"a concave face, the rest of its plane filled by a triangle",
     "OFF 9 7 0 " CUBE_VERTICES ".5 .25 0 5 0 2 3 1 8 4 4 5 7 6 4 0 1 5 4 4 2 6 7 3 4 0 4 6 2 4 1 3 7 5 3 0 8 1",
     ROBERTS_NOT_CONVEX, "face 0 of solid 0 is not a convex polygon: vertex 8 lies 0.25 inside its outline"},
    {"a face that crosses itself, without area on the whole",
     "OFF 8 6 0 " CUBE_VERTICES "4 0 3 2 1 4 4 7 6 5 4 0 1 5 4 4 1 2 6 5 4 2 3 7 6 4 3 0 4 7", ROBERTS_NOT_CONVEX,
     "face 0 of solid 0 is not a convex polygon: it crosses itself"},
    {"a dented cube in triangles",
     "OFF 9 9 0 " CUBE_VERTICES
     ".5 .5 .7 4 0 2 3 1 3 4 5 8 3 5 7 8 3 7 6 8 3 6 4 8 4 0 1 5 4 4 2 6 7 3 4 0 4 6 2 4 1 3 7 5",
     ROBERTS_NOT_CONVEX, "solid 0 is not convex: vertex 6 lies 0.514496 outside face 1"},
    /* Every vertex is behind every face, but the ring of sides goes round twice. */
    {"two turns round one axis",
     "OFF 10 16 0 1 0 0 0 1 0 -1 0 0 0 -1 0 1 0 0 0 1 0 -1 0 0 0 -1 0 0 0 1 0 0 -1 "
     "3 0 1 8 3 1 2 8 3 2 3 8 3 3 4 8 3 4 5 8 3 5 6 8 3 6 7 8 3 7 0 8 "
     "3 1 0 9 3 2 1 9 3 3 2 9 3 4 3 9 3 5 4 9 3 6 5 9 3 7 6 9 3 0 7 9",
     ROBERTS_NOT_CONVEX, "solid 0 is not convex: its faces go round it 2 times"},
    {"a surface with one side (projective plane on an icosahedron's half)",
     "OFF 6 10 0 0 1 1.618 0 -1 1.618 1.618 0 1 1 1.618 0 -1 1.618 0 -1.618 0 1 "
     "3 0 1 2 3 0 2 3 3 0 3 4 3 0 4 5 3 0 5 1 3 1 2 4 3 2 3 5 3 3 4 1 3 4 5 2 3 5 1 3",
     ROBERTS_NOT_CONVEX, "solid 0 is not convex: its surface has one side only"},
};

static void others_are_refused_and_told_why(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof refused_cases / sizeof *refused_cases; i++) {
        roberts_mesh mesh = {0};
        read_text(&mesh, refused_cases[i].text);
        refuse(refused_cases[i].name, &mesh, refused_cases[i].status, refused_cases[i].message);
        roberts_mesh_free(&mesh);
    }
}

static void names_the_file_without_solids(void **state)
{
    static const char text[] = "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n";
    roberts_mesh mesh = {0};
    roberts_scene *scene;
    roberts_error error = {0};
    (void)state;
    assert_int_equal(roberts_mesh_read_memory(&mesh, "points.off", text, strlen(text), NULL, &error), ROBERTS_OK);
    assert_int_equal(roberts_scene_build(&mesh, &only_solids, &scene, &error), ROBERTS_NOT_CLOSED);
    assert_string_equal(error.file, "points.off");
    roberts_mesh_free(&mesh);
}

/* ---- several inputs, options, colours -------------------------------------------------------------------------- */

static void the_input_that_holds_the_face_is_named(void **state)
{
    roberts_mesh mesh = {0};
    roberts_scene *scene;
    roberts_error error = {0};
    const char *second = "OFF 9 9 0\n0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1 .5 .5 .7\n4 0 2 3 1\n3 4 5 8\n"
                         "3 5 7 8\n3 7 6 8\n3 6 4 8\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
    (void)state;
    read_text(&mesh, "OFF 8 6 0 " CUBE_VERTICES CUBE_FACES);
    assert_int_equal(roberts_mesh_read_memory(&mesh, "dent.off", second, strlen(second), NULL, NULL), ROBERTS_OK);
    assert_int_equal(roberts_scene_build(&mesh, &only_solids, &scene, &error), ROBERTS_NOT_CONVEX);
    assert_string_equal(error.file, "dent.off");
    assert_string_equal(error.message, "solid 0 is not convex: vertex 6 lies 0.514496 outside face 1");
    roberts_mesh_free(&mesh);
}

static void the_tolerance_decides(void **state)
{
    static const struct {
        double tolerance;
        roberts_status status;
    } cases[] = {{0, ROBERTS_NOT_PLANAR},
                 {1e-4, ROBERTS_NOT_PLANAR},
                 {1e-3, ROBERTS_OK},
                 {1, ROBERTS_OK},
                 {-1e-9, ROBERTS_BAD_ARGUMENT},
                 {1.5, ROBERTS_BAD_ARGUMENT},
                 {NAN, ROBERTS_BAD_ARGUMENT},
                 {INFINITY, ROBERTS_BAD_ARGUMENT}};
    roberts_mesh mesh = {0};
    (void)state;
    read_text(&mesh, "OFF 8 6 0 0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1.001 " CUBE_FACES);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        roberts_scene_options options = {.solids = true, .tolerance = cases[i].tolerance};
        roberts_scene *scene;
        roberts_error error = {0};
        if (roberts_scene_build(&mesh, &options, &scene, &error) != cases[i].status)
            fail_msg("tolerance %g: %s", cases[i].tolerance, error.message);
        roberts_scene_free(scene);
    }
    roberts_mesh_free(&mesh);
}

static void note_warning(void *context, const char *file, size_t line, const char *message)
{
    snprintf(context, 200, "%s:%zu: %s", file, line, message);
}

static void repeated_corners_are_counted(void **state)
{
    const char *text = "OFF 4 5 0\n" TETRA_VERTICES "\n5 0 0 2 1 2\n3 0 1 3\n3 1 2 3\n3 0 3 2\n4 1 2 1 2\n";
    roberts_mesh mesh = {0};
    char said[200] = "";
    roberts_scene_options options = {.warnings = {note_warning, said}};
    (void)state;
    assert_int_equal(roberts_mesh_read_memory(&mesh, "test.off", text, strlen(text), NULL, NULL), ROBERTS_OK);
    roberts_scene *scene = scene_of_mesh(&mesh, &options);
    assert_string_equal(said, "test.off:0: 4 corners that repeat another of the same face ignored");
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
}

static void colours_follow_their_vertices_and_faces(void **state)
{
    const char *text = "COFF 5 5 0\n9 9 9 9 9 9 9\n0 0 0 10 10 10 10\n1 0 0 20 20 20 20\n0 1 0 30 30 30 30\n"
                       "0 0 1 40 40 40 40\n1 0 7\n3 1 3 2 1\n3 1 2 4 2\n3 2 3 4 3\n3 3 1 4 4\n";
    roberts_mesh mesh = {0};
    roberts_scene *scene;
    (void)state;
    assert_int_equal(roberts_mesh_read_memory(&mesh, "test.off", text, strlen(text), NULL, NULL), ROBERTS_OK);
    scene = accept("colours", &mesh, 1e-15);
    assert_non_null(scene->vertex_color);
    assert_non_null(scene->face_color);
    for (uint32_t v = 0; v < 4; v++)
        assert_memory_equal(&scene->vertex_color[v], &mesh.vertex_color[v + 1], sizeof(roberts_color));
    for (uint32_t f = 0; f < 4; f++)
        assert_memory_equal(&scene->face_color[f], &mesh.face_color[f + 1], sizeof(roberts_color));
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
}

/* ---- numbers --------------------------------------------------------------------------------------------------- */

/* Faces parallel to the coordinate planes get exact planes, wherever they are and whatever their size. */
static void planes_are_exact(void **state)
{
    static const double at_x[] = {0, 1e8, -3e15, 0, 0}, scale[] = {1, 1, 1, 0x1p-660, 0x1p330};
    (void)state;
    for (size_t i = 0; i < sizeof scale / sizeof *scale; i++) {
        roberts_mesh mesh = {0};
        for (int c = 0; c < 8; c++)
            add_vertex(&mesh, scale[i] * (at_x[i] + 2 * cube_corner(c).x), scale[i] * (2 * cube_corner(c).y - 7),
                       scale[i] * (2 * cube_corner(c).z));
        for (int f = 0; f < 6; f++)
            add_face(&mesh, cube_face[f], 4);
        roberts_scene *scene = accept("exact", &mesh, 0.0);
        for (uint32_t f = 0; f < 6; f++) {
            plane F = scene_plane(scene, f);
            assert_true(fabs(F.a) + fabs(F.b) + fabs(F.c) == 1.0);
            assert_true(F.d == scale[i] && scene_deviation(scene, f) == 0.0);
            double width =
                scene_width(scene, f) / scale[i]; /* 4 over a diagonal of 2 sqrt 2, rounded down to a float */
            assert_true(width <= sqrt(2.0) && width > sqrt(2.0) * (1.0 - 0x1p-22));
        }
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

/* A solid times 2^k has the same planes, and any size that can be read is taken. */
static void scale_changes_nothing(void **state)
{
    static const int powers[] = {-1060, -990, -665, -201, -27, 27, 199, 201, 497};
    rng r = {11};
    roberts_vec3 point[8];
    roberts_mesh mesh = {0};
    mat3 turn = {{0.8, 0.6, 0}, {-0.36, 0.48, 0.8}, {0.48, -0.64, 0.6}};
    (void)state;
    for (int c = 0; c < 8; c++) {
        point[c] = mat3_map(turn, cube_corner(c));
        add_vertex(&mesh, point[c].x, point[c].y, point[c].z);
    }
    for (int f = 0; f < 6; f++)
        add_face(&mesh, cube_face[f], 4);
    shuffle(&mesh, &r);
    roberts_scene *one = accept("times one", &mesh, 1e-15);
    for (size_t i = 0; i < sizeof powers / sizeof *powers; i++) {
        bool coarse = powers[i] < -1000; /* coordinates of few bits: see that it passes */
        for (int c = 0; c < 8; c++)
            mesh.vertex[c] = (roberts_vec3){ldexp(point[c].x, powers[i]), ldexp(point[c].y, powers[i]),
                                            ldexp(point[c].z, powers[i])};
        roberts_scene *scene = accept("times 2^k", &mesh, coarse ? 1e-4 : 1e-15);
        for (uint32_t f = 0; f < 6 && !coarse; f++) {
            plane F = scene_plane(one, f), G = scene_plane(scene, f);
            assert_true(F.a == G.a && F.b == G.b && F.c == G.c && ldexp(F.d, powers[i]) == G.d);
            assert_true(ldexp(scene_width(one, f), powers[i]) == scene_width(scene, f));
        }
        roberts_scene_free(scene);
    }
    roberts_scene_free(one);
    roberts_mesh_free(&mesh);
}

static void sizes_and_places(void **state)
{
    static const struct {
        const char *name;
        double scale, offset, thickness;
        roberts_status status;
    } cases[] = {
        {"at 1e8", 1, 1e8, 1, ROBERTS_OK},
        {"times 1e-8", 1e-8, 0, 1, ROBERTS_OK},
        {"times 1e8", 1e8, 0, 1, ROBERTS_OK},
        {"times 1e-200", 1e-200, 0, 1, ROBERTS_OK},
        {"times 1e100", 1e100, 0, 1, ROBERTS_OK},
        {"times 1e149", 1e149, 0, 1, ROBERTS_OK},
        {"plate 1e-3 thick", 1, 0, 1e-3, ROBERTS_OK},
        {"plate 1e-6 thick", 1, 0, 1e-6, ROBERTS_OK},
        {"plate 1e-8 thick", 1, 0, 1e-8, ROBERTS_OK},
        {"plate 1e-10 thick", 1, 0, 1e-10, ROBERTS_FLAT},
        {"plate 1e-10 thick, times 1e100", 1e100, 0, 1e-10, ROBERTS_FLAT},
        {"plate without thickness", 1, 0, 0, ROBERTS_FLAT},
    };
    mat3 turn = {{0.8, 0.6, 0}, {-0.36, 0.48, 0.8}, {0.48, -0.64, 0.6}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        roberts_mesh mesh = {0};
        roberts_scene *scene;
        roberts_error error = {0};
        for (int c = 0; c < 8; c++) {
            roberts_vec3 p = cube_corner(c);
            p.z *= cases[i].thickness;
            p = mat3_map(turn, p);
            add_vertex(&mesh, cases[i].scale * p.x + cases[i].offset, cases[i].scale * p.y + cases[i].offset,
                       cases[i].scale * p.z + cases[i].offset);
        }
        for (int f = 0; f < 6; f++)
            add_face(&mesh, cube_face[f], 4);
        if (roberts_scene_build(&mesh, &only_solids, &scene, &error) != cases[i].status)
            fail_msg("%s: %s", cases[i].name, error.message);
        if (scene)
            check_scene(scene, 1e-15);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

/* Numbers that a program may write into a mesh directly, without roberts_mesh_add_vertex(). */
static void numbers_that_are_none_are_refused(void **state)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1e151, 1e308};
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        for (int kind = WHOLE; kind <= TRIANGLES; kind++) {
            roberts_mesh mesh = {0};
            roberts_scene *scene;
            add_cube(&mesh, 0, 0, 0, kind);
            mesh.vertex[5].y = bad[i];
            assert_int_equal(roberts_scene_build(&mesh, NULL, &scene, NULL), ROBERTS_BAD_NUMBER);
            roberts_mesh_free(&mesh);
        }
}

/* A regular dodecahedron: the twenty vertices and the twelve pentagons round the directions (0, 1, phi). */
static void add_dodecahedron(roberts_mesh *mesh, mat3 turn, double digits)
{
    const double phi = 0.5 * (1 + sqrt(5.0));
    roberts_vec3 p[20];
    int count = 0;
    for (int i = 0; i < 8; i++)
        p[count++] = (roberts_vec3){i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1};
    for (int i = 0; i < 4; i++) {
        double a = (i & 1 ? 1 : -1) / phi, b = (i & 2 ? 1 : -1) * phi;
        p[count++] = (roberts_vec3){0, a, b};
        p[count++] = (roberts_vec3){a, b, 0};
        p[count++] = (roberts_vec3){b, 0, a};
    }
    uint32_t first = (uint32_t)mesh->vertex_count;
    for (int i = 0; i < 20; i++) {
        roberts_vec3 q = mat3_map(turn, p[i]);
        add_vertex(mesh, round(q.x * digits) / digits, round(q.y * digits) / digits, round(q.z * digits) / digits);
    }
    for (int i = 0; i < 12; i++) {
        double a = i & 1 ? 1 : -1, b = (i & 2 ? 1 : -1) * phi;
        roberts_vec3 n = i < 4 ? (roberts_vec3){0, b, a} : i < 8 ? (roberts_vec3){b, a, 0} : (roberts_vec3){a, 0, b};
        roberts_vec3 u = vec3_cross(n, (roberts_vec3){1, 2, 3}), w = vec3_cross(n, u);
        uint32_t corner[5];
        double angle[5];
        int size = 0;
        w = vec3_scale(1 / vec3_length(n), w);
        for (int v = 0; v < 20; v++) {
            if (vec3_dot(n, p[v]) < phi * phi - 1e-9)
                continue;
            int k = size++;
            double here = atan2(vec3_dot(w, p[v]), vec3_dot(u, p[v]));
            for (; k > 0 && angle[k - 1] > here; k--) {
                angle[k] = angle[k - 1];
                corner[k] = corner[k - 1];
            }
            angle[k] = here;
            corner[k] = first + (uint32_t)v;
        }
        assert_int_equal(size, 5);
        add_face(mesh, corner, 5);
    }
}

static void six_digits_are_enough(void **state)
{
    rng r = {5};
    (void)state;
    for (int i = 0; i < 200; i++) {
        roberts_mesh mesh = {0};
        add_dodecahedron(&mesh, mat3_turn(&r), 1e6);
        shuffle(&mesh, &r);
        roberts_scene *scene = accept("dodecahedron", &mesh, 1e-5);
        assert_int_equal(roberts_scene_edge_count(scene), 30);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

/* ---- soup ------------------------------------------------------------------------------------------------------ */

/* Builds, and expects `solids` cubes, each with 8 vertices, and 6 or 12 faces. */
static void expect_cubes(const char *name, const roberts_mesh *mesh, uint32_t solids, int kind)
{
    roberts_scene *scene = accept(name, mesh, 1e-15);
    if (scene->solid_count != solids)
        fail_msg("%s: %u solids instead of %u", name, scene->solid_count, solids);
    for (uint32_t s = 0; s < solids; s++) {
        assert_int_equal(scene->solid[s + 1].vertex - scene->solid[s].vertex, 8);
        assert_int_equal(scene->solid[s + 1].face - scene->solid[s].face, kind == TRIANGLES ? 12 : 6);
    }
    roberts_scene_free(scene);
}

static const struct {
    const char *name;
    int count, at[4][3];
} soups[] = {
    {"one", 1, {{0, 0, 0}}},
    {"two that share a face", 2, {{0, 0, 0}, {1, 0, 0}}},
    {"two that share an edge", 2, {{0, 0, 0}, {1, 1, 0}}},
    {"two that share a corner", 2, {{0, 0, 0}, {1, 1, 1}}},
    {"two at the same place", 2, {{0, 0, 0}, {0, 0, 0}}},
    {"three in an L", 3, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
    {"four round an edge", 4, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}},
    {"four on diagonals", 4, {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}},
};

static void touching_cubes_of_loose_faces_come_apart(void **state)
{
    rng r = {3};
    (void)state;
    for (size_t i = 0; i < sizeof soups / sizeof *soups; i++)
        for (int kind = SQUARES; kind <= TRIANGLES; kind++)
            for (int mixed = 0; mixed < 8; mixed++) {
                roberts_mesh mesh = {0};
                for (int k = 0; k < soups[i].count; k++)
                    add_cube(&mesh, soups[i].at[k][0], soups[i].at[k][1], soups[i].at[k][2], kind);
                if (mixed)
                    shuffle(&mesh, &r);
                expect_cubes(soups[i].name, &mesh, (uint32_t)soups[i].count, kind);
                roberts_mesh_free(&mesh);
            }
}

/* n x n x n cubes: `kind` as above, or all over one grid of shared vertices. Without the cube in the middle if
 * `hollow`. */
static void add_block(roberts_mesh *mesh, int n, int kind, bool shared, bool hollow)
{
    for (int i = 0; shared && i < (n + 1) * (n + 1) * (n + 1); i++)
        add_vertex(mesh, i % (n + 1), i / (n + 1) % (n + 1), i / ((n + 1) * (n + 1)));
    for (int i = 0; i < n * n * n; i++) {
        int x = i % n, y = i / n % n, z = i / (n * n);
        if (hollow && 2 * x + 1 == n && 2 * y + 1 == n && 2 * z + 1 == n)
            continue;
        if (!shared)
            add_cube(mesh, x, y, z, kind);
        for (int side = 0; shared && side < 6; side++) {
            uint32_t v[4];
            for (int k = 0; k < 4; k++) {
                roberts_vec3 p = cube_corner((int)cube_face[side][k]);
                v[k] =
                    (uint32_t)((z + (int)p.z) * (n + 1) + y + (int)p.y) * (uint32_t)(n + 1) + (uint32_t)(x + (int)p.x);
            }
            add_face(mesh, v, 4);
        }
    }
}

static void blocks_come_apart(void **state)
{
    rng r = {8};
    (void)state;
    for (int n = 1; n <= 5; n++)
        for (int kind = SQUARES; kind <= TRIANGLES; kind++)
            for (int variant = 0; variant < 8; variant++) {
                bool shared = variant & 1, hollow = (variant & 2) && n % 2 && n > 1, mixed = variant & 4;
                char name[80];
                roberts_mesh mesh = {0};
                if (shared && kind == TRIANGLES)
                    continue;
                snprintf(name, sizeof name, "block of %d^3, kind %d%s%s%s", n, kind, shared ? ", shared vertices" : "",
                         hollow ? ", hollow" : "", mixed ? ", shuffled" : "");
                add_block(&mesh, n, kind, shared, hollow);
                if (mixed)
                    shuffle(&mesh, &r);
                expect_cubes(name, &mesh, (uint32_t)(n * n * n - hollow), kind);
                roberts_mesh_free(&mesh);
            }
}

/* Welding joins only open components: cubes that are complete in the file take no part in it. */
static void closed_components_are_not_welded(void **state)
{
    roberts_mesh mesh = {0};
    (void)state;
    add_cube(&mesh, 0, 0, 0, WHOLE);
    add_cube(&mesh, 1, 0, 0, SQUARES);
    add_cube(&mesh, 1, 1, 0, WHOLE);
    add_cube(&mesh, 0, 0, 0, SQUARES);
    roberts_scene *scene = accept("whole and loose", &mesh, 1e-15);
    assert_int_equal(scene->solid_count, 4);
    assert_int_equal(scene_vertex_number(scene, scene->solid[0].vertex), 0);
    assert_int_equal(scene_vertex_number(scene, scene->solid[1].vertex), 8);
    assert_int_equal(scene_vertex_number(scene, scene->solid[2].vertex),
                     8); /* the loose ones share vertex 8, at 1 0 0 */
    assert_int_equal(scene_vertex_number(scene, scene->solid[3].vertex), 32);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
}

/* Turned, wound and cut open at random: the answer depends only on the faces, not on their order. */
static void missing_faces_are_noticed(void **state)
{
    rng r = {21};
    (void)state;
    for (int i = 0; i < 50; i++) {
        roberts_mesh mesh = {0};
        roberts_scene *scene;
        roberts_error error = {0};
        int missing = rng_int(&r, 0, 26 * 6 + 5);
        for (int k = 0; k < 27 * 6; k++)
            if (k != missing)
                add_side(&mesh, k / 6 % 3, k / 18 % 3, k / 54, k % 6, SQUARES);
        shuffle(&mesh, &r);
        assert_int_equal(roberts_scene_build(&mesh, &only_solids, &scene, &error), ROBERTS_NOT_CLOSED);
        assert_non_null(strstr(error.message, "is not closed: edge "));
        roberts_mesh_free(&mesh);
    }
}

/* ---- large solids, long faces ---------------------------------------------------------------------------------- */

/* A double pyramid over a regular n-gon: two vertices with n edges each, numbered first, so that every list is long. */
static void add_double_pyramid(roberts_mesh *mesh, uint32_t n)
{
    uint32_t first = (uint32_t)mesh->vertex_count;
    add_vertex(mesh, 0, 0, 1);
    add_vertex(mesh, 0, 0, -1);
    for (uint32_t i = 0; i < n; i++)
        add_vertex(mesh, cos(2 * 3.14159265358979323846 * i / n), sin(2 * 3.14159265358979323846 * i / n), 0);
    for (uint32_t i = 0; i < n; i++) {
        uint32_t a = first + 2 + i, b = first + 2 + (i + 1) % n;
        add_face(mesh, (uint32_t[]){first, a, b}, 3);
        add_face(mesh, (uint32_t[]){first + 1, b, a}, 3);
    }
}

static void a_vertex_may_have_many_edges(void **state)
{
    roberts_mesh mesh = {0};
    (void)state;
    add_double_pyramid(&mesh, 1500);
    roberts_scene *scene = accept("double pyramid", &mesh, 1e-14);
    assert_int_equal(scene->edge_count, 4500);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
}

static void a_face_may_have_many_corners(void **state)
{
    enum { N = 1500 };
    roberts_mesh mesh = {0};
    uint32_t *corner = calloc(N, sizeof *corner);
    (void)state;
    add_vertex(&mesh, 0, 0, 1);
    for (uint32_t i = 0; i < N; i++)
        corner[i] =
            add_vertex(&mesh, cos(2 * 3.14159265358979323846 * i / N), sin(2 * 3.14159265358979323846 * i / N), 0);
    add_face(&mesh, corner, N);
    for (uint32_t i = 0; i < N; i++)
        add_face(&mesh, (uint32_t[]){0, corner[i], corner[(i + 1) % N]}, 3);
    roberts_scene *scene = accept("pyramid", &mesh, 1e-14);
    assert_true(fabs(scene_width(scene, 0) - 3.14159265358979323846 / 2) < 0.01); /* area pi over chord 2 */
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
    free(corner);
}

/* A ball of `rows` rows of quadrilaterals with triangles at the poles, squeezed to `height`; every coordinate rounded
 * to a multiple of 1 / digits, if that is not 0. */
static void add_ball(roberts_mesh *mesh, uint32_t rows, double height, double digits)
{
    uint32_t columns = 2 * rows, first = (uint32_t)mesh->vertex_count;
    add_vertex(mesh, 0, 0, height);
    add_vertex(mesh, 0, 0, -height);
    for (uint32_t i = 1; i < rows; i++)
        for (uint32_t k = 0; k < columns; k++) {
            double theta = 3.14159265358979323846 * i / rows, phi = 3.14159265358979323846 * k / rows;
            roberts_vec3 p = {sin(theta) * cos(phi), sin(theta) * sin(phi), height * cos(theta)};
            if (digits != 0)
                p = (roberts_vec3){round(p.x * digits) / digits, round(p.y * digits) / digits,
                                   round(p.z * digits) / digits};
            add_vertex(mesh, p.x, p.y, p.z);
        }
    for (uint32_t i = 0; i < rows; i++)
        for (uint32_t k = 0; k < columns; k++) {
            uint32_t next = (k + 1) % columns, here = first + 2 + (i - 1) * columns, below = first + 2 + i * columns;
            if (i == 0)
                add_face(mesh, (uint32_t[]){first, below + k, below + next}, 3);
            else if (i == rows - 1)
                add_face(mesh, (uint32_t[]){first + 1, here + next, here + k}, 3);
            else
                add_face(mesh, (uint32_t[]){here + k, below + k, below + next, here + next}, 4);
        }
}

static void large_solids_are_checked(void **state)
{
    static const struct {
        const char *name;
        double height, digits, dent, far;
        roberts_status status;
        const char *says;
    } cases[] = {
        {"ball", 1, 0, 0, 0, ROBERTS_OK, ""},
        {"ball to six digits", 1, 1e6, 0, 0, ROBERTS_OK, ""},
        {"ball to six digits, far from the origin", 1, 1e4, 0, 90, ROBERTS_OK, ""},
        {"a dent far from the origin, in full digits", 1, 0, 0.02, 90, ROBERTS_NOT_CONVEX, "solid 0 is not convex: "},
        {"lens", 1e-4, 0, 0, 0, ROBERTS_OK, ""},
        {"disc too thin", 1e-10, 0, 0, 0, ROBERTS_FLAT, "solid 0 is flat: "},
        {"one vertex pushed in a little, within the tolerance", 1, 0, 1e-6, 0, ROBERTS_OK, ""},
        {"the pole pushed in", 1, 0, 0.1, 0, ROBERTS_NOT_CONVEX, "solid 0 is not convex: vertex "},
        {"the pole pushed through", 1, 0, 2.5, 0, ROBERTS_NOT_CONVEX, "solid 0 is not convex: vertex "},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        roberts_mesh mesh = {0};
        roberts_scene *scene;
        roberts_error error = {0};
        add_ball(&mesh, 40, cases[i].height, cases[i].digits);
        mesh.vertex[0].z -= cases[i].dent;
        for (size_t v = 0; v < mesh.vertex_count; v++)
            mesh.vertex[v].x += cases[i].far;
        roberts_status status = roberts_scene_build(&mesh, &only_solids, &scene, &error);
        if (status != cases[i].status || strncmp(error.message, cases[i].says, strlen(cases[i].says)) != 0)
            fail_msg("%s: status %d, %s", cases[i].name, status, error.message);
        if (scene)
            check_scene(scene, cases[i].digits != 0 || cases[i].dent != 0 ? 2e-3 : 1e-14);
        roberts_scene_free(scene);
        roberts_mesh_free(&mesh);
    }
}

/* A prism over a T, in whole numbers, far away: as on a map. */
static void a_dent_far_away_is_a_dent(void **state)
{
    static const int outline[8][2] = {{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 3}, {1, 3}, {1, 1}, {0, 1}};
    static const double far[] = {0, 1e4, 1e5, 500000, 4649776, 4649776.25};
    (void)state;
    for (size_t i = 0; i < sizeof far / sizeof *far; i++) {
        roberts_mesh mesh = {0};
        roberts_scene *scene;
        roberts_error error = {0};
        uint32_t up[8];
        for (uint32_t k = 0; k < 16; k++) {
            uint32_t v = add_vertex(&mesh, far[i] + outline[k % 8][0], far[i] + outline[k % 8][1], k / 8);
            assert_int_equal(v, k);
        }
        for (uint32_t k = 0; k < 8; k++) {
            up[k] = 8 + k;
            add_face(&mesh, (uint32_t[]){k, (k + 1) % 8, 8 + (k + 1) % 8, 8 + k}, 4);
        }
        add_face(&mesh, (uint32_t[]){7, 6, 5, 4, 3, 2, 1, 0}, 8);
        add_face(&mesh, up, 8);
        assert_int_equal(roberts_scene_build(&mesh, &only_solids, &scene, &error), ROBERTS_NOT_CONVEX);
        roberts_mesh_free(&mesh);
    }
}

/* A plank along y, in `parts` of triangles, with a rebate along one edge. Its profile has six corners. */
static void add_plank(roberts_mesh *mesh, const double size[3], const double rebate[2], roberts_vec3 far,
                      uint32_t parts)
{
    static const uint32_t end[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}};
    const double w = size[0], h = size[2], a = rebate[0], b = rebate[1];
    const double profile[6][2] = {{0, 0}, {w, 0}, {w, h - b}, {w - a, h - b}, {w - a, h}, {0, h}};
    for (uint32_t i = 0; i <= parts; i++)
        for (int k = 0; k < 6; k++)
            add_vertex(mesh, far.x + profile[k][0], far.y + size[1] * i / parts, far.z + profile[k][1]);
    for (uint32_t i = 0; i < parts; i++)
        for (uint32_t k = 0; k < 6; k++) {
            const uint32_t p = 6 * i + k, q = 6 * i + (k + 1) % 6;
            add_face(mesh, (uint32_t[]){p, q, q + 6}, 3);
            add_face(mesh, (uint32_t[]){p, q + 6, p + 6}, 3);
        }
    for (int k = 0; k < 4; k++) {
        add_face(mesh, end[k], 3);
        add_face(mesh, (uint32_t[]){6 * parts + end[k][0], 6 * parts + end[k][1], 6 * parts + end[k][2]}, 3);
    }
}

/* Its narrow faces may lean, which must not excuse the rebate beside them. */
static void a_rebate_along_a_plank_is_a_dent(void **state)
{
    static const struct {
        double size[3], rebate[2];
        roberts_vec3 far;
        bool convex;
    } cases[] = {
        {{100, 6000, 50}, {15, 20}, {0, 0, 0}, false},      {{100, 6000, 50}, {3, 3}, {0, 0, 0}, false},
        {{100, 1000, 50}, {0.5, 0.5}, {0, 0, 0}, false},    {{100, 1000, 50}, {0.001, 0.001}, {0, 0, 0}, true},
        {{40, 100, 6}, {8, 3}, {345678, 123456, 0}, false}, {{8, 12, 4}, {3, 2}, {500000, 5400000, 0}, false},
        {{2, 2, 1}, {1, 0.5}, {2097152, 0, 0}, false},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (uint32_t parts = 1; parts <= 50; parts += 49) { /* a small solid, and one with a tree */
            roberts_mesh mesh = {0};
            roberts_scene *scene;
            roberts_error error = {0};
            add_plank(&mesh, cases[i].size, cases[i].rebate, cases[i].far, parts);
            roberts_status status = roberts_scene_build(&mesh, &only_solids, &scene, &error);
            if (status != (cases[i].convex ? ROBERTS_OK : ROBERTS_NOT_CONVEX))
                fail_msg("case %zu, %u parts: status %d, %s", i, parts, status, error.message);
            roberts_scene_free(scene);
            roberts_mesh_free(&mesh);
        }
}

/* A shallow dish: each edge bends inward by far less than any noise, the whole of it by much more than the tolerance.
 * Under it the half of a ball, so that nothing else is wrong. The bottom of the dish lies `depth` below the rim. */
static void a_shallow_dish_is_not_convex(void **state)
{
    static const double depth[] = {1e-7, 0.01, 0.1};
    (void)state;
    for (size_t i = 0; i < sizeof depth / sizeof *depth; i++)
        for (int noisy = 0; noisy < 2; noisy++) {
            roberts_mesh mesh = {0};
            roberts_scene *scene;
            roberts_error error = {0};
            rng r = {17};
            add_ball(&mesh, 60, 1, 0);
            for (size_t v = 0; v < mesh.vertex_count; v++) {
                roberts_vec3 *p = &mesh.vertex[v];
                double radius = p->x * p->x + p->y * p->y;
                if (p->z > 0)
                    p->z = depth[i] * (radius - 1);
                if (noisy && p->z != 0)
                    p->z += rng_between(&r, -1e-9, 1e-9);
            }
            roberts_status status = roberts_scene_build(&mesh, &only_solids, &scene, &error);
            if (status != (depth[i] < 1e-5 ? ROBERTS_OK : ROBERTS_NOT_CONVEX))
                fail_msg("depth %g%s: status %d, %s", depth[i], noisy ? ", noisy" : "", status, error.message);
            roberts_scene_free(scene);
            roberts_mesh_free(&mesh);
        }
}

/* ---- models of others ------------------------------------------------------------------------------------------ */

static const struct {
    const char *file;
    roberts_status status;
    uint32_t solids;
    const char *says; /* part of the message */
} models[] = {
    {"antiprism_dod_edges_verts_coloured.off", ROBERTS_OK, 1, NULL},
    {"antiprism_geo_ico_50.off", ROBERTS_OK, 1, NULL},
    {"antiprism_goldberg_7_5.off", ROBERTS_OK, 1, NULL},
    {"antiprism_j37_pseudorhombicuboctahedron.off", ROBERTS_OK, 1, NULL},
    {"antiprism_leonardo_dod.off", ROBERTS_NOT_CLOSED, 0, "belongs to 1 face instead of 2 (70 such edges in all)"},
    {"antiprism_miller_13.off", ROBERTS_NOT_CONVEX, 0, "solid 0 is not convex: vertex "},
    {"antiprism_pri60.off", ROBERTS_OK, 1, NULL},
    {"antiprism_skilling.off", ROBERTS_NOT_CLOSED, 0, "belongs to 4 faces instead of 2 (120 such edges in all)"},
    {"antiprism_szilassi.off", ROBERTS_NOT_CONVEX, 0, "face 0 of solid 0 is not a convex polygon: vertex 3 lies "},
    {"antiprism_u28_truncated_icosidodecahedron.off", ROBERTS_OK, 1, NULL},
    {"antiprism_u29d_pentagonal_hexecontahedron.off", ROBERTS_OK, 1, NULL},
    {"antiprism_u52_great_stellated_dodecahedron.off", ROBERTS_NOT_CONVEX, 0,
     "face 0 of solid 0 is not a convex polygon: it crosses itself"},
    {"antiprism_uc5_5_tetrahedra.off", ROBERTS_OK, 5, NULL},
    {"antiprism_uc9_5_cubes.off", ROBERTS_OK, 5, NULL},
    {"antiprism_unitile_11.off", ROBERTS_NOT_CLOSED, 0, "belongs to 1 face instead of 2"},
    {"cgal_degtri_nullface_bis.off", ROBERTS_NOT_CLOSED, 0, "belongs to 1 face instead of 2"},
    {"cgal_refined_elephant.off", ROBERTS_NOT_CONVEX, 0, "solid 0 is not convex: vertex "},
    {"francesco_truncated_cuboctahedron.off", ROBERTS_OK, 1, NULL},
    {"geomview_abstr.off", ROBERTS_OK, 1, NULL},
    {"geomview_trapezoid.4d.off", ROBERTS_OK, 1, NULL},
    {"geomview_tref.off", ROBERTS_NOT_CLOSED, 0, "belongs to 1 face instead of 2 (16 such edges in all)"},
    {"geomview_vertcube.off", ROBERTS_OK, 1, NULL},
    {"libigl_camelhead.off", ROBERTS_NOT_CLOSED, 0, "belongs to 1 face instead of 2 (56 such edges in all)"},
    {"libigl_inspired_mesh_quads_Smooth.off", ROBERTS_NOT_CLOSED, 0, "belongs to 1 face instead of 2"},
    {"openmesh_joint_NOFF.off", ROBERTS_NOT_CONVEX, 0, "solid 0 is not convex: vertex "},
    {"openscad_colors.off", ROBERTS_OK, 3, NULL},
    {"openscad_far-out-ring.off", ROBERTS_NOT_CONVEX, 0, "solid 0 is not convex: vertex "},
    {"openscad_\xe2\x98\xa0-3D.off", ROBERTS_OK, 1, NULL},
    {"qhull_sphere30000_Qt.off", ROBERTS_OK, 1, NULL},
    {"qhull_sphere300_o_raw.off", ROBERTS_OK, 1, NULL},
    {"ricaun_banana.off", ROBERTS_NOT_CONVEX, 0, "solid 0 is not convex: vertex "},
    {"ricaun_socket.off", ROBERTS_NOT_CONVEX, 0, "solid 0 is not convex: vertex "},
    {"ricaun_teapot.off", ROBERTS_NOT_CONVEX, 0, "solid 0 is not convex: vertex "},
    {"rjames_Th - mounted prisms.off", ROBERTS_NOT_CONVEX, 0, "solid 0 is not convex: vertex "},
    {"rjames_bicapped_4fold_prism.off", ROBERTS_OK, 1, NULL},
    {"rjames_scal_6_bipyr.off", ROBERTS_OK, 1, NULL},
    {"rjames_snub_box.off", ROBERTS_OK, 1, NULL},
    {"trimesh_comments.off", ROBERTS_OK, 1, NULL},
    {"trimesh_whitespace.off", ROBERTS_OK, 1, NULL},
};

static void models_of_others(void **state)
{
    char path[1024];
    size_t seen = 0;
    (void)state;
    for (size_t i = 0; i < sizeof models / sizeof *models; i++) {
        roberts_mesh mesh = {0};
        roberts_scene *scene;
        roberts_error error = {0};
        snprintf(path, sizeof path, "%s/models/%s", shared_folder(), models[i].file);
        roberts_status status = roberts_mesh_read_file(&mesh, path, NULL, &error);
        if (status == ROBERTS_IO)
            continue;
        seen++;
        if (status == ROBERTS_OK)
            status = roberts_scene_build(&mesh, &only_solids, &scene, &error);
        if (status != models[i].status || (models[i].says && !strstr(error.message, models[i].says)))
            fail_msg("%s: status %d, %s", models[i].file, status, error.message);
        if (status == ROBERTS_OK) {
            assert_int_equal(scene->solid_count, models[i].solids);
            if (scene->vertex_count < 3000)
                check_scene(scene, 1e-5);
            roberts_scene_free(scene);
        } else {
            assert_string_equal(error.file, path);
        }
        roberts_mesh_free(&mesh);
    }
    if (!seen) {
        SKIP_BECAUSE("no models in %s/models", shared_folder());
    }
    assert_int_equal(seen, sizeof models / sizeof *models);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sound_solids_are_accepted),
        cmocka_unit_test(others_are_refused_and_told_why),
        cmocka_unit_test(names_the_file_without_solids),
        cmocka_unit_test(the_input_that_holds_the_face_is_named),
        cmocka_unit_test(the_tolerance_decides),
        cmocka_unit_test(repeated_corners_are_counted),
        cmocka_unit_test(colours_follow_their_vertices_and_faces),
        cmocka_unit_test(planes_are_exact),
        cmocka_unit_test(scale_changes_nothing),
        cmocka_unit_test(sizes_and_places),
        cmocka_unit_test(numbers_that_are_none_are_refused),
        cmocka_unit_test(six_digits_are_enough),
        cmocka_unit_test(touching_cubes_of_loose_faces_come_apart),
        cmocka_unit_test(blocks_come_apart),
        cmocka_unit_test(closed_components_are_not_welded),
        cmocka_unit_test(missing_faces_are_noticed),
        cmocka_unit_test(a_vertex_may_have_many_edges),
        cmocka_unit_test(a_face_may_have_many_corners),
        cmocka_unit_test(large_solids_are_checked),
        cmocka_unit_test(a_dent_far_away_is_a_dent),
        cmocka_unit_test(a_rebate_along_a_plank_is_a_dent),
        cmocka_unit_test(a_shallow_dish_is_not_convex),
        cmocka_unit_test(models_of_others),
    };
    return cmocka_run_group_tests_name("scene", tests, NULL, NULL);
}
