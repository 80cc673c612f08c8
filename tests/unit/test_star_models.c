/* The star polyhedra and other bodies that are not convex in models/, against known properties: counts, regular faces,
 * Euler characteristic, volume, borders. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "make_mesh.h"
#include "mesh_corners.h"
#include "testing.h"

/* How much lengths may differ and count as equal, as a part of either: coordinates are rounded to 1e-16, and some are
 * sums of a few terms. */
static const double ROUNDING = 1e-12;

static const double PI = 3.14159265358979323846;

static roberts_mesh read_model(const char *folder, const char *name)
{
    char path[256];
    snprintf(path, sizeof path, "models/%s/%s.off", folder, name);
    return mesh_of_file(path);
}

/* ---- edges ------------------------------------------------------------------------------------------------------ */

/* Edges of a mesh, those of one face, those of more than two, and slits, which are no edges: sides that their own face
 * runs back along. Edges that both of their faces run along the same way are counted, too. */
typedef struct edge_counts {
    size_t edges, borders, crowded, slits, same_way;
} edge_counts;

static bool runs_back(const roberts_mesh *m, size_t f, uint32_t u, uint32_t v)
{
    for (size_t i = 0; i < corner_count(m, f); i++)
        if (corner(m, f, i) == v && corner(m, f, i + 1) == u)
            return true;
    return false;
}

static edge_counts count_edges(const roberts_mesh *m)
{
    edge_counts counts = {0};
    size_t n = m->vertex_count;
    uint8_t *uses = calloc(n * n, 1); /* of the side from u to v: uses[u n + v] */
    assert_non_null(uses);
    for (size_t f = 0; f < m->face_count; f++)
        for (size_t i = 0; i < corner_count(m, f); i++) {
            uint32_t u = corner(m, f, i), v = corner(m, f, i + 1);
            if (!runs_back(m, f, u, v))
                uses[u * n + v]++;
            else if (u < v)
                counts.slits++;
        }
    for (size_t u = 0; u < n; u++)
        for (size_t v = 0; v < u; v++) {
            int one = uses[u * n + v], other = uses[v * n + u];
            counts.edges += one + other > 0;
            counts.borders += one + other == 1;
            counts.crowded += one + other > 2;
            counts.same_way += one == 2 || other == 2;
        }
    free(uses);
    return counts;
}

/* How many rings the edges of one face form; each vertex on them must have two edges. */
static size_t border_rings(const roberts_mesh *m)
{
    size_t n = m->vertex_count, rings = 0, left = 0;
    uint32_t(*beside)[2] = calloc(n, sizeof *beside);
    uint8_t *count = calloc(n, 1), *uses = calloc(n * n, 1);
    assert_true(beside && count && uses);
    for (size_t f = 0; f < m->face_count; f++)
        for (size_t i = 0; i < corner_count(m, f); i++)
            uses[corner(m, f, i) * n + corner(m, f, i + 1)]++;
    for (uint32_t u = 0; u < n; u++)
        for (uint32_t v = 0; v < n; v++)
            if (uses[u * n + v] + uses[v * n + u] == 1) {
                assert_true(count[u] < 2);
                beside[u][count[u]++] = v;
                left++;
            }
    for (uint32_t start = 0; left > 0 && start < n; start++) {
        uint32_t at = start, from = start;
        if (count[start] != 2)
            continue;
        do {
            uint32_t next = beside[at][0] == from ? beside[at][1] : beside[at][0];
            from = at;
            at = next;
            count[from] = 0;
            left -= 2;
        } while (at != start);
        rings++;
    }
    free(beside);
    free(count);
    free(uses);
    return rings;
}

/* ---- star polyhedra --------------------------------------------------------------------------------------------- */

/* Faces {corners/turns}, and how many there are of each. */
typedef struct face_kind {
    size_t faces, corners, turns;
} face_kind;

/* Counts as in M. J. Wenninger, "Polyhedron Models", 1971. */
static const struct {
    const char *name;
    size_t vertices, edges;
    int euler;
    face_kind kinds[3];
} known_stars[] = {
    {"small-stellated-dodecahedron", 12, 30, -6, {{12, 5, 2}}},
    {"great-dodecahedron", 12, 30, -6, {{12, 5, 1}}},
    {"great-stellated-dodecahedron", 20, 30, 2, {{12, 5, 2}}},
    {"great-icosahedron", 12, 30, 2, {{20, 3, 1}}},
    {"tetrahemihexahedron", 6, 12, 1, {{4, 3, 1}, {3, 4, 1}}},
    {"octahemioctahedron", 12, 24, 0, {{8, 3, 1}, {4, 6, 1}}},
    {"cubohemioctahedron", 12, 24, -2, {{6, 4, 1}, {4, 6, 1}}},
    {"small-ditrigonal-icosidodecahedron", 20, 60, -8, {{20, 3, 1}, {12, 5, 2}}},
    {"ditrigonal-dodecadodecahedron", 20, 60, -16, {{12, 5, 1}, {12, 5, 2}}},
    {"great-ditrigonal-icosidodecahedron", 20, 60, -8, {{20, 3, 1}, {12, 5, 1}}},
    {"dodecadodecahedron", 30, 60, -6, {{12, 5, 1}, {12, 5, 2}}},
    {"great-icosidodecahedron", 30, 60, 2, {{20, 3, 1}, {12, 5, 2}}},
    {"small-icosihemidodecahedron", 30, 60, -4, {{20, 3, 1}, {6, 10, 1}}},
    {"great-dodecahemicosahedron", 30, 60, -8, {{12, 5, 1}, {10, 6, 1}}},
    {"great-dodecahemidodecahedron", 30, 60, -12, {{12, 5, 2}, {6, 10, 3}}},
    {"small-dodecicosidodecahedron", 60, 120, -16, {{20, 3, 1}, {12, 5, 1}, {12, 10, 1}}},
    {"small-stellated-truncated-dodecahedron", 60, 90, -6, {{12, 5, 1}, {12, 10, 3}}},
    {"pentagrammic-prism", 10, 15, 2, {{2, 5, 2}, {5, 4, 1}}},
    {"pentagrammic-antiprism", 10, 20, 2, {{2, 5, 2}, {10, 3, 1}}},
    {"pentagrammic-crossed-antiprism", 10, 20, 2, {{2, 5, 2}, {10, 3, 1}}},
};

/* Is the face {corners/turns}? From the diagonal over one corner, 2 cos(pi turns / corners) sides long. */
static bool is_kind(const roberts_mesh *m, size_t f, const face_kind *k)
{
    double side = distance(point(m, f, 0), point(m, f, 1)), diagonal = distance(point(m, f, 0), point(m, f, 2));
    double wanted = 2 * cos(PI * (double)k->turns / (double)k->corners);
    return corner_count(m, f) == k->corners && fabs(diagonal / side - wanted) < ROUNDING;
}

/* A polygon with equal sides and diagonals, in one plane, its corners in a circle. */
static void check_regular(const char *name, const roberts_mesh *m, size_t f)
{
    size_t n = corner_count(m, f);
    double side = distance(point(m, f, 0), point(m, f, 1)), diagonal = distance(point(m, f, 0), point(m, f, 2));
    for (size_t i = 0; i < n; i++) {
        if (fabs(distance(point(m, f, i), point(m, f, i + 1)) - side) > ROUNDING * side ||
            fabs(distance(point(m, f, i), point(m, f, i + 2)) - diagonal) > ROUNDING * side)
            fail_msg("%s: face %zu is not regular at corner %zu", name, f, i);
        if (fabs(vec3_dot(normal(m, f), vec3_sub(point(m, f, i), point(m, f, 0)))) > ROUNDING * side)
            fail_msg("%s: face %zu is not in one plane", name, f);
    }
}

/* Round each vertex of a uniform polyhedron the same faces meet; all edges have one length, all vertices one distance
 * from the centre. */
static void check_alike(const char *name, const roberts_mesh *m)
{
    double side = distance(point(m, 0, 0), point(m, 0, 1)), radius = vec3_length(m->vertex[0]);
    for (size_t f = 0; f < m->face_count; f++)
        if (fabs(distance(point(m, f, 0), point(m, f, 1)) - side) > ROUNDING * side)
            fail_msg("%s: face %zu has longer or shorter sides", name, f);
    for (uint32_t v = 0; v < m->vertex_count; v++)
        if (fabs(vec3_length(m->vertex[v]) - radius) > ROUNDING * radius || surroundings(m, v) != surroundings(m, 0))
            fail_msg("%s: vertex %u is not like vertex 0", name, v);
}

static void stars_are_what_they_are_called(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof known_stars / sizeof *known_stars; i++) {
        const char *name = known_stars[i].name;
        size_t faces = 0;
        roberts_mesh mesh = read_model("star", name);
        edge_counts counts = count_edges(&mesh);
        for (int k = 0; k < 3; k++) {
            const face_kind *kind = &known_stars[i].kinds[k];
            size_t found = 0;
            for (size_t f = 0; f < mesh.face_count && kind->faces; f++)
                found += is_kind(&mesh, f, kind);
            if (found != kind->faces)
                fail_msg("%s: %zu faces {%zu/%zu}", name, found, kind->corners, kind->turns);
            faces += found;
        }
        for (size_t f = 0; f < mesh.face_count; f++)
            check_regular(name, &mesh, f);
        check_alike(name, &mesh);
        if (mesh.vertex_count != known_stars[i].vertices || counts.edges != known_stars[i].edges ||
            counts.borders + counts.crowded > 0 || mesh.face_count != faces ||
            (int)(mesh.vertex_count + faces) - (int)counts.edges != known_stars[i].euler)
            fail_msg("%s: %zu vertices, %zu edges, %zu faces", name, (size_t)mesh.vertex_count, counts.edges, faces);
        roberts_mesh_free(&mesh);
    }
}

/* ---- other shapes ----------------------------------------------------------------------------------------------- */

/* The volume within a closed body: > 0 where its faces run counter-clockwise seen from outside. */
static double volume(const roberts_mesh *m)
{
    double sum = 0;
    for (size_t f = 0; f < m->face_count; f++)
        for (size_t i = 1; i + 1 < corner_count(m, f); i++)
            sum += vec3_dot(point(m, f, 0), vec3_cross(point(m, f, i), point(m, f, i + 1)));
    return sum / 6;
}

/* Area of the regular polygon of n corners and circumradius 1. */
static double polygon_area(int n)
{
    return n / 2.0 * sin(2 * PI / n);
}

/* Base and upright, less the eye and the holes. The base lies under the upright, too. */
static double bracket_volume(void)
{
    double upright = 12 * 9 + polygon_area(24) / 2 * 6 * 6, eye = polygon_area(24) * 3 * 3;
    double rim = polygon_area(24) * (4.25 * 4.25 - 3 * 3), hole = polygon_area(16) * 1.25 * 1.25;
    return 2 * (upright - eye) + rim + 2 * (12 * 8 - 2 * hole);
}

static void shapes_are_what_they_are_called(void **state)
{
    const double around = polygon_area(24) / PI; /* of a circle's area, in 24 pieces */
    const double torus = around * 2 * PI * 3 * polygon_area(12) * 1.25 * 1.25, bracket = bracket_volume();
    const double head = polygon_area(6) * 5 * 5 * 3, shaft = polygon_area(24) * 9;
    const struct {
        const char *name;
        int euler; /* vertices - edges + faces, a slit counted as an edge */
        size_t borders, rings, slits;
        double least, most; /* volume; both 0: an open sheet */
    } cases[] = {
        {"csaszar", 0, 0, 0, 0, 1, 12 * 6 * 15 / 3.0}, /* less than a pyramid round it */
        {"szilassi", 0, 0, 0, 0, 1, 480.0 * 504 * 480},
        {"torus", 0, 0, 0, 0, torus * (1 - ROUNDING), torus * (1 + ROUNDING)},
        {"goblet", 2, 0, 0, 0, 1, around * PI * 3 * 3 * 10.5},
        {"screw", 2, 0, 0, 1, head + 2 * 2 * shaft, head + 2.75 * 2.75 * shaft},
        {"bracket", 2 - 2 * 3, 0, 0, 7, bracket * (1 - ROUNDING), bracket * (1 + ROUNDING)},
        {"terrain", 1, 4 * 32, 1, 0, 0, 0},
        {"moebius-strip", 0, 2 * 48, 1, 0, 0, 0},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *name = cases[i].name;
        roberts_mesh mesh = read_model("shapes", name);
        edge_counts counts = count_edges(&mesh);
        int euler = (int)mesh.vertex_count - (int)(counts.edges + counts.slits) + (int)mesh.face_count;
        if (euler != cases[i].euler || counts.borders != cases[i].borders || counts.slits != cases[i].slits)
            fail_msg("%s: Euler characteristic %d, %zu borders, %zu slits", name, euler, counts.borders, counts.slits);
        if (border_rings(&mesh) != cases[i].rings)
            fail_msg("%s: %zu rings of borders", name, border_rings(&mesh));
        if (cases[i].most > 0 && !(volume(&mesh) >= cases[i].least && volume(&mesh) <= cases[i].most))
            fail_msg("%s: volume %.17g", name, volume(&mesh));
        if (counts.crowded > 0 || (counts.same_way > 0) != !strcmp(name, "moebius-strip"))
            fail_msg("%s: %zu edges in three faces, %zu with mixed winding", name, counts.crowded, counts.same_way);
        roberts_mesh_free(&mesh);
    }
}

/* Any two of the seven corners of the one share an edge, and so do any two of the seven faces of the other. */
static void toroids_of_seven_are_complete(void **state)
{
    (void)state;
    roberts_mesh csaszar = read_model("shapes", "csaszar"), szilassi = read_model("shapes", "szilassi");
    size_t pairs = 0;
    assert_int_equal(csaszar.vertex_count, 7);
    assert_int_equal(count_edges(&csaszar).edges, 7 * 6 / 2);
    assert_int_equal(szilassi.face_count, 7);
    for (size_t f = 0; f < 7; f++)
        for (size_t g = 0; g < f; g++) {
            bool share = false;
            for (size_t i = 0; i < corner_count(&szilassi, f); i++)
                share = share || runs_back(&szilassi, g, corner(&szilassi, f, i), corner(&szilassi, f, i + 1));
            pairs += share;
        }
    assert_int_equal(pairs, 7 * 6 / 2);
    roberts_mesh_free(&csaszar);
    roberts_mesh_free(&szilassi);
}

/* > 0 where d lies below the plane of a, b, c, which turn counter-clockwise seen from above; exact for small integers.
 */
static double below(roberts_vec3 a, roberts_vec3 b, roberts_vec3 c, roberts_vec3 d)
{
    return -vec3_dot(vec3_cross(vec3_sub(b, a), vec3_sub(c, a)), vec3_sub(d, a));
}

/* All corners of a face lie in one plane, exactly. */
static void szilassi_is_planar(void **state)
{
    (void)state;
    roberts_mesh m = read_model("shapes", "szilassi");
    for (size_t f = 0; f < m.face_count; f++)
        for (size_t i = 3; i < corner_count(&m, f); i++)
            assert_true(below(point(&m, f, 0), point(&m, f, 1), point(&m, f, 2), point(&m, f, i)) == 0);
    roberts_mesh_free(&m);
}

/* Does the segment pq go through the inside of triangle f? */
static bool pierces(const roberts_mesh *m, size_t f, roberts_vec3 p, roberts_vec3 q)
{
    roberts_vec3 a = point(m, f, 0), b = point(m, f, 1), c = point(m, f, 2);
    double ab = below(p, q, a, b), bc = below(p, q, b, c), ca = below(p, q, c, a);
    bool apart = below(a, b, c, p) * below(a, b, c, q) < 0;
    return apart && ((ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0));
}

static void csaszar_does_not_cross_itself(void **state)
{
    (void)state;
    roberts_mesh m = read_model("shapes", "csaszar");
    for (size_t f = 0; f < m.face_count; f++)
        for (uint32_t u = 0; u < m.vertex_count; u++)
            for (uint32_t v = 0; v < u; v++)
                assert_false(pierces(&m, f, m.vertex[u], m.vertex[v]));
    roberts_mesh_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stars_are_what_they_are_called), cmocka_unit_test(shapes_are_what_they_are_called),
        cmocka_unit_test(toroids_of_seven_are_complete),  cmocka_unit_test(szilassi_is_planar),
        cmocka_unit_test(csaszar_does_not_cross_itself),
    };
    return cmocka_run_group_tests_name("star models", tests, NULL, NULL);
}
