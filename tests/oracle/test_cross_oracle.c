/* test_cross_oracle.c - intersection lines: the oracle against cases worked out by hand and against triangles
 * crossed in another way; the judge against tables that are wrong on purpose. test_mesh_oracle.c compares the
 * library with them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "oracle/cross_judge.h"
#include "oracle/mesh_families.h"
#include "oracle/shapes.h"
#include "make_mesh.h"
#include "testing.h"
#include "whole.h"

/* ---- by hand ---- */

typedef struct hand_line {
    uint32_t f0, f1;
    double a[3], b[3];
    size_t count;
    oracle_interval hidden[2];
} hand_line;

enum { HAND_LINES = 8 };

/* Scenes seen from +z. */
static const struct {
    const char *name, *off;
    bool even_odd;
    size_t count;
    hand_line line[HAND_LINES];
} hand_cases[] = {
    {"two squares that cross",
     "8 2 0\n0 0 0 4 0 0 4 4 0 0 4 0  1 2 -1 3 2 -1 3 2 1 1 2 1\n4 0 1 2 3\n4 4 5 6 7\n",
     false,
     1,
     {{0, 1, {1, 2, 0}, {3, 2, 0}, 0, {{0, 0}}}}},
    {"... one of them partly out of the other",
     "8 2 0\n0 0 0 4 0 0 4 4 0 0 4 0  3 2 -1 7 2 -1 7 2 1 3 2 1\n4 0 1 2 3\n4 4 5 6 7\n",
     false,
     1,
     {{0, 1, {3, 2, 0}, {4, 2, 0}, 0, {{0, 0}}}}},
    {"one stands on the other: touch, no line",
     "8 2 0\n0 0 0 4 0 0 4 4 0 0 4 0  1 2 0 3 2 0 3 2 1 1 2 1\n4 0 1 2 3\n4 4 5 6 7\n",
     false,
     0,
     {{0}}},
    {"a wall of two rows, cut at the floor: its own side is the line",
     "10 3 0\n0 0 0 4 0 0 4 4 0 0 4 0  1 2 0 3 2 0 3 2 1 1 2 1 1 2 -1 3 2 -1\n4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
     false,
     0,
     {{0}}},
    {"coplanar", "8 2 0\n0 0 0 4 0 0 4 4 0 0 4 0  1 1 0 5 1 0 5 5 0 1 5 0\n4 0 1 2 3\n4 4 5 6 7\n", false, 0, {{0}}},
    {"they share an edge", "6 2 0\n0 0 0 4 0 0 4 4 0 0 4 0 4 0 3 0 0 3\n4 0 1 2 3\n4 0 1 4 5\n", false, 0, {{0}}},
    {"they share a corner and cross from there on",
     "5 2 0\n0 0 0 4 -4 0 4 4 0 4 0 -2 4 0 2\n3 0 1 2\n3 0 3 4\n",
     false,
     1,
     {{0, 1, {0, 0, 0}, {4, 0, 0}, 0, {{0, 0}}}}},
    {"they share a corner and nothing else",
     "5 2 0\n0 0 0 4 -4 0 4 4 0 -4 0 -2 -4 0 2\n3 0 1 2\n3 0 3 4\n",
     false,
     0,
     {{0}}},
    {"an edge through a face exactly at a vertex",
     "6 2 0\n0 0 0 4 0 0 0 4 0 0 0 -1 0 0 1 4 4 0\n3 0 1 2\n3 3 4 5\n",
     false,
     1,
     {{0, 1, {0, 0, 0}, {2, 2, 0}, 0, {{0, 0}}}}},
    {"an edge that only touches a side",
     "6 2 0\n0 0 0 4 0 0 0 -4 0 2 0 -1 2 0 1 2 3 0\n3 0 1 2\n3 3 4 5\n",
     false,
     0,
     {{0}}},
    {"a comb: two lines of one pair",
     "12 2 0\n-1 -1 0 9 -1 0 9 1 0 -1 1 0  0 0 2 0 0 -2 2 0 -2 2 0 1 4 0 1 4 0 -2 6 0 -2 6 0 2\n4 0 1 2 3\n"
     "8 4 5 6 7 8 9 10 11\n",
     false,
     2,
     {{0, 1, {0, 0, 0}, {2, 0, 0}, 0, {{0, 0}}}, {0, 1, {4, 0, 0}, {6, 0, 0}, 0, {{0, 0}}}}},
    {"a tooth that ends in the plane parts nothing",
     "11 2 0\n-1 -1 0 9 -1 0 9 1 0 -1 1 0  0 0 2 0 0 -2 6 0 -2 6 0 2 4 0 2 3 0 0 2 0 2\n4 0 1 2 3\n"
     "7 4 5 6 7 8 9 10\n",
     false,
     1,
     {{0, 1, {0, 0, 0}, {6, 0, 0}, 0, {{0, 0}}}}},
    {"a side that runs in the plane parts the line",
     "12 2 0\n-1 -1 0 9 -1 0 9 1 0 -1 1 0  0 0 2 0 0 -2 6 0 -2 6 0 2 4 0 2 4 0 0 2 0 0 2 0 2\n4 0 1 2 3\n"
     "8 4 5 6 7 8 9 10 11\n",
     false,
     2,
     {{0, 1, {0, 0, 0}, {2, 0, 0}, 0, {{0, 0}}}, {0, 1, {4, 0, 0}, {6, 0, 0}, 0, {{0, 0}}}}},
    {"a face with a hole and a slit across it; the line does not end at the slit",
     "14 2 0\n0 0 0 8 0 0 8 8 0 0 8 0 2 2 0 2 6 0 6 6 0 6 2 0  -1 1 -1 9 1 -1 9 1 1 -1 1 1 0 0 9 0 0 9\n"
     "10 0 1 2 3 0 4 5 6 7 4\n4 8 9 10 11\n",
     false,
     1,
     {{0, 1, {0, 1, 0}, {8, 1, 0}, 0, {{0, 0}}}}},
    {"through the hole",
     "12 2 0\n0 0 0 8 0 0 8 8 0 0 8 0 2 2 0 2 6 0 6 6 0 6 2 0  -1 4 -1 9 4 -1 9 4 1 -1 4 1\n"
     "10 0 1 2 3 0 4 5 6 7 4\n4 8 9 10 11\n",
     false,
     2,
     {{0, 1, {0, 4, 0}, {2, 4, 0}, 0, {{0, 0}}}, {0, 1, {6, 4, 0}, {8, 4, 0}, 0, {{0, 0}}}}},
    {"a border that goes round twice: where it winds once more, a side bounds something, but the face goes on",
     "12 2 0\n0 0 0 8 0 0 8 8 0 0 8 0 2 2 0 6 2 0 6 6 0 2 6 0  -1 4 -1 9 4 -1 9 4 1 -1 4 1\n"
     "10 0 1 2 3 0 4 5 6 7 4\n4 8 9 10 11\n",
     false,
     1,
     {{0, 1, {0, 4, 0}, {8, 4, 0}, 0, {{0, 0}}}}},
    {"... by the odd rule",
     "12 2 0\n0 0 0 8 0 0 8 8 0 0 8 0 2 2 0 6 2 0 6 6 0 2 6 0  -1 4 -1 9 4 -1 9 4 1 -1 4 1\n"
     "10 0 1 2 3 0 4 5 6 7 4\n4 8 9 10 11\n",
     true,
     2,
     {{0, 1, {0, 4, 0}, {2, 4, 0}, 0, {{0, 0}}}, {0, 1, {6, 4, 0}, {8, 4, 0}, 0, {{0, 0}}}}},
    {"a bow-tie is pinched in the line and goes on behind",
     "8 2 0\n0 -2 0 4 2 0 4 -2 0 0 2 0  -1 0 -1 9 0 -1 9 0 1 -1 0 1\n4 0 1 2 3\n4 4 5 6 7\n",
     false,
     1,
     {{0, 1, {0, 0, 0}, {4, 0, 0}, 0, {{0, 0}}}}},
    {"three planes through a point: the first hides the lower half of the upright line",
     "12 3 0\n-2 -2 0 2 -2 0 2 2 0 -2 2 0  -2 0 -2 2 0 -2 2 0 2 -2 0 2  0 -2 -2 0 2 -2 0 2 2 0 -2 2\n"
     "4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n",
     false,
     3,
     {{0, 1, {-2, 0, 0}, {2, 0, 0}, 0, {{0, 0}}},
      {0, 2, {0, -2, 0}, {0, 2, 0}, 0, {{0, 0}}},
      {1, 2, {0, 0, -2}, {0, 0, 2}, 1, {{0, 0.5}}}}},
    {"many faces through one line: each pair has it",
     "12 3 0\n0 -2 -2 0 2 2 6 2 2 6 -2 -2  0 -2 2 0 2 -2 6 2 -2 6 -2 2  0 -2 0 0 2 0 6 2 0 6 -2 0\n"
     "4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n",
     false,
     3,
     {{0, 1, {0, 0, 0}, {6, 0, 0}, 0, {{0, 0}}},
      {0, 2, {0, 0, 0}, {6, 0, 0}, 0, {{0, 0}}},
      {1, 2, {0, 0, 0}, {6, 0, 0}, 0, {{0, 0}}}}},
    {"under a lid",
     "12 3 0\n0 0 0 4 0 0 4 4 0 0 4 0  0 2 -1 4 2 -1 4 2 1 0 2 1  1 0 5 2 0 5 2 4 5 1 4 5\n"
     "4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n",
     false,
     1,
     {{0, 1, {0, 2, 0}, {4, 2, 0}, 1, {{0.25, 0.5}}}}},
    {"a third face rises through the line: it hides one side of it",
     "12 3 0\n0 0 0 4 0 0 4 4 0 0 4 0  0 2 -1 4 2 -1 4 2 1 0 2 1  0 0 -1 4 0 3 4 4 3 0 4 -1\n"
     "4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n",
     false,
     3,
     {{0, 1, {0, 2, 0}, {4, 2, 0}, 1, {{0.25, 1}}},
      {0, 2, {1, 0, 0}, {1, 4, 0}, 0, {{0, 0}}},
      {1, 2, {0, 2, -1}, {2, 2, 1}, 1, {{0, 0.5}}}}},
    {"the same face twice counts once",
     "8 3 0\n0 0 0 4 0 0 4 4 0 0 4 0  1 2 -1 3 2 -1 3 2 1 1 2 1\n4 0 1 2 3\n4 4 5 6 7\n4 6 5 4 7\n",
     false,
     1,
     {{0, 1, {1, 2, 0}, {3, 2, 0}, 0, {{0, 0}}}}},
    {"faces are counted with those of two corners",
     "8 4 0\n0 0 0 4 0 0 4 4 0 0 4 0  1 2 -1 3 2 -1 3 2 1 1 2 1\n2 0 5\n4 0 1 2 3\n1 0\n4 4 5 6 7\n",
     false,
     1,
     {{1, 3, {1, 2, 0}, {3, 2, 0}, 0, {{0, 0}}}}},
    {"nearly coplanar",
     "6 2 0\n-100000 -100000 0 100000 -100000 0 0 100000 0 -90000 0 -1 90000 -1 1 90000 1 1\n3 0 1 2\n3 3 4 5\n",
     false,
     1,
     {{0, 1, {0, -0.5, 0}, {0, 0.5, 0}, 0, {{0, 0}}}}},
};

static double off(roberts_vec3 is, const double wanted[3])
{
    return fabs(is.x - wanted[0]) + fabs(is.y - wanted[1]) + fabs(is.z - wanted[2]);
}

static void check_end(const char *what, roberts_vec3 is, const double wanted[3])
{
    if (off(is, wanted) > 1e-14)
        fail_msg("%s: %.17g %.17g %.17g, not %.17g %.17g %.17g", what, is.x, is.y, is.z, wanted[0], wanted[1],
                 wanted[2]);
}

static void test_by_hand(void **state)
{
    const oracle_view top = {.z = 1};
    (void)state;
    for (size_t i = 0; i < sizeof hand_cases / sizeof hand_cases[0]; i++) {
        cross_truth truth;
        char text[1000];
        snprintf(text, sizeof text, "OFF\n%s", hand_cases[i].off);
        roberts_mesh mesh = mesh_of_text(text);
        if (!cross_truth_find(&mesh, &top, hand_cases[i].even_odd, &truth))
            fail_msg("%s: %s", hand_cases[i].name, truth.error);
        if (truth.line_count != hand_cases[i].count)
            fail_msg("%s: %zu lines, not %zu", hand_cases[i].name, truth.line_count, hand_cases[i].count);
        for (size_t k = 0; k < truth.line_count; k++) {
            const cross_line *l = &truth.line[k];
            const hand_line *wanted = &hand_cases[i].line[k];
            if (l->f0 != wanted->f0 || l->f1 != wanted->f1)
                fail_msg("%s: faces %u and %u", hand_cases[i].name, l->f0, l->f1);
            check_end(hand_cases[i].name, l->a, wanted->a);
            check_end(hand_cases[i].name, l->b, wanted->b);
            if (l->count != wanted->count)
                fail_msg("%s: line %zu: %zu hidden intervals", hand_cases[i].name, k, l->count);
            for (size_t m = 0; m < l->count; m++)
                if (fabs(truth.interval[l->first + m].t0 - wanted->hidden[m].t0) +
                        fabs(truth.interval[l->first + m].t1 - wanted->hidden[m].t1) >
                    1e-14)
                    fail_msg("%s: line %zu hidden from %.17g to %.17g", hand_cases[i].name, k,
                             truth.interval[l->first + m].t0, truth.interval[l->first + m].t1);
        }
        cross_truth_free(&truth);
        roberts_mesh_free(&mesh);
    }
}

/* ---- models whose lines are known by number ---- */

/* A cube with a corner in the middle of another: three faces of either meet three of the other, each face two. */
static void test_cube_in_cube(void **state)
{
    const oracle_view view = {.x = 3, .y = 2, .z = 5};
    roberts_mesh mesh = {0};
    cross_truth truth;
    double length = 0;
    (void)state;
    for (int cube = 0; cube < 2; cube++)
        mesh_box(&mesh, (roberts_vec3){cube, cube, cube}, (roberts_vec3){cube + 2, cube + 2, cube + 2});
    assert_true(cross_truth_find(&mesh, &view, false, &truth));
    assert_int_equal(truth.line_count, 6);
    for (size_t i = 0; i < truth.line_count; i++) {
        const cross_line *l = &truth.line[i];
        assert_true(l->f0 < 6 && l->f1 >= 6);
        length += fabs(l->b.x - l->a.x) + fabs(l->b.y - l->a.y) + fabs(l->b.z - l->a.z);
    }
    assert_float_equal(length, 6, 1e-15);
    cross_truth_free(&truth);
    roberts_mesh_free(&mesh);
}

/* Lines on edges that are left out, worked out by hand. */
static void test_on_edges(void **state)
{
#define FLOOR "0 0 0 4 0 0 4 4 0 0 4 0 "
    static const struct {
        const char *name, *text;
        size_t count;
        uint32_t f0, f1;
        double a[3], b[3];
    } cases[] = {
        {"a wall of two rows, cut at the floor",
         "OFF\n10 3 0\n" FLOOR "-1 2 0 3 2 0 3 2 1 -1 2 1 -1 2 -1 3 2 -1\n4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
         1,
         0,
         1,
         {0, 2, 0},
         {3, 2, 0}},
        {"a wall that is bent there: the edge is drawn",
         "OFF\n10 3 0\n" FLOOR "-1 2 0 3 2 0 3 2 1 -1 2 1 -1 1 -1 3 1 -1\n4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
         0,
         0,
         0,
         {0},
         {0}},
        {"a wall that begins at the floor: its border is drawn",
         "OFF\n8 2 0\n" FLOOR "-1 2 0 3 2 0 3 2 1 -1 2 1\n4 0 1 2 3\n4 4 5 6 7\n",
         0,
         0,
         0,
         {0},
         {0}},
        {"two rows in the floor's plane",
         "OFF\n10 3 0\n" FLOOR "-1 2 0 3 2 0 3 3 0 -1 3 0 -1 1 0 3 1 0\n4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
         0,
         0,
         0,
         {0},
         {0}},
        {"a floor of two tiles that end at the wall's flat edge",
         "OFF\n12 4 0\n0 0 0 4 0 0 4 2 0 0 2 0 4 4 0 0 4 0 -1 2 0 3 2 0 3 2 1 -1 2 1 -1 2 -1 3 2 -1\n"
         "4 0 1 2 3\n4 3 2 4 5\n4 6 7 8 9\n4 6 7 11 10\n",
         1,
         0,
         2,
         {0, 2, 0},
         {3, 2, 0}},
        {"a wall in one piece through these tiles",
         "OFF\n10 3 0\n0 0 0 4 0 0 4 2 0 0 2 0 4 4 0 0 4 0 -1 2 1 3 2 1 3 2 -1 -1 2 -1\n"
         "4 0 1 2 3\n4 3 2 4 5\n4 6 7 8 9\n",
         1,
         0,
         2,
         {0, 2, 0},
         {3, 2, 0}},
        {"a wall whose border winds once under the floor and twice above it: the side between is flat, and left out",
         "OFF\n12 2 0\n1 0 0 3 0 0 3 4 0 1 4 0 -1 2 -3 5 2 -3 5 2 3 -1 2 3 1 2 0 3 2 0 3 2 2 1 2 2\n"
         "4 0 1 2 3\n10 4 5 6 7 4 8 9 10 11 8\n",
         1,
         0,
         1,
         {1, 2, 0},
         {3, 2, 0}},
        {"a floor of one tile that ends there: its border is drawn",
         "OFF\n10 3 0\n0 0 0 4 0 0 4 2 0 0 2 0 -1 2 0 3 2 0 3 2 1 -1 2 1 -1 2 -1 3 2 -1\n"
         "4 0 1 2 3\n4 4 5 6 7\n4 4 5 9 8\n",
         0,
         0,
         0,
         {0},
         {0}},
    };
    const oracle_view view = {.x = 1, .y = -2, .z = 1.5};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        roberts_mesh mesh = mesh_of_text(cases[i].text);
        cross_truth truth;
        assert_true(cross_truth_find(&mesh, &view, false, &truth));
        if (truth.line_count != cases[i].count)
            fail_msg("%s: %zu lines", cases[i].name, truth.line_count);
        if (truth.line_count > 0) {
            assert_true(truth.line[0].on_edge);
            assert_true(truth.line[0].f0 == cases[i].f0 && truth.line[0].f1 == cases[i].f1);
            check_end("a", truth.line[0].a, cases[i].a);
            check_end("b", truth.line[0].b, cases[i].b);
            assert_int_equal(truth.line[0].count, 0);
        }
        cross_truth_free(&truth);
        roberts_mesh_free(&mesh);
    }
}

/* ---- triangles, in another way ---- */

static int64_t volume(whole a, whole b, whole c, whole d)
{
    return whole_dot(whole_sub(b, a), whole_cross(whole_sub(c, a), whole_sub(d, a)));
}

/* Where sides of triangle T pierce triangle S: at most two points. False: something is not in general position. */
static bool piercings(const whole T[3], const whole S[3], double point[][3], size_t *count)
{
    for (int i = 0; i < 3; i++) {
        whole p = T[i], q = T[(i + 1) % 3];
        int64_t hp = volume(S[0], S[1], S[2], p), hq = volume(S[0], S[1], S[2], q);
        int64_t s[3];
        for (int k = 0; k < 3; k++)
            s[k] = volume(p, q, S[k], S[(k + 1) % 3]);
        if (hp == 0 || hq == 0 || s[0] == 0 || s[1] == 0 || s[2] == 0)
            return false;
        if ((hp > 0) == (hq > 0) || (s[0] > 0) != (s[1] > 0) || (s[1] > 0) != (s[2] > 0))
            continue;
        double u = (double)hp / (double)(hp - hq);
        point[*count][0] = (double)p.x + u * (double)(q.x - p.x);
        point[*count][1] = (double)p.y + u * (double)(q.y - p.y);
        point[*count][2] = (double)p.z + u * (double)(q.z - p.z);
        ++*count;
    }
    return true;
}

static whole corner_of(const roberts_mesh *mesh, size_t f, int k)
{
    roberts_vec3 p = mesh->vertex[mesh->corner[mesh->face_start[f] + (uint32_t)k]];
    return (whole){(int64_t)p.x, (int64_t)p.y, (int64_t)p.z};
}

static void test_triangles(void **state)
{
    const oracle_view view = {.x = 1, .y = 2, .z = 3};
    rng d = {17};
    size_t crossed = 0, apart = 0;
    (void)state;
    for (int scene = 0; scene < 60; scene++) {
        roberts_mesh mesh = {0};
        cross_truth truth;
        for (uint32_t i = 0; i < 36; i++) {
            int x = rng_int(&d, 0, 20), y = rng_int(&d, 0, 20);
            mesh_vertex(&mesh, (roberts_vec3){x, y, rng_int(&d, 0, 20)});
            if (i % 3 == 2)
                mesh_face(&mesh, (uint32_t[]){i - 2, i - 1, i}, 3);
        }
        assert_true(cross_truth_find(&mesh, &view, false, &truth));
        for (size_t f = 0; f < 12; f++)
            for (size_t g = f + 1; g < 12; g++) {
                whole T[3], S[3];
                double point[4][3];
                size_t count = 0, lines = 0;
                const cross_line *line = NULL;
                for (int k = 0; k < 3; k++) {
                    T[k] = corner_of(&mesh, f, k);
                    S[k] = corner_of(&mesh, g, k);
                }
                if (!piercings(T, S, point, &count) || !piercings(S, T, point, &count))
                    continue;
                for (size_t i = 0; i < truth.line_count; i++)
                    if (truth.line[i].f0 == f && truth.line[i].f1 == g) {
                        lines++;
                        line = &truth.line[i];
                    }
                assert_true(count == 0 || count == 2);
                assert_int_equal(lines, count / 2);
                crossed += lines;
                apart += !lines;
                if (!line)
                    continue;
                int low = off(line->a, point[0]) < off(line->a, point[1]) ? 0 : 1;
                assert_true(off(line->a, point[low]) < 1e-13 && off(line->b, point[1 - low]) < 1e-13);
                assert_true(line->a.x <= line->b.x);
            }
        cross_truth_free(&truth);
        roberts_mesh_free(&mesh);
    }
    print_message("note: %zu pairs of triangles that cross and %zu that do not\n", crossed, apart);
    assert_true(crossed > 500 && apart > 500);
}

/* ---- the judge ---- */

/* Makes a right table wrong at row i. False: this row cannot be made wrong in this way. */
typedef bool mutate_fn(cross_row *row, size_t *count, size_t i);

static bool drop_row(cross_row *row, size_t *count, size_t i)
{
    memmove(row + i, row + i + 1, (*count - i - 1) * sizeof *row);
    --*count;
    return true;
}

static bool shift_end(cross_row *row, size_t *count, size_t i)
{
    (void)count;
    row[i].p.y +=
        1e-6 * (1 + fabs(row[i].q.x - row[i].p.x) + fabs(row[i].q.y - row[i].p.y) + fabs(row[i].q.z - row[i].p.z));
    return true;
}

static bool shift_cut(cross_row *row, size_t *count, size_t i)
{
    if (i + 1 == *count || row[i].t1 != row[i + 1].t0)
        return false;
    row[i].t1 += 1e-6;
    row[i + 1].t0 += 1e-6;
    double d[3] = {row[i].q.x - row[i].p.x, row[i].q.y - row[i].p.y, row[i].q.z - row[i].p.z};
    double part = 1e-6 / (row[i].t1 - 1e-6 - row[i].t0);
    row[i].q = (roberts_vec3){row[i].q.x + part * d[0], row[i].q.y + part * d[1], row[i].q.z + part * d[2]};
    row[i + 1].p = row[i].q;
    return row[i].t1 < row[i + 1].t1;
}

static bool stop_early(cross_row *row, size_t *count, size_t i)
{
    (void)count;
    row[i].t1 -= 1e-6;
    return row[i].t1 > row[i].t0;
}

static bool swap_class(cross_row *row, size_t *count, size_t i)
{
    (void)count;
    row[i].intersection = false;
    return true;
}

static bool swap_state(cross_row *row, size_t *count, size_t i)
{
    (void)count;
    row[i].visible = !row[i].visible;
    return true;
}

static bool swap_faces(cross_row *row, size_t *count, size_t i)
{
    uint32_t f = row[i].f0;
    (void)count;
    row[i].f0 = row[i].f1;
    row[i].f1 = f;
    return true;
}

static bool change_face(cross_row *row, size_t *count, size_t i)
{
    (void)count;
    row[i].f0 = row[i].f1;
    row[i].f1++;
    return true;
}

static bool change_body(cross_row *row, size_t *count, size_t i)
{
    (void)count;
    row[i].body++;
    return true;
}

static bool turn_row(cross_row *row, size_t *count, size_t i)
{
    roberts_vec3 p = row[i].p;
    (void)count;
    row[i].p = row[i].q;
    row[i].q = p;
    return true;
}

static bool repeat_row(cross_row *row, size_t *count, size_t i)
{
    memmove(row + i + 1, row + i, (*count - i) * sizeof *row);
    ++*count;
    return true;
}

static bool split_row(cross_row *row, size_t *count, size_t i)
{
    repeat_row(row, count, i);
    roberts_vec3 p = row[i].p, q = row[i].q;
    row[i].t1 = row[i + 1].t0 = 0.5 * (row[i].t0 + row[i].t1);
    row[i].q = row[i + 1].p = (roberts_vec3){0.5 * (p.x + q.x), 0.5 * (p.y + q.y), 0.5 * (p.z + q.z)};
    return true;
}

static bool swap_pairs(cross_row *row, size_t *count, size_t i)
{
    if (i + 1 == *count || row[i].f1 == row[i + 1].f1)
        return false;
    cross_row was = row[i];
    row[i] = row[i + 1];
    row[i + 1] = was;
    return true;
}

static bool invent_row(cross_row *row, size_t *count, size_t i)
{
    repeat_row(row, count, i);
    row[i].f0 = row[i].f1 = row[i].f1 + 1;
    return true;
}

static const struct {
    const char *name;
    mutate_fn *mutate;
} mutations[] = {
    {"a row left out", drop_row},
    {"an end off by 1e-6", shift_end},
    {"a cut off by 1e-6", shift_cut},
    {"a row that ends too early by 1e-6", stop_early},
    {"another class", swap_class},
    {"visible for hidden", swap_state},
    {"faces in the wrong order", swap_faces},
    {"another face", change_face},
    {"another body", change_body},
    {"a row from end to start", turn_row},
    {"a row twice", repeat_row},
    {"a row in two", split_row},
    {"rows in the wrong order", swap_pairs},
    {"a row of no line", invent_row},
};

enum { MUTATIONS = sizeof mutations / sizeof mutations[0] };

/* The right table is taken, and each wrong one is refused, on a scene of each family. */
static void test_wrong_tables(void **state)
{
    size_t tried[MUTATIONS] = {0}, scenes = 0;
    FILE *quiet = tmpfile();
    (void)state;
    assert_non_null(quiet);
    for (size_t f = 0; f < mesh_family_count(); f++)
        for (uint64_t seed = 1; seed <= 6; seed++) {
            mesh_scene scene;
            cross_truth truth;
            mesh_total total = {0};
            size_t count;
            assert_true(mesh_family_make(f, seed, &scene));
            assert_true(cross_truth_find(&scene.mesh, &scene.view, scene.even_odd, &truth));
            uint32_t *body = calloc(scene.mesh.face_count, sizeof *body);
            cross_row *row = cross_rows_of_truth(&truth, body, &count);
            cross_row *wrong = malloc((count + 1) * sizeof *wrong);
            assert_true(body && row && wrong);
            const cross_case c = {.scene = &scene, .truth = &truth, .face_body = body, .name = mesh_family_name(f)};
            size_t lines = 0;
            for (size_t i = 0; i < truth.line_count; i++)
                lines += !truth.line[i].edge_on;
            assert_int_equal(cross_judge_rows(&c, row, count, &total, stdout), 0);
            assert_int_equal(total.lines, lines);
            scenes += count > 0;
            for (size_t m = 0; m < MUTATIONS && count; m++)
                for (int again = 0; again < 3; again++) {
                    size_t i = (size_t)rng_next(&(rng){seed * 100 + m + 1000 * (uint64_t)again}) % count, n = count;
                    memcpy(wrong, row, count * sizeof *row);
                    if (!mutations[m].mutate(wrong, &n, i))
                        continue;
                    tried[m]++;
                    if (cross_judge_rows(&c, wrong, n, &total, quiet) == 0)
                        fail_msg("%s, seed %d: %s at row %zu of %zu is not noticed", mesh_family_name(f), (int)seed,
                                 mutations[m].name, i, count);
                }
            free(body);
            free(row);
            free(wrong);
            cross_truth_free(&truth);
            mesh_scene_free(&scene);
        }
    fclose(quiet);
    print_message("note: %d kinds of wrong tables refused on %zu scenes\n", (int)MUTATIONS, scenes);
    for (size_t m = 0; m < MUTATIONS; m++)
        if (tried[m] <= 20)
            fail_msg("%s: only tried %zu times", mutations[m].name, tried[m]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_by_hand),   cmocka_unit_test(test_cube_in_cube), cmocka_unit_test(test_on_edges),
        cmocka_unit_test(test_triangles), cmocka_unit_test(test_wrong_tables),
    };
    return cmocka_run_group_tests_name("oracle of intersection lines", tests, NULL, NULL);
}
